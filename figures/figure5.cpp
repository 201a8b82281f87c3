// Figure 5: two nonsmooth events at a time (Table I of the paper).
#include "driver.hpp"

namespace {

vibro_impact::Table displacements(const vibro_impact::Scene &scene,
                                  const vibro_impact::paper::AxisBox &box, double every) {
  using namespace vibro_impact;
  SampleRecorder samples = figures::samples_across(box, every);
  require_complete(simulate(scene, samples.to, figures::all_visible_chatter(), samples));
  return figures::displacement_table(samples);
}

}  // namespace

int main(int argc, char **argv) {
  using namespace vibro_impact;
  return figures::drive(
      argc, argv, "Figure 5: sticking-impact, grazing-sticking, close to dual sticking",
      [](const std::filesystem::path &output) {
        using namespace paper;
        write(displacements(figure5a(), figure5a_box, 0.001), output / "figure5a.csv");
        write(displacements(figure5b(), figure5b_box, 0.001), output / "figure5b.csv");
        write(displacements(figure5c(), figure5c_box, 0.005), output / "figure5c.csv");
      });
}
