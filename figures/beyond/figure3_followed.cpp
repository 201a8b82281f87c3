// What lies behind Figure 3.
//
// figure3_orbits.csv           from rest: period, impacts, complete chatters, Lyapunov exponent
// figure3_up.csv, .._down.csv  of mass 1, the motion followed upwards and downwards
#include <exception>
#include <thread>

#include "figures/driver.hpp"
#include "figures/figure3.hpp"

namespace {

using namespace vibro_impact;

// Both ways at once: each goes from frequency to frequency. An error of either is thrown.
std::array<figures::Diagram, 2> both_ways(const std::vector<double> &omegas,
                                          const RecordOptions &options,
                                          const std::function<void()> &advance) {
  std::array<figures::Diagram, 2> diagrams;
  std::array<std::exception_ptr, 2> failures;
  const auto follow = [&](std::size_t way, const std::vector<double> &along) {
    try {
      diagrams[way] = figures::diagram_followed(along, options, advance);
    } catch (...) {
      failures[way] = std::current_exception();
    }
  };
  std::thread downwards(follow, 1, std::vector<double>(omegas.rbegin(), omegas.rend()));
  follow(0, omegas);
  downwards.join();
  for (const std::exception_ptr &failure : failures)
    if (failure) std::rethrow_exception(failure);
  return diagrams;
}

void draw(const std::filesystem::path &output) {
  const std::vector<double> omegas = figures::frequencies_of_figure3(1801);
  Progress progress("figure 3, followed", 3.0 * static_cast<double>(omegas.size()));
  RecordOptions options = figures::recorded_in_figure3(40);
  options.lyapunov = true;
  SweepOptions sweeping;
  sweeping.progress = [&](std::size_t done) { progress.reach(static_cast<double>(done)); };
  write(figures::diagram_from_rest(omegas, options, sweeping).orbits,
        output / "figure3_orbits.csv");
  options.lyapunov = false;
  options.settle.longest = 150;  // from nearby
  const auto [up, down] = both_ways(omegas, options, [&] { progress.advance(); });
  write(up.velocities[0], output / "figure3_up.csv");
  write(down.velocities[0], output / "figure3_down.csv");
}

}  // namespace

int main(int argc, char **argv) {
  return vibro_impact::figures::drive(
      argc, argv, "Figure 3 with the motion followed, impacts per period and exponents", draw);
}
