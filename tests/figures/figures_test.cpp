// The drivers of Figures 2, 4 and 5 and their scripts: the tables against the 50-digit events
// and what the paper says, and every panel drawn against its table, the printed axes and the
// colours.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "reference/numbers/checked_number.hpp"
#include "tests/support/panels.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;
using paper::AxisBox;

// The samples of both masses in a window are the motion with the true events: at an impact a mass
// is where its stop is, to within how far it moves between samples, and while it sticks, exactly.
void expect_motion(Columns &columns, const std::string &truth, const AxisBox &box) {
  const Scene scene = paper::scene_named(truth).scene;
  const std::vector<double> &t = columns["t"];
  ASSERT_GT(t.size(), 1000u);
  EXPECT_EQ(t.front(), box.from);
  EXPECT_NEAR(t.back(), box.to, 1e-9);
  const double every = t[1] - t[0];
  const std::vector<Event> events = true_events(truth);
  int compared = 0;
  for (const int mass : {1, 2}) {
    const std::vector<double> &x = columns["x" + std::to_string(mass)];
    const double stop = stop_position(scene, mass);
    ASSERT_EQ(x.size(), t.size());
    std::size_t next = 0;  // the first event after the sample
    for (std::size_t i = 0; i < t.size(); ++i) {
      for (; next < events.size() && events[next].time <= t[i]; ++next) {
        const Event &event = events[next];
        if (event.mass != mass || event.kind != EventKind::impact || event.time < box.from)
          continue;
        ++compared;
        EXPECT_NEAR(x[i], stop, every * std::abs(event.velocity_before) + every * every) << t[i];
      }
      if (next == 0 || !holds(events[next - 1].held, mass)) continue;
      ++compared;
      EXPECT_EQ(x[i], stop) << "mass " << mass << " at " << t[i];
    }
  }
  EXPECT_GT(compared, 10);
}

// A line across the panel at this height, in the colour of stops and zero lines.
void expect_level(const Curve &curve, double height) {
  EXPECT_EQ(curve.colour, colour_of_line_type(3));
  ASSERT_FALSE(curve.points.empty());
  for (const Point &point : curve.points) ASSERT_NEAR(point[1], height, 1e-9);
}

// The parameters of the scene stand above the panel. `inferred` names those that the paper's text
// does not give.
void expect_parameters(const Panel &panel, const Scene &scene, const std::string &inferred) {
  const auto known = [&](const std::string &name, double value) {
    const bool given = inferred.find(name) == std::string::npos;
    return fmt::format("{} = {:g}{}", name, value, given ? "" : " (inferred)");
  };
  const double s1 = scene.stops[0].position, s2 = scene.stops[1].position;
  const std::string stops =
      s1 == s2 ? known("s₁ = s₂", s1) : known("s₁", s1) + ",  " + known("s₂", s2);
  const std::string heading =
      known("Ω", scene.omega) + ",  " + known("r", scene.restitution) + ",  " + stops;
  EXPECT_EQ(std::count(panel.texts.begin(), panel.texts.end(), heading), 1) << heading;
}

// Whether the mass sticks at some time within the window.
bool sticks_within(const std::string &truth, int mass, const AxisBox &box) {
  const std::vector<Event> events = true_events(truth);
  for (std::size_t i = 0; i < events.size() && events[i].time < box.to; ++i)
    if (holds(events[i].held, mass) && i + 1 < events.size() && events[i + 1].time > box.from)
      return true;
  return false;
}

// A bar stands at the stop for as long as the mass sticks: at the samples that are exactly there.
void expect_bar(const Curve &curve, Columns &columns, int mass, double stop, bool sticks) {
  const std::vector<double> &x = columns["x" + std::to_string(mass)];
  std::vector<double> times;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (x[i] == stop) times.push_back(columns["t"][i]);
  EXPECT_EQ(times.empty(), !sticks);
  expect_points(curve, times, std::vector<double>(times.size(), stop));
  if (sticks) {
    EXPECT_EQ(curve.colour, colour_of_line_type(7));
  }
}

// A panel is drawn from the motion with the true events. It has the stops of the scene within its
// axes, bars where these masses stick, and the displacements of these masses, each in its own
// colour and under no other name. `further` curves follow.
void expect_displacements(const Panel &panel, const std::string &table, const std::string &truth,
                          const std::vector<int> &sticking, const std::vector<int> &masses = {1, 2},
                          std::size_t further = 0) {
  SCOPED_TRACE(table);
  const AxisBox box = paper::panel(table);
  auto columns = columns_of(folder_of(table.substr(0, 7)) + "/" + table + ".csv");
  expect_motion(columns, truth, box);
  std::set<double> stops;
  const Scene scene = paper::scene_named(truth).scene;
  for (const Stop &stop : scene.stops)
    if (stop.position > box.lowest) stops.insert(stop.position);
  ASSERT_EQ(panel.curves.size(), stops.size() + sticking.size() + masses.size() + further);
  expect_axes(panel, table.back(), box, stops.size(), stops_hit(truth, box, masses));
  std::size_t next = 0;
  for (const double stop : stops) expect_level(panel.curves[next++], stop);
  for (const int mass : sticking)
    expect_bar(panel.curves[next++], columns, mass, stop_position(scene, mass),
               sticks_within(truth, mass, box));
  for (const int number : masses) {
    const Curve &curve = panel.curves[next++];
    const std::string mass = std::to_string(number);
    expect_points(curve, columns["t"], columns["x" + mass]);
    EXPECT_EQ(curve.colour, colour_of_line_type(number));
    EXPECT_TRUE(curve.title.empty() || curve.title == "mass " + mass) << curve.title;
  }
}

TEST(Figure2, IsDrawnFromTheMotionOfItsScene) {
  const auto panels = drawn("figure2", folder_of("figure2"));
  ASSERT_EQ(panels.size(), 2u);
  EXPECT_NE(colour_of_line_type(1), colour_of_line_type(2));
  expect_displacements(panels[0], "figure2a", "figure2", {1, 2});
  expect_displacements(panels[1], "figure2b", "figure2", {2}, {2});
  expect_parameters(panels[0], paper::figure2(), "Ω");
}

// The points are the true impacts of mass 2 within the window: at its stop, or as high as they are
// fast.
void expect_impacts_of_mass_2(const Curve &curve, const std::string &figure, bool at_stop) {
  std::vector<double> times, heights;
  for (const Event &event : select(true_events(figure), EventKind::impact, 2)) {
    if (event.time < paper::panel(figure).from) continue;
    times.push_back(event.time);
    heights.push_back(at_stop ? stop_position(paper::scene_named(figure).scene, 2)
                              : std::abs(event.velocity_before));
  }
  EXPECT_GT(times.size(), 1u);
  expect_points(curve, times, heights);
  EXPECT_EQ(curve.colour, colour_of_line_type(2));
}

TEST(Figure5, IsDrawnFromTheMotionsOfItsScenes) {
  const auto panels = drawn("figure5", folder_of("figure5"));
  ASSERT_EQ(panels.size(), 5u) << "three panels and two insets";
  expect_displacements(panels[0], "figure5a", "figure5a", {1}, {1, 2}, 1);
  expect_displacements(panels[1], "figure5b", "figure5b", {1}, {1, 2}, 1);
  expect_displacements(panels[2], "figure5c", "figure5c", {1}, {1, 2}, 1);
  expect_parameters(panels[0], paper::figure5a(), "Ω");
  expect_parameters(panels[1], paper::figure5b(), "Ω s₁");
  expect_parameters(panels[2], paper::figure5c(), "s₁ = s₂");

  // Inset of (b): 10^5 (x2 - s2). The samples are 0.001 apart, and x2'' is -0.3 there: the highest
  // of them is at most 0.004 below the maximum.
  ASSERT_EQ(panels[3].curves.size(), 2u);
  double highest = -1e9;
  for (const Point &point : panels[3].curves[1].points) highest = std::max(highest, point[1]);
  for (const auto &number : numbers::checked_numbers(REFERENCE_DIR))
    if (number.id == "figure5b_nearest_gap") {
      EXPECT_NEAR(highest, -1e5 * number.value, 0.004);
    }

  // Dots in (a): the impacts of mass 2. Inset of (c): the speeds of those, down to the release of
  // mass 1, up to which its bar reaches.
  expect_impacts_of_mass_2(panels[0].curves.back(), "figure5a", true);
  ASSERT_EQ(panels[4].curves.size(), 2u);
  expect_impacts_of_mass_2(panels[4].curves[1], "figure5c", false);
  const double released = panels[4].curves[0].points.back()[0];
  const auto releases = select(true_events("figure5c"), EventKind::release, 1);
  EXPECT_NEAR(released, releases.back().time, 0.006) << "samples are 0.005 apart";
  EXPECT_GT(panels[4].curves[1].points.back()[0], released - 4.0) << "printed: still chattering";
}

// The sticking phases of mass 1 in the last forcing period of the 50-digit run, as times within
// the period: by then (30 periods) the motion has settled to rounding.
std::vector<Point> true_phases(const std::string &scene, double omega) {
  const double period = Clock(omega).period;
  const std::vector<Event> events = true_events(scene);
  const double begin = (std::floor(events.back().time / period) - 1.0) * period;
  std::vector<Point> phases;
  for (const Event &event : events) {
    const double within = event.time - begin;
    if (event.mass != 1 || within < 0.0 || within > period) continue;
    if (event.kind == EventKind::stick) phases.push_back({within, 0.0});
    if (event.kind == EventKind::release) phases.back()[1] = within;
  }
  return phases;
}

TEST(Figure4, IsDrawnFromTheHoldForceInEveryStickingPhase) {
  const auto panels = drawn("figure4", folder_of("figure4"));
  ASSERT_EQ(panels.size(), 4u) << "two panels and two insets";
  expect_parameters(panels[0], paper::figure4a(), "");
  expect_parameters(panels[1], paper::figure4b(), "");
  // Inset: 10^5 times the force at the bifurcation touches zero. The samples are 0.001 apart, and
  // the second derivative of the force is -0.11.
  ASSERT_EQ(panels[2].curves.size(), 3u);
  Point highest{0.0, -1e9};
  for (const Point &point : panels[2].curves[2].points)
    if (point[0] > 13.5 && point[0] < 14.8 && point[1] > highest[1]) highest = point;
  EXPECT_NEAR(highest[0], 14.173, 0.001);
  EXPECT_NEAR(highest[1], 0.0, 0.002);
  for (const std::size_t k : {0u, 1u}) {
    const std::string name = k == 0 ? "figure4a" : "figure4b";
    SCOPED_TRACE(name);
    auto columns = columns_of(folder_of("figure4") + "/" + name + ".csv");
    const auto phases =
        true_phases(name, k == 0 ? paper::figure4a().omega : paper::figure4b().omega);
    ASSERT_EQ(phases.size(), k + 1);  // printed: the phase is split in two
    const AxisBox box = paper::panel("figure4");
    expect_axes(panels[k], name.back(), box, 1);
    ASSERT_EQ(panels[k].curves.size(), 2 + phases.size()) << "every phase and the gap is drawn";
    expect_level(panels[k].curves[0], 0.0);
    EXPECT_TRUE(
        figures::fills({phases.front()[0], phases.back()[1]}, {box.from, box.to}, box.tick_across));
    for (std::size_t phase = 0; phase < phases.size(); ++phase) {
      std::vector<double> t, force;
      for (std::size_t i = 0; i < columns["t"].size(); ++i)
        if (columns["phase"][i] == static_cast<double>(phase + 1)) {
          t.push_back(columns["t"][i]);
          force.push_back(columns["F2"][i]);
          EXPECT_LE(force.back(), 0.0) << "printed: the force holds mass 1 to a lower stop";
          if (std::abs(t.back() - 14.173) < 1e-3) {
            EXPECT_GT(force.back(), -1e-4) << "printed: the force all but touches zero";
          }
        }
      ASSERT_FALSE(t.empty());
      EXPECT_NEAR(t.front(), phases[phase][0], 1e-8);
      EXPECT_NEAR(t.back(), phases[phase][1], 1e-8);
      EXPECT_EQ(force.back(), 0.0) << "released at a root of the force";
      expect_points(panels[k].curves[1 + phase], t, force);
      EXPECT_EQ(panels[k].curves[1 + phase].colour, colour_of_line_type(1));
    }
  }
}

// Between the two phases of (b), the force as if held goes on where the hold force ends, and ends
// where the next hold force begins: at a release at a root and at the end of a chatter of mass 1,
// the motion of mass 2 does not jump. In between it pulls mass 1 off its lower stop.
TEST(Figure4, TheForceAsIfHeldJoinsTheStickingPhases) {
  const auto panels = drawn("figure4", folder_of("figure4_free"));
  ASSERT_EQ(panels.size(), 4u);
  ASSERT_EQ(panels[1].curves.size(), 4u);
  EXPECT_TRUE(panels[0].curves.back().points.empty()) << "in (a) mass 1 sticks once";
  const std::vector<Point> &first = panels[1].curves[1].points,
                           &second = panels[1].curves[2].points, &free = panels[1].curves[3].points;
  ASSERT_GT(free.size(), 600u);
  EXPECT_EQ(columns_of(folder_of("figure4_free") + "/figure4b_free.csv")["F2"].size(), free.size());
  // The samples are 0.001 apart, and the force changes by at most 0.05 per unit of time there.
  EXPECT_NEAR(free.front()[0], first.back()[0], 0.001);
  EXPECT_NEAR(free.front()[1], first.back()[1], 5e-5);
  EXPECT_NEAR(free.back()[0], second.front()[0], 0.001);
  EXPECT_NEAR(free.back()[1], second.front()[1], 5e-5);
  const Point highest = *std::max_element(
      free.begin(), free.end(), [](const Point &a, const Point &b) { return a[1] < b[1]; });
  EXPECT_NEAR(highest[0], 14.173, 0.01) << "where the force of (a) turns back";
  EXPECT_GT(highest[1], 6e-4) << "it grows by 7 per unit of the frequency";
  // The inset shows the same, 10^3 times.
  ASSERT_EQ(panels[3].curves.size(), 3u);
  for (const Point &point : panels[3].curves[2].points)
    EXPECT_LE(point[1], 1e3 * highest[1] + 1e-5);
  EXPECT_FALSE(panels[3].curves[2].points.empty());
}

}  // namespace
