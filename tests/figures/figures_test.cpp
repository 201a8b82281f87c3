// The motions in the tables of Figures 2 and 5 against the 50-digit events, and the axes of Figures
// 3 and 4. The pictures of all tables are compared with their digests (tests/pictures).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "figures/measures/inferred_frequencies.hpp"
#include "figures/measures/runs.hpp"
#include "reference/numbers/checked_number.hpp"
#include "tests/support/events.hpp"
#include "tests/support/tables.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;
using paper::AxisBox;

// The cells of a column, all of which are numbers.
std::vector<double> numbers_of(const truth::Rows &rows, const std::string &column) {
  std::vector<double> numbers;
  for (const truth::Row &row : rows) numbers.push_back(row.number(column));
  return numbers;
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
}

// The ends of axes whose scenes and windows are printed (figures/README.md, What is inferred), and
// the ends of the time axis of Figure 4, which a settled period fills.
TEST(Axes, EndAtTheFirstTickBeyondTheData) {
  const std::string of_figure3 = tables_of("figure3", "axes"),
                    of_figure4 = tables_of("figure4", "axes");
  const truth::Rows impacts = truth::read_rows(of_figure3 + "/figure3_impacts.csv");
  for (const int mass : {1, 2}) {
    figures::Range reached;
    for (const truth::Row &impact : impacts)
      if (impact.cell("mass") == std::to_string(mass)) reached.include(impact.number("velocity"));
    EXPECT_TRUE(figures::fills_ordinate(reached, paper::panel(mass == 1 ? "figure3a" : "figure3b")))
        << reached.lowest << ", " << reached.highest;
  }
  for (const char letter : {'a', 'b'}) {
    const truth::Rows rows =
        truth::read_rows(of_figure4 + "/figure4" + std::string{letter} + ".csv");
    const AxisBox box = paper::panel("figure4");
    figures::Range times, forces;
    for (const truth::Row &row : rows) {
      times.include(row.number("t"));
      forces.include(row.number("F2"));
    }
    EXPECT_TRUE(figures::fills(times, {box.from, box.to}, box.tick_across)) << letter;
    EXPECT_TRUE(figures::fills_ordinate(forces, box)) << letter;
    EXPECT_EQ(rows.back().cell("phase"), letter == 'a' ? "1" : "2") << "the phase is split in two";
  }
}

// Below 0.5, the sticking phases per period change from one frequency of Figure 3 to the next
// where a key number lies between the two, and nowhere else.
TEST(Figure3, ThePhasesChangeWhereItsLinesStand) {
  const truth::Rows rows =
      truth::read_rows(tables_of("figure3", "figure3") + "/figure3_records.csv");
  for (const std::string mass : {"1", "2"}) {
    std::vector<double> lines;
    for (const auto &number : numbers::checked_numbers(REFERENCE_DIR))
      for (const char *kind : {"border_mass_", "multi_sliding_mass_", "jump_mass_"})
        if (number.id.starts_with(kind + mass)) lines.push_back(number.value);
    EXPECT_EQ(lines.size(), mass == "1" ? 8u : 5u);
    for (std::size_t i = 1; i < rows.size() && rows[i].number("omega") < 0.5; ++i)
      EXPECT_EQ(rows[i - 1].cell("sticks" + mass) != rows[i].cell("sticks" + mass),
                std::ranges::any_of(lines,
                                    [&](double line) {
                                      return line > rows[i - 1].number("omega") &&
                                             line < rows[i].number("omega");
                                    }))
          << "mass " << mass << " at " << rows[i].number("omega");
  }
}

// At the frequency of Figure 4(a), the velocities are those of the 50 digits in their last periods.
// 1e-8 is the distance at which a motion counts as settled.
TEST(Figure3, HasTheVelocitiesOf50Digits) {
  const Scene scene = paper::figure4a();
  const std::vector<Event> events = true_events("figure4a");
  const double last = events.back().time - 2 * Clock(scene.omega).period;
  const truth::Rows impacts =
      truth::read_rows(tables_of("figure3", "figure3_velocities") + "/figure3_impacts.csv");
  for (const int mass : {1, 2}) {
    std::vector<double> expected, found;
    for (const Event &event : select(events, EventKind::impact, mass))
      if (event.time > last && std::abs(event.velocity_before) > paper::slowest_impact_shown)
        expected.push_back(event.velocity_before);
    for (const truth::Row &impact : impacts)
      if (std::abs(impact.number("omega") - scene.omega) < 1e-9 && impact.number("mass") == mass &&
          std::abs(impact.number("velocity")) > paper::slowest_impact_shown)
        found.push_back(impact.number("velocity"));
    expected = figures::distinct(expected);
    found = figures::distinct(found);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-8);
  }
}

TEST(Figure3, EqualVelocitiesCountOnce) {
  EXPECT_EQ(figures::distinct({-0.1, -0.2, -0.1 * (1.0 + 1e-9), -0.2}),
            (std::vector{-0.2, -0.1 * (1.0 + 1e-9)}));
  EXPECT_EQ(figures::distinct({1e-4, 1.00001e-4}).size(), 2u);
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

// The recorder gives no force at a release by a jump. In Figure 4(b), all releases are at a root of
// the force.
TEST(Figure4, ARecordedReleaseByAJumpHasNoForce) {
  int jumps = 0, roots = 0;
  for (const Scene &scene : {released_by_a_jump(), paper::figure4b()}) {
    EventRecorder events(100.0);
    figures::StickingPhaseRecorder phases(1, 0, 100.0, 200.0, 1.0);
    require_complete(simulate(scene, 200.0, events));
    require_complete(simulate(scene, 200.0, phases));
    std::erase_if(phases.rows, [](const auto &row) { return row.kind != "release"; });
    const auto released = select(events.events, EventKind::release, 1);
    ASSERT_EQ(phases.rows.size(), released.size());
    for (std::size_t i = 0; i < released.size(); ++i) {
      ++(released[i].by_a_jump ? jumps : roots);
      if (released[i].by_a_jump) {
        EXPECT_TRUE(std::isnan(phases.rows[i].force));
      } else {
        EXPECT_EQ(phases.rows[i].force, 0.0);
      }
    }
  }
  EXPECT_GT(jumps, 0);
  EXPECT_GT(roots, 0);
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
