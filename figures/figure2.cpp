// Figure 2: chatter and sticking of both masses once per forcing period, and mass 2's chatter close
// up.
#include "driver.hpp"

int main(int argc, char **argv) {
  using namespace vibro_impact;
  return figures::drive(
      argc, argv, "Figure 2: displacement of both masses", [](const std::filesystem::path &output) {
        SampleRecorder a = figures::samples_across(paper::figure2a_box, 0.005);
        SampleRecorder b = figures::samples_across(paper::figure2b_box, 0.0005);
        require_complete(simulate(paper::figure2(), a.to, figures::all_visible_chatter(), a, b));
        write(figures::displacement_table(a), output / "figure2a.csv");
        write(figures::displacement_table(b), output / "figure2b.csv");
      });
}
