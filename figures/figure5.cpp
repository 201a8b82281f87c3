// Figure 5: two nonsmooth events at a time (Table I of the paper).
#include "driver.hpp"
#include "measures/runs.hpp"

int main(int argc, char **argv) {
  using namespace vibro_impact;
  return figures::main_of_driver(
      argc, argv, "Figure 5: sticking-impact, grazing-sticking, close to dual sticking",
      [](const std::filesystem::path &output) {
        using namespace paper;
        using figures::displacements;
        write(figures::parameters({figure5a(), figure5b(), figure5c()}),
              output / "figure5_scenes.csv");
        write(displacements(figure5a(), panel("figure5a"), 0.001), output / "figure5a.csv");
        write(displacements(figure5b(), panel("figure5b"), 0.001), output / "figure5b.csv");
        write(displacements(figure5c(), panel("figure5c"), 0.005), output / "figure5c.csv");
        write(figures::impacts(figure5a(), panel("figure5a")), output / "figure5a_impacts.csv");
        write(figures::impacts(figure5c(), panel("figure5c")), output / "figure5c_impacts.csv");
      });
}
