// Figure 3: impact velocities of both masses against the forcing frequency.
//
// figure3a.csv, figure3b.csv   from rest, as in the paper
// figure3_orbits.csv           from rest: period, impacts, complete chatters, Lyapunov exponent
// figure3_up.csv, .._down.csv  of mass 1, the motion followed upwards and downwards
#include "figure3.hpp"

#include <exception>
#include <thread>

#include "driver.hpp"

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
  const auto points = static_cast<double>(omegas.size());
  Progress progress("figure 3", 3.0 * points);
  RecordOptions options = figures::recorded_in_figure3(40);
  SweepOptions sweeping;
  sweeping.progress = [&](std::size_t done) { progress.reach(static_cast<double>(done)); };
  const figures::Diagram rest = [&] {
    RecordOptions with_exponent = options;
    with_exponent.lyapunov = true;
    return figures::diagram_from_rest(omegas, with_exponent, sweeping);
  }();
  options.settle.longest = 150;  // from nearby
  const auto [up, down] = both_ways(omegas, options, [&] { progress.advance(); });
  write(rest.velocities[0], output / "figure3a.csv");
  write(rest.velocities[1], output / "figure3b.csv");
  write(rest.orbits, output / "figure3_orbits.csv");
  write(up.velocities[0], output / "figure3_up.csv");
  write(down.velocities[0], output / "figure3_down.csv");
}

}  // namespace

int main(int argc, char **argv) {
  return vibro_impact::figures::drive(
      argc, argv, "Figure 3: impact velocities against forcing frequency", draw);
}
