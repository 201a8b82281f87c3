// The multi-sliding bifurcation of Figure 4 at its located frequency: the hold force on mass 1 just
// before, at and just after it.
#include "figures/beyond/bifurcations.hpp"
#include "figures/driver.hpp"
#include "figures/panel.hpp"

int main(int argc, char **argv) {
  using namespace vibro_impact;
  return figures::drive(
      argc, argv, "The hold force on mass 1 before, at and after the multi-sliding bifurcation",
      [](const std::filesystem::path &output) {
        const auto changes = figures::changes_between(1, 0.256, 0.2561);
        const auto found = figures::multi_sliding(changes.at(0), 1);
        if (!found)
          throw std::runtime_error("no multi-sliding bifurcation between 0.256 and 0.2561");
        Table omegas("omega,error,checked_by_counting");
        omegas.row(found->value, found->error, changes.front().below);
        write(omegas, output / "multi_sliding.csv");
        for (const auto &[when, omega] :
             {std::pair{"before", 0.256}, {"at", found->value}, {"after", 0.2561}})
          write(figures::hold_force(paper::stops_of_different_sign(omega)),
                output / fmt::format("multi_sliding_{}.csv", when));
      });
}
