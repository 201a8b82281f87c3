// Figure 3: impact velocities of both masses against the forcing frequency, each from rest.
#include "figure3.hpp"

#include "driver.hpp"

int main(int argc, char **argv) {
  using namespace vibro_impact;
  return figures::drive(argc, argv, "Figure 3: impact velocities against forcing frequency",
                        [](const std::filesystem::path &output) {
                          const std::vector<double> omegas = figures::frequencies_of_figure3(1801);
                          Progress progress("figure 3", static_cast<double>(omegas.size()));
                          const figures::Diagram rest =
                              figures::diagram_from_rest(omegas, figures::recorded_in_figure3(40),
                                                         [&] { progress.advance(); });
                          write(rest.velocities[0], output / "figure3a.csv");
                          write(rest.velocities[1], output / "figure3b.csv");
                        });
}
