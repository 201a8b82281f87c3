// Figure 2: chatter and sticking of both masses once per forcing period, and mass 2's chatter close
// up.
#include "driver.hpp"
#include "measures/runs.hpp"

int main(int argc, char **argv) {
  using namespace vibro_impact;
  return figures::main_of_driver(
      argc, argv, "Figure 2: displacement of both masses", [](const std::filesystem::path &output) {
        using namespace paper;
        write(figures::parameters({figure2()}), output / "figure2_scenes.csv");
        write(figures::displacements(figure2(), panel("figure2a"), 0.005), output / "figure2a.csv");
        write(figures::displacements(figure2(), panel("figure2b"), 0.0005),
              output / "figure2b.csv");
      });
}
