// Figure 3: impact velocities of both masses against the forcing frequency.
#include "figure3.hpp"

#include <omp.h>

#include "driver.hpp"

int main(int argc, char **argv) {
  using namespace vibro_impact;
  return figures::drive(argc, argv, "Figure 3: impact velocities against forcing frequency",
                        [](const std::filesystem::path &output) {
                          const std::vector<double> omegas = figures::frequencies_of_figure3(1801);
                          const int periods = 40;
                          Progress progress("figure 3", static_cast<double>(omegas.size()));
                          const auto [v1, v2] = figures::bifurcation_diagrams(
                              omegas, periods, omp_get_max_threads(), [&] { progress.advance(); });
                          write(v1, output / "figure3a.csv");
                          write(v2, output / "figure3b.csv");
                        });
}
