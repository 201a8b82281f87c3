// The bifurcation points of Sections 3.2 and 3.3: multi-sliding, border orbits, grazing.
//
// bifurcations.csv        the points, each found in two ways
// bifurcations_scan.csv   sticking phases per four periods on a grid of frequencies: from rest, and
//                         following the motion upwards and downwards
// bifurcations_5b.csv     impact speed of mass 2 in the Figure 5(b) scene, likewise
#include "bifurcations.hpp"

#include "figures/driver.hpp"

namespace {

using namespace vibro_impact;

std::vector<double> frequencies(double from, double width, int intervals) {
  std::vector<double> omegas;
  for (int i = 0; i <= intervals; ++i) omegas.push_back(from + width * i / intervals);
  return omegas;
}

// What `read(scene, state)` makes of the motion at every frequency: from rest, and following it
// upwards and downwards, from the motion at the frequency before. It may carry the state on by
// whole periods.
template <class SceneAt, class Read>
auto three_ways(const std::vector<double> &omegas, const SceneAt &scene_at, const Read &read) {
  constexpr int periods = 60;  // to settle at every frequency of a branch
  using Values = std::vector<decltype(read(Scene{}, std::declval<MotionState &>()))>;
  std::array<Values, 3> ways;
  ways.fill(Values(omegas.size()));
  auto &[rest, up, down] = ways;
  const auto follow = [&](auto omega, const auto &last, auto value) {
    MotionState state = state_after_periods(scene_at(*omega), figures::settling);
    for (; omega != last; ++omega, ++value) {
      const Scene scene = scene_at(*omega);
      state = stroboscopic_map(scene, state, periods).state;
      *value = read(scene, state);
    }
  };
  follow(omegas.begin(), omegas.end(), up.begin());
  follow(omegas.rbegin(), omegas.rend(), down.rbegin());
  figures::in_parallel(omegas.size(), [&](std::size_t i) {
    const Scene scene = scene_at(omegas[i]);
    MotionState state = state_after_periods(scene, figures::settling);
    rest[i] = read(scene, state);
  });
  return ways;
}

// The table of points. All numbers in it are computed; the error is the largest of the
// estimate of the method, the distance between the two methods, and what rounding over one period
// does to either.
Table bifurcation_table(const std::vector<figures::BifurcationPoint> &points) {
  Table table("symbol,value,kind,error,method,check,checked_by");
  for (const figures::BifurcationPoint &point : points)
    table.row(point.symbol, point.omega.value, "computed",
              std::max({point.omega.error, std::abs(point.omega.value - point.check), 2e-15}),
              point.method, point.check, point.checked_by);
  return table;
}

void draw(const std::filesystem::path &output) {
  Progress progress("bifurcations", 4);
  const std::vector<double> omegas = frequencies(0.25, 0.25, 2000);
  const auto sticks = three_ways(omegas, paper::stops_of_different_sign, figures::sticks_in);
  Table scan("omega,rest_1,rest_2,up_1,up_2,down_1,down_2");
  for (std::size_t i = 0; i < omegas.size(); ++i) {
    const auto &[rest, up, down] = sticks;
    scan.row(omegas[i], rest[i][0], rest[i][1], up[i][0], up[i][1], down[i][0], down[i][1]);
  }
  progress.advance();
  const std::vector<double> near_grazing = frequencies(0.299514, 8e-6, 160);
  const auto speeds = three_ways(near_grazing, figures::figure5b_at, figures::last_speed);
  Table branches("omega,rest,up,down");
  for (std::size_t i = 0; i < near_grazing.size(); ++i)
    branches.row(near_grazing[i], speeds[0][i], speeds[1][i], speeds[2][i]);
  progress.advance();
  auto points = figures::locate_all(omegas, sticks[0]);
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
  write(bifurcation_table(points), output / "bifurcations.csv");
}

}  // namespace

int main(int argc, char **argv) {
  return figures::drive(argc, argv, "Bifurcation points for forcing frequencies from 0.25 to 0.5",
                        draw);
}
