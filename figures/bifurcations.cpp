// The bifurcation points of Sections 3.2 and 3.3: multi-sliding, border orbits, grazing.
//
// bifurcations.csv        the points, each found in two ways
// bifurcations_scan.csv   sticking phases per four periods on a grid of frequencies: from rest, and
//                         following the motion upwards and downwards
#include "bifurcations.hpp"

#include "driver.hpp"

int main(int argc, char **argv) {
  using namespace vibro_impact;
  return figures::drive(
      argc, argv, "Bifurcation points for forcing frequencies from 0.25 to 0.5",
      [](const std::filesystem::path &output) {
        constexpr int threads = 2;
        const std::vector<double> omegas = figures::sticking_grid(2000);
        const std::vector<double> downwards(omegas.rbegin(), omegas.rend());
        figures::Progress progress("bifurcations", 5);
        const figures::Counts rest = figures::scan_from_rest(omegas, threads);
        progress.advance();
        const figures::Counts up = figures::scan_following(omegas, 60);
        progress.advance();
        const figures::Counts down = figures::scan_following(downwards, 60);
        progress.advance();
        Table scan("omega,rest_1,rest_2,up_1,up_2,down_1,down_2");
        for (std::size_t i = 0; i < omegas.size(); ++i) {
          const auto &fallen = down[omegas.size() - 1 - i];
          scan.row(omegas[i], rest[i][0], rest[i][1], up[i][0], up[i][1], fallen[0], fallen[1]);
        }
        auto points = figures::locate_all(omegas, rest, threads);
        progress.advance();
        // Both masses stick for the last time below 0.5 at the last border orbit.
        points.push_back(points.back());
        points.back().symbol = "no_sticking_above";
        points.push_back(figures::grazing());
        points.push_back(figures::end_of_impacting_motion());
        progress.advance();
        write(scan, output / "bifurcations_scan.csv");
        write(figures::bifurcation_table(points), output / "bifurcations.csv");
      });
}
