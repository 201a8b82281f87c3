// The drivers of Figures 2 to 5 and their scripts: the tables against the 50-digit events and what
// the paper says, and every panel drawn against its table, the printed axes and the colours.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "figures/event_tables.hpp"
#include "figures/figure3.hpp"
#include "figures/inferred_frequencies.hpp"
#include "figures/printed.hpp"
#include "reference/paper_scenes.hpp"
#include "tests/figures/drawn.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;
using figures::TrueEvent;
using paper::AxisBox;

// The folder of a figure's tables, one per figure: several tests run at once.
std::string folder_of(const std::string &figure) {
  return ::testing::TempDir() + "vibro_impact_" + figure;
}

std::vector<TrueEvent> true_events(const std::string &scene) {
  return figures::read_event_table(REFERENCE_DIR "/" + scene + "_events.csv");
}

bool holds(const std::string &contact_mode, int mass) {
  return contact_mode.find(std::to_string(mass)) != std::string::npos;
}

// The samples of both masses in a window are the motion with the true events: at an impact a mass
// is where its stop is, to within how far it moves between samples, and while it sticks, exactly.
void expect_motion(Columns &columns, const std::string &truth, const AxisBox &box) {
  const Scene scene = paper::scene_named(truth).scene;
  const std::vector<double> &t = columns["t"];
  ASSERT_GT(t.size(), 1000u);
  EXPECT_EQ(t.front(), box.from);
  EXPECT_NEAR(t.back(), box.to, 1e-9);
  const double every = t[1] - t[0];
  const std::vector<TrueEvent> events = true_events(truth);
  int compared = 0;
  for (const int mass : {1, 2}) {
    const std::vector<double> &x = columns["x" + std::to_string(mass)];
    const double stop = scene.stops[static_cast<std::size_t>(mass - 1)].position;
    ASSERT_EQ(x.size(), t.size());
    std::size_t next = 0;  // the first event after the sample
    for (std::size_t i = 0; i < t.size(); ++i) {
      for (; next < events.size() && events[next].time <= t[i]; ++next) {
        const TrueEvent &event = events[next];
        if (event.mass != mass || event.event != "impact" || event.time < box.from) continue;
        ++compared;
        EXPECT_NEAR(x[i], stop, every * std::abs(event.velocity_before) + every * every) << t[i];
      }
      if (next == 0 || !holds(events[next - 1].contact_mode, mass)) continue;
      ++compared;
      EXPECT_EQ(x[i], stop) << "mass " << mass << " at " << t[i];
    }
  }
  EXPECT_GT(compared, 100);
}

// The labels of the ticks are those of the printed axes, from end to end, and the panel has its
// letter. What is drawn from curve `first` on fills the ordinate, as data do in the paper's plots.
void expect_axes(const Panel &panel, char letter, const AxisBox &box, std::size_t first) {
  std::vector<double> printed, labels;
  for (const std::string &text : panel.texts)
    if (const auto label = figures::as_number(text)) labels.push_back(*label);
  for (int k = 0; k <= std::lround((box.to - box.from) / box.tick_across); ++k)
    printed.push_back(box.from + k * box.tick_across);
  for (int k = 0; k <= std::lround((box.highest - box.lowest) / box.tick); ++k)
    printed.push_back(box.lowest + k * box.tick);
  std::sort(printed.begin(), printed.end());
  std::sort(labels.begin(), labels.end());
  ASSERT_EQ(labels.size(), printed.size());
  for (std::size_t i = 0; i < labels.size(); ++i) EXPECT_NEAR(labels[i], printed[i], 1e-9);
  const std::string name = {'(', letter, ')'};
  EXPECT_EQ(std::count(panel.texts.begin(), panel.texts.end(), name), 1) << name;
  figures::Range data;
  for (std::size_t i = first; i < panel.curves.size(); ++i)
    for (const Point &point : panel.curves[i].points) data.include(point[1]);
  EXPECT_TRUE(figures::fills_ordinate(data, box)) << data.lowest << " to " << data.highest;
}

// Six digits are written of every number; zero may be written of what is far below the others.
void expect_points(const Curve &curve, const std::vector<double> &x, const std::vector<double> &y) {
  ASSERT_EQ(curve.points.size(), x.size()) << curve.title;
  for (std::size_t i = 0; i < x.size(); ++i) {
    ASSERT_NEAR(curve.points[i][0], x[i], 1e-5 * std::abs(x[i])) << curve.title;
    ASSERT_NEAR(curve.points[i][1], y[i], 1e-5 * std::abs(y[i]) + 1e-15) << curve.title;
  }
}

// A line across the panel at this height, in the colour of stops and zero lines.
void expect_level(const Curve &curve, double height) {
  EXPECT_EQ(curve.colour, colour_of_line_type(3));
  ASSERT_FALSE(curve.points.empty());
  for (const Point &point : curve.points) ASSERT_NEAR(point[1], height, 1e-9);
}

// A panel is drawn from the motion with the true events. It has the stops of the scene within its
// axes, and the displacements of these masses, each in its own colour and under no other name.
void expect_displacements(const Panel &panel, const std::string &table, const std::string &truth,
                          const AxisBox &box, const std::vector<int> &masses = {1, 2}) {
  SCOPED_TRACE(table);
  auto columns = columns_of(folder_of(table.substr(0, 7)) + "/" + table + ".csv");
  expect_motion(columns, truth, box);
  std::set<double> stops;
  for (const Stop &stop : paper::scene_named(truth).scene.stops)
    if (stop.position > box.lowest) stops.insert(stop.position);
  ASSERT_EQ(panel.curves.size(), stops.size() + masses.size());
  expect_axes(panel, table.back(), box, stops.size());
  std::size_t next = 0;
  for (const double stop : stops) expect_level(panel.curves[next++], stop);
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
  expect_displacements(panels[0], "figure2a", "figure2", paper::figure2a_box);
  expect_displacements(panels[1], "figure2b", "figure2", paper::figure2b_box, {2});
}

TEST(Figure5, IsDrawnFromTheMotionsOfItsScenes) {
  const auto panels = drawn("figure5", folder_of("figure5"));
  ASSERT_EQ(panels.size(), 3u);
  expect_displacements(panels[0], "figure5a", "figure5a", paper::figure5a_box);
  expect_displacements(panels[1], "figure5b", "figure5b", paper::figure5b_box);
  expect_displacements(panels[2], "figure5c", "figure5c", paper::figure5c_box);
}

// The sticking phases of mass 1 in the last forcing period of the 50-digit run, as times within
// the period: by then (30 periods) the motion has settled to rounding.
std::vector<Point> true_phases(const std::string &scene, double omega) {
  const double period = Clock(omega).period;
  const std::vector<TrueEvent> events = true_events(scene);
  const double begin = (std::floor(events.back().time / period) - 1.0) * period;
  std::vector<Point> phases;
  for (const TrueEvent &event : events) {
    const double within = event.time - begin;
    if (event.mass != 1 || within < 0.0 || within > period) continue;
    if (event.event == "stick") phases.push_back({within, 0.0});
    if (event.event == "release") phases.back()[1] = within;
  }
  return phases;
}

TEST(Figure4, IsDrawnFromTheHoldForceInEveryStickingPhase) {
  const auto panels = drawn("figure4", folder_of("figure4"));
  ASSERT_EQ(panels.size(), 2u);
  for (const std::size_t k : {0u, 1u}) {
    const std::string name = k == 0 ? "figure4a" : "figure4b";
    SCOPED_TRACE(name);
    auto columns = columns_of(folder_of("figure4") + "/" + name + ".csv");
    const auto phases =
        true_phases(name, k == 0 ? paper::figure4a().omega : paper::figure4b().omega);
    ASSERT_EQ(phases.size(), k + 1);  // printed: the phase is split in two
    expect_axes(panels[k], name.back(), paper::figure4_box, 1);
    ASSERT_EQ(panels[k].curves.size(), 1 + phases.size()) << "every phase is drawn";
    expect_level(panels[k].curves[0], 0.0);
    EXPECT_TRUE(figures::fills_abscissa({phases.front()[0], phases.back()[1]}, paper::figure4_box));
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

TEST(Figure4, AThirdStickingPhaseIsDrawn) {
  const std::string folder = folder_of("figure4_third");
  drawn("figure4", folder);
  std::ofstream(folder + "/figure4b.csv", std::ios::app) << "3,17.2,-0.01\n3,17.3,0\n";
  const auto panels = drawn_from(folder, "figure4");
  ASSERT_EQ(panels.size(), 2u);
  ASSERT_EQ(panels[1].curves.size(), 4u);
  expect_points(panels[1].curves[3], {17.2, 17.3}, {-0.01, 0.0});
}

// What is drawn over Figure 3 in a panel, against the 50 digits of the points with this name.
void expect_bifurcations(const Curve &curve, const std::string &symbol, const AxisBox &box) {
  std::vector<double> known;
  for (const figures::KeyNumber &number :
       figures::read_key_numbers(REFERENCE_DIR "/key_numbers.csv"))
    if (number.symbol.starts_with(symbol)) known.push_back(number.reference);
  std::sort(known.begin(), known.end());
  ASSERT_EQ(curve.points.size(), known.size()) << symbol;
  for (std::size_t i = 0; i < known.size(); ++i) {
    EXPECT_NEAR(curve.points[i][0], known[i], 1e-6) << symbol;  // six digits are written
    EXPECT_NEAR(curve.points[i][1], box.lowest, 1e-9) << symbol;
  }
}

TEST(Figure3, IsDrawnFromTheImpactVelocitiesOfItsMasses) {
  const auto panels = drawn("figure3", folder_of("figure3"));
  ASSERT_EQ(panels.size(), 2u);
  for (const int mass : {1, 2}) {
    const std::string name = mass == 1 ? "figure3a" : "figure3b", v = "v" + std::to_string(mass);
    const AxisBox &box = mass == 1 ? paper::figure3a_box : paper::figure3b_box;
    SCOPED_TRACE(name);
    auto columns = columns_of(folder_of("figure3") + "/" + name + ".csv");
    const std::vector<double> &omega = columns["omega"], &velocity = columns[v];
    ASSERT_GT(omega.size(), 10000u);
    ASSERT_EQ(velocity.size(), omega.size());
    EXPECT_EQ(omega.front(), box.from);
    EXPECT_EQ(omega.back(), box.to);
    for (const double value : velocity)
      ASSERT_EQ(value < 0.0, mass == 1) << "printed: v1 < 0, v2 > 0";
    const auto velocities_at = [&](double frequency) {
      std::vector<double> velocities;
      for (std::size_t i = 0; i < omega.size(); ++i)
        if (std::abs(omega[i] - frequency) < 1e-9 &&
            std::abs(velocity[i]) > paper::slowest_impact_shown)
          velocities.push_back(velocity[i]);
      return velocities;
    };
    // Printed: the speeds of a chatter that ends in sticking fall to zero. In 0.37 to 0.4 those of
    // mass 1 do not: its chatter is incomplete; neither do those of mass 2 there.
    const auto slowest_at = [&](double frequency) {
      const auto velocities = velocities_at(frequency);
      return mass == 1 ? -velocities.back() : velocities.front();
    };
    EXPECT_LT(slowest_at(0.35), 3e-4);
    EXPECT_GT(slowest_at(0.385), 5e-4);

    // At the frequency of Figure 4(a), the velocities of the 50 digits in their last periods.
    const std::vector<TrueEvent> events = true_events("figure4a");
    const double last = events.back().time - 2 * Clock(paper::figure4a().omega).period;
    std::vector<double> truth;
    for (const TrueEvent &event : events)
      if (event.mass == mass && event.event == "impact" && event.time > last &&
          std::abs(event.velocity_before) > paper::slowest_impact_shown)
        truth.push_back(event.velocity_before);
    truth = figures::distinct(truth);
    const auto of_figure4a = velocities_at(paper::figure4a().omega);
    ASSERT_EQ(of_figure4a.size(), truth.size());
    for (std::size_t i = 0; i < truth.size(); ++i) EXPECT_NEAR(of_figure4a[i], truth[i], 1e-8);

    const Panel &panel = panels[static_cast<std::size_t>(mass - 1)];
    expect_axes(panel, name.back(), box, 2);
    ASSERT_EQ(panel.curves.size(), 3u);
    EXPECT_EQ(panel.curves[0].title, "border orbit");
    EXPECT_EQ(panel.curves[1].title, "multi-sliding");
    expect_bifurcations(panel.curves[0], "border_mass_" + std::to_string(mass), box);
    expect_bifurcations(panel.curves[1], "multi_sliding_mass_" + std::to_string(mass), box);
    expect_points(panel.curves[2], omega, velocity);
    EXPECT_EQ(panel.curves[2].colour, colour_of_line_type(mass));
  }
}

TEST(Figure3, EqualVelocitiesCountOnce) {
  EXPECT_EQ(figures::distinct({-0.1, -0.2, -0.1 * (1.0 + 1e-9), -0.2}),
            (std::vector{-0.2, -0.1 * (1.0 + 1e-9)}));
  EXPECT_EQ(figures::distinct({1e-4, 1.001e-4}).size(), 2u);
}

}  // namespace
