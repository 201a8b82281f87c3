// The bifurcation points of Sections 3.2 and 3.3: multi-sliding, border orbits, grazing.
//
// bifurcations.csv        the points, each found in two ways
// bifurcations_scan.csv   sticking phases per four periods on a grid of frequencies: from rest, and
//                         following the motion upwards and downwards
// bifurcations_5b.csv     impact speed of mass 2 in the Figure 5(b) scene, likewise
#include "bifurcations.hpp"

#include "figures/driver.hpp"
#include "grazing.hpp"

namespace {

using namespace vibro_impact;

// `scan` on the frequencies in falling order, given back in rising order.
template <class Scan>
auto downwards(const std::vector<double> &omegas, Scan &&scan) {
  auto values = scan(std::vector<double>(omegas.rbegin(), omegas.rend()));
  std::reverse(values.begin(), values.end());
  return values;
}

void draw(const std::filesystem::path &output) {
  constexpr int settling = 60;  // periods at every frequency of a branch
  Progress progress("bifurcations", 6);
  const std::vector<double> omegas = figures::sticking_grid(2000);
  const auto followed = [](const auto &grid) {
    return figures::along_branch(grid, paper::stops_of_different_sign, settling,
                                 figures::sticks_in);
  };
  const figures::Counts rest = figures::scan_from_rest(omegas);
  progress.advance();
  const figures::Counts up = followed(omegas);
  progress.advance();
  const figures::Counts down = downwards(omegas, followed);
  progress.advance();
  Table scan("omega,rest_1,rest_2,up_1,up_2,down_1,down_2");
  for (std::size_t i = 0; i < omegas.size(); ++i)
    scan.row(omegas[i], rest[i][0], rest[i][1], up[i][0], up[i][1], down[i][0], down[i][1]);

  std::vector<double> near_grazing;
  for (int i = 0; i <= 160; ++i) near_grazing.push_back(0.299514 + 5e-8 * i);
  const auto speeds = [](const auto &grid) {
    return figures::along_branch(grid, figures::figure5b_at, settling, figures::last_speed);
  };
  const auto speed_up = speeds(near_grazing), speed_down = downwards(near_grazing, speeds);
  Table branches("omega,rest,up,down");
  for (std::size_t i = 0; i < near_grazing.size(); ++i) {
    const Scene scene = figures::figure5b_at(near_grazing[i]);
    MotionState from_rest = settled(scene, figures::settling);
    branches.row(near_grazing[i], figures::last_speed(scene, from_rest), speed_up[i],
                 speed_down[i]);
  }
  progress.advance();

  auto points = figures::locate_all(omegas, rest);
  progress.advance();
  // Both masses stick for the last time below 0.5 at the last border orbit.
  points.push_back(points.back());
  points.back().symbol = "no_sticking_above";
  points.push_back(figures::grazing());
  points.push_back(figures::impacts_from_rest());
  points.push_back(figures::end_of_impacts());
  progress.advance();
  write(scan, output / "bifurcations_scan.csv");
  write(branches, output / "bifurcations_5b.csv");
  write(figures::bifurcation_table(points), output / "bifurcations.csv");
}

}  // namespace

int main(int argc, char **argv) {
  return figures::drive(argc, argv, "Bifurcation points for forcing frequencies from 0.25 to 0.5",
                        draw);
}
