// What lies behind Figure 3.
//
// figure3_orbits.csv           from rest: period, impacts, complete chatters, Lyapunov exponent
// figure3_up.csv, .._down.csv  of mass 1, the motion followed upwards and downwards
#include "figures/driver.hpp"
#include "figures/figure3.hpp"
#include "figures/parallel.hpp"

namespace {

using namespace vibro_impact;

void draw(const std::filesystem::path &output) {
  const std::vector<double> omegas = figures::frequencies_of_figure3(1801);
  Progress progress("figure 3, followed", 3.0 * static_cast<double>(omegas.size()));
  RecordOptions options = figures::recorded_in_figure3(40);
  options.lyapunov = true;
  const auto advance = [&] { progress.advance(); };
  write(figures::diagram_from_rest(omegas, options, advance).orbits, output / "figure3_orbits.csv");
  options.lyapunov = false;
  options.settle.longest = 150;          // from nearby
  std::array<figures::Diagram, 2> ways;  // both at once: each goes from frequency to frequency
  figures::in_parallel(ways.size(), [&](std::size_t way) {
    const auto along = way == 0 ? omegas : std::vector<double>(omegas.rbegin(), omegas.rend());
    ways[way] = figures::diagram_followed(along, options, advance);
  });
  write(ways[0].velocities[0], output / "figure3_up.csv");
  write(ways[1].velocities[0], output / "figure3_down.csv");
}

}  // namespace

int main(int argc, char **argv) {
  return vibro_impact::figures::drive(
      argc, argv, "Figure 3 with the motion followed, impacts per period and exponents", draw);
}
