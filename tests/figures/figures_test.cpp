// The drivers of the figures but Figure 3: their tables against the 50-digit events and what the
// paper says. The pictures of the tables are compared with their digests (tests/pictures).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "figures/measures/inferred_frequencies.hpp"
#include "reference/numbers/checked_number.hpp"
#include "reference/scenes/table1_scenes.hpp"
#include "tests/support/tables.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;
using paper::AxisBox;

// Each mass is said to do what the true events say. The last impacts of a chatter, slower than
// 1e-4, are not resolved, so that only sticking is compared to the frame, and the release that
// stands for the time 2 after it, or until the next impact.
TEST(Figure1, ItsTableSaysWhatTheMassesDo) {
  const std::string folder = tables_of("figure1", "figure1");
  const Scene scene = paper::figure2();
  const std::vector<Event> events = true_events("figure2");
  std::set<std::string> actions[2];
  double last = paper::panel("figure2a").to - 2 * Clock(scene.omega).period;
  for (const truth::Row &row : truth::read_rows(folder + "/figure1_motion.csv")) {
    const double time = row.number("t");
    const auto next = std::find_if(events.begin(), events.end(),
                                   [time](const Event &event) { return event.time > time; });
    ASSERT_NE(next, events.begin());
    EXPECT_LT(time - last, 0.65) << "frames are 0.2 or 0.6 apart";
    last = time;
    for (const std::size_t i : {0u, 1u}) {
      const int mass = static_cast<int>(i) + 1;
      const std::string &action = row.cell("action" + std::to_string(mass));
      actions[i].insert(action);
      EXPECT_EQ(action == "sticks", holds(std::prev(next)->held, mass)) << time;
      const auto is_of_mass = [mass](const Event &event) { return event.mass == mass; };
      const auto latest = std::find_if(std::reverse_iterator(next), events.rend(), is_of_mass);
      ASSERT_NE(latest, events.rend());
      EXPECT_EQ(action == "released",
                latest->kind == EventKind::release && time < latest->time + 2.0)
          << time;
      if (action == "sticks") {
        EXPECT_EQ(row.number("x" + std::to_string(mass)), scene.stops[i].position) << time;
      }
    }
  }
  EXPECT_NEAR(last, paper::panel("figure2a").to, 0.65);
  for (const auto &of_mass : actions)
    EXPECT_EQ(of_mass, (std::set<std::string>{"-", "impact", "chatters", "sticks", "released"}));
}

// The samples of both masses in a window are the motion with the true events: at an impact a mass
// is where its stop is, to within how far it moves between samples, and while it sticks, exactly.
// The displacements of `shown` masses fill the printed ordinate.
void expect_motion(const std::string &folder, const std::string &panel, const std::string &truth,
                   const std::vector<int> &shown) {
  SCOPED_TRACE(panel);
  const truth::Rows rows = truth::read_rows(folder + "/" + panel + ".csv");
  const AxisBox box = paper::panel(panel);
  const Scene scene = paper::scene_named(truth).scene;
  const std::vector<double> t = numbers_of(rows, "t");
  ASSERT_GT(t.size(), 1000u);
  EXPECT_EQ(t.front(), box.from);
  EXPECT_NEAR(t.back(), box.to, 1e-9);
  const double every = t[1] - t[0];
  const std::vector<Event> events = true_events(truth);
  figures::Range reached;
  int compared = 0;
  for (const int mass : {1, 2}) {
    const std::vector<double> x = numbers_of(rows, "x" + std::to_string(mass));
    const double stop = stop_position(scene, mass);
    const bool is_shown = std::find(shown.begin(), shown.end(), mass) != shown.end();
    ASSERT_EQ(x.size(), t.size());
    std::size_t next = 0;  // the first event after the sample
    for (std::size_t i = 0; i < t.size(); ++i) {
      if (is_shown) reached.include(x[i]);
      for (; next < events.size() && events[next].time <= t[i]; ++next) {
        const Event &event = events[next];
        if (event.mass != mass || event.kind != EventKind::impact || event.time < box.from)
          continue;
        ++compared;
        if (is_shown) reached.include(stop);
        EXPECT_NEAR(x[i], stop, every * std::abs(event.velocity_before) + every * every) << t[i];
      }
      if (next == 0 || !holds(events[next - 1].held, mass)) continue;
      ++compared;
      EXPECT_EQ(x[i], stop) << "mass " << mass << " at " << t[i];
    }
  }
  EXPECT_GT(compared, 10);
  EXPECT_TRUE(figures::fills_ordinate(reached, box)) << reached.lowest << ", " << reached.highest;
}

TEST(Figure2, HasTheMotionOfItsScene) {
  const std::string folder = tables_of("figure2", "figure2");
  expect_motion(folder, "figure2a", "figure2", {1, 2});
  expect_motion(folder, "figure2b", "figure2", {2});
}

// The impacts of mass 2 are the true ones within the window, to within what a picture shows.
void expect_impacts_of_mass_2(const std::string &folder, const std::string &panel) {
  SCOPED_TRACE(panel);
  const std::vector<Event> truth = select(true_events(panel), EventKind::impact, 2);
  auto next = std::find_if(truth.begin(), truth.end(), [&](const Event &event) {
    return event.time >= paper::panel(panel).from;
  });
  int compared = 0;
  for (const auto &row : truth::read_rows(folder + "/" + panel + "_impacts.csv")) {
    if (row.cell("mass") != "2") continue;
    ASSERT_NE(next, truth.end());
    EXPECT_NEAR(row.number("t"), next->time, 1e-6);
    const double speed = std::abs(next->velocity_before);
    EXPECT_NEAR(row.number("speed"), speed, 1e-5 * speed);
    ++next;
    ++compared;
  }
  EXPECT_GT(compared, 1);
  EXPECT_TRUE(next == truth.end() || next->time > paper::panel(panel).to);
}

TEST(Figure5, HasTheMotionsOfItsScenes) {
  const std::string folder = tables_of("figure5", "figure5");
  for (const char *panel : {"figure5a", "figure5b", "figure5c"})
    expect_motion(folder, panel, panel, {1, 2});
  expect_impacts_of_mass_2(folder, "figure5a");
  expect_impacts_of_mass_2(folder, "figure5c");
  // Mass 2 turns before its stop in (b). The samples are 0.001 apart, and x2'' is -0.3 there: the
  // highest of them is at most 4e-8 below the maximum.
  const std::vector<double> x = numbers_of(truth::read_rows(folder + "/figure5b.csv"), "x2");
  const double gap = paper::figure5b().stops[1].position - *std::max_element(x.begin(), x.end());
  for (const auto &number : numbers::checked_numbers(REFERENCE_DIR))
    if (number.id == "figure5b_nearest_gap") {
      EXPECT_NEAR(gap, number.value, 4e-8);
    }
}

// The sticking phases of mass 1 in the last forcing period of the 50-digit run, as times within
// the period: by then (30 periods) the motion has settled to rounding.
std::vector<figures::Range> true_phases(const std::string &scene, double omega) {
  const double period = Clock(omega).period;
  const std::vector<Event> events = true_events(scene);
  const double begin = (std::floor(events.back().time / period) - 1.0) * period;
  std::vector<figures::Range> phases;
  for (const Event &event : events) {
    const double within = event.time - begin;
    if (event.mass != 1 || within < 0.0 || within > period) continue;
    if (event.kind == EventKind::stick) phases.push_back({within, within});
    if (event.kind == EventKind::release) phases.back().highest = within;
  }
  return phases;
}

TEST(Figure4, HasTheHoldForceInEveryStickingPhase) {
  const std::string folder = tables_of("figure4", "figure4");
  const AxisBox box = paper::panel("figure4");
  for (const bool after : {false, true}) {
    const std::string name = after ? "figure4b" : "figure4a";
    SCOPED_TRACE(name);
    const truth::Rows rows = truth::read_rows(folder + "/" + name + ".csv");
    const auto phases =
        true_phases(name, after ? paper::figure4b().omega : paper::figure4a().omega);
    ASSERT_EQ(phases.size(), after ? 2u : 1u);  // printed: the phase is split in two
    EXPECT_EQ(rows.back().cell("phase"), std::to_string(phases.size()));
    EXPECT_TRUE(figures::fills({phases.front().lowest, phases.back().highest}, {box.from, box.to},
                               box.tick_across));
    figures::Range all_forces;
    for (std::size_t phase = 0; phase < phases.size(); ++phase) {
      std::vector<double> t, force;
      for (const truth::Row &row : rows)
        if (row.cell("phase") == std::to_string(phase + 1)) {
          t.push_back(row.number("t"));
          force.push_back(row.number("F2"));
          all_forces.include(force.back());
          EXPECT_LE(force.back(), 0.0) << "printed: the force holds mass 1 to a lower stop";
          if (std::abs(t.back() - 14.173) < 1e-3) {
            EXPECT_GT(force.back(), -1e-4) << "printed: the force all but touches zero";
          }
        }
      ASSERT_FALSE(t.empty());
      EXPECT_NEAR(t.front(), phases[phase].lowest, 1e-8);
      EXPECT_NEAR(t.back(), phases[phase].highest, 1e-8);
      EXPECT_EQ(force.back(), 0.0) << "released at a root of the force";
    }
    EXPECT_TRUE(figures::fills_ordinate(all_forces, box));
  }
  // The force at the bifurcation touches zero. The samples are 0.001 apart, and the second
  // derivative of the force is -0.11.
  truth::Rows touching = truth::read_rows(folder + "/figure4_at.csv");
  std::erase_if(touching, [](const truth::Row &row) { return row.number("t") >= 14.8; });
  const auto highest = std::ranges::max_element(
      touching, {}, [](const truth::Row &row) { return row.number("F2"); });
  ASSERT_NE(highest, touching.end());
  EXPECT_NEAR(highest->number("t"), 14.173, 0.001);
  EXPECT_NEAR(highest->number("F2"), 0.0, 2e-8);
}

// Between the two phases of (b), the force as if held goes on where the hold force ends, and ends
// where the next hold force begins: at a release at a root and at the end of a chatter of mass 1,
// the motion of mass 2 does not jump. In between it pulls mass 1 off its lower stop.
TEST(Figure4, TheForceAsIfHeldJoinsTheStickingPhases) {
  const std::string folder = tables_of("figure4", "figure4_free");
  const truth::Rows free = truth::read_rows(folder + "/figure4b_free.csv"),
                    held = truth::read_rows(folder + "/figure4b.csv");
  const std::vector<double> t = numbers_of(free, "t"), force = numbers_of(free, "F2");
  ASSERT_GT(t.size(), 600u);
  const auto second =
      std::ranges::find_if(held, [](const truth::Row &row) { return row.cell("phase") == "2"; });
  ASSERT_NE(second, held.end());
  ASSERT_NE(second, held.begin());
  const truth::Row &last_of_first = *std::prev(second);
  // The samples are 0.001 apart, and the force changes by at most 0.05 per unit of time there.
  EXPECT_NEAR(t.front(), last_of_first.number("t"), 0.001);
  EXPECT_NEAR(force.front(), last_of_first.number("F2"), 5e-5);
  EXPECT_NEAR(t.back(), second->number("t"), 0.001);
  EXPECT_NEAR(force.back(), second->number("F2"), 5e-5);
  const auto highest = std::max_element(force.begin(), force.end());
  EXPECT_NEAR(t[static_cast<std::size_t>(highest - force.begin())], 14.173, 0.01)
      << "where the force of (a) turns back";
  EXPECT_GT(*highest, 6e-4) << "it grows by 7 per unit of the frequency";
}

// A mass that grazes (G), impacts (I) or sticks (S) is at its stop. The events of a pair are up to
// 1e-6 apart. Its name has the letters of both masses; D stands for twice the same.
TEST(Table1, EachPairIsAtItsStops) {
  const std::string folder = tables_of("table1", "table1");
  const auto scenes = paper::table1_scenes();
  const auto pairs = truth::read_rows(folder + "/table1_pairs.csv");
  for (const auto &[name, scene, from, to] : scenes) {
    SCOPED_TRACE(name);
    int shown = 0;
    for (const truth::Row &pair : pairs) {
      if (pair.cell("pair") != name) continue;
      ++shown;
      const std::string second = {name[1]}, first = name[0] == 'D' ? second : std::string{name[0]};
      EXPECT_EQ(std::multiset({pair.cell("event1"), pair.cell("event2")}),
                std::multiset({first, second}));
      for (const std::size_t i : {0u, 1u})
        EXPECT_NEAR(pair.number("x" + std::to_string(i + 1)), scene.stops[i].position, 1e-6);
    }
    EXPECT_GE(shown, 1);
  }
}

// A sticking mass is released where the force on it is zero (Eqs. 20 and 23), which is what the
// boundaries are. The force on mass 1 is A1 cos(omega t) + k (x2 - 2 s1) + c x2', that on mass 2 is
// k (x1 - s2) + c x1'.
TEST(ExitBoundary, EveryReleaseLiesOnIt) {
  const std::string folder = tables_of("exit_boundary", "exit_boundary");
  const truth::Row numbers = truth::read_rows(folder + "/exit_boundary.csv").at(0);
  const auto number = [&](const char *name) { return numbers.number(name); };
  for (const int mass : {1, 2}) {
    int releases = 0;
    for (const truth::Row &row :
         truth::read_rows(folder + "/exit_boundary" + std::to_string(mass) + ".csv")) {
      if (row.cell("kind") != "release") continue;
      ++releases;
      const double t = row.number("t"), x = row.number("x"), v = row.number("v");
      const double boundary = mass == 2 ? -number("rate") * (x - number("s2"))
                                        : -number("rate") * (x - 2 * number("s1")) -
                                              number("forcing") * std::cos(number("omega") * t);
      EXPECT_NEAR(v, boundary, 1e-9) << "mass " << mass << " at " << t;  // rounding, times k / c
    }
    EXPECT_GT(releases, 5);
  }
}

}  // namespace
