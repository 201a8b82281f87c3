// Could the author's procedure explain the statements of the paper that differ from ours? The edges
// of the two windows of Figure 3 by procedure, the settled motions from random starts, dual
// sticking against the position of the second stop, and Figure 5(c) with nearly equal stops.
#include "procedures.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <random>
#include <string>

#include "driver.hpp"
#include "runs.hpp"

namespace {

using namespace vibro_impact;
using figures::Procedure;

// --- The windows of Figure 3 in which no chatter of mass 1 is complete ------------------------

// The frequencies tried are 0.001 apart.
const Grid frequencies{paper::figure3(0.28), {{"omega", 0.28, 0.42, 141}}};

// A frequency of a grid with the three decimals that it has.
std::string shown(const Grid &grid, std::size_t i) {
  return fmt::format("{:.3f}", grid.values(i).front());
}

// For each frequency, how many chatters of mass 1 are complete.
using Complete = std::vector<std::ptrdiff_t>;

// Follows a motion for `settling` and then `counted` forcing periods, to which it moves the start.
// Returns how often mass 1 comes to stick in the latter.
std::ptrdiff_t sticks(const Scene &scene, MotionState &start, const Procedure &procedure,
                      int settling, int counted) {
  const double period = Clock(scene.omega).period, from = settling * period;
  const auto [events, end] = figures::follow(scene, start, from + counted * period, procedure);
  start = end;
  start.instant = {};
  return std::count_if(events.begin(), events.end(), [from](const Event &event) {
    return event.kind == EventKind::stick && event.mass == 1 && event.time > from;
  });
}

// The motions from rest by a procedure, plotted for `counted` periods after `settling` periods.
Complete from_rest(const Procedure &procedure, int settling, int counted) {
  return sweep(frequencies, [&](const Scene &scene) {
    MotionState start = start_of(scene);
    return sticks(scene, start, procedure, settling, counted);
  });
}

// The exact motions, each from the state at the end of the one at the frequency before.
Complete by_continuation(bool upwards) {
  Complete complete(frequencies.points());
  MotionState start = start_of(frequencies.scene);
  for (std::size_t n = 0; n < complete.size(); ++n) {
    const std::size_t i = upwards ? n : complete.size() - 1 - n;
    complete[i] = sticks(frequencies.scene_at(i), start, {}, 60, 20);
  }
  return complete;
}

// Starts at random: displacements within 1 of the stop, speeds up to 0.5, the phase zero.
std::vector<MotionState> random_starts(const Scene &scene, std::size_t count, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  const auto number = [&generator] { return static_cast<double>(generator() >> 11) * 0x1p-53; };
  std::vector<MotionState> starts(count, start_of(scene));
  for (MotionState &start : starts)
    for (std::size_t i = 0; i < 2; ++i) {
      start.displacement[i] = scene.stops[i].position - sign(scene.stops[i].side) * number();
      start.velocity[i] = number() - 0.5;
    }
  return starts;
}

// The exact motions, each from a random start of its own.
Complete from_random_starts() {
  return sweep(frequencies.points(), [](std::size_t i) {
    const Scene scene = frequencies.scene_at(i);
    MotionState start = random_starts(scene, 1, i).front();
    return sticks(scene, start, {}, 60, 20);
  });
}

// The exact motions from rest, and a chatter counts as complete if the plot has a speed of mass 1
// below the threshold: such speeds are counted.
Complete by_visible_speed(double threshold) {
  return sweep(frequencies, [&](const Scene &scene) {
    const double period = Clock(scene.omega).period;
    ImpactVelocityRecorder impacts{1, 60 * period};
    const RunOptions all_visible{.limit_below_speed = threshold / 10};
    require_complete(simulate(scene, 64 * period, all_visible, impacts));
    return std::count_if(impacts.velocities.begin(), impacts.velocities.end(),
                         [=](double v) { return std::abs(v) <= threshold; });
  });
}

// A row for each run of neighbouring frequencies at which no chatter of mass 1 is complete, by
// procedure.
Table windows() {
  Table table("procedure,number,from,to");
  int number = 0;
  const auto add = [&](const std::string &procedure, const Complete &complete,
                       std::size_t every = 1) {
    ++number;
    const auto none = [&](std::size_t i) { return complete[i] == 0; };
    for (const auto &[first, last] : figures::runs_where(none, complete.size(), every))
      table.row(procedure, number, shown(frequencies, first), shown(frequencies, last));
  };
  const Complete exact = from_rest({}, 60, 40);
  add("the exact motion from rest", exact);
  add("continuation upwards", by_continuation(true));
  add("continuation downwards", by_continuation(false));
  add("a random start at each frequency", from_random_starts());
  add("period 1 alone", from_rest({}, 0, 1));
  for (const auto &[settling, counted] : {std::pair{0, 2}, {0, 40}, {2, 40}, {5, 40}, {10, 40}})
    add(fmt::format("periods {} to {}", settling + 1, settling + counted),
        from_rest({}, settling, counted));
  add("frequencies 0.01 apart", exact, 10);
  for (const double flight : {0.01, 0.05, 0.1, 0.15})
    add(fmt::format("cut off: flight < {}", flight),
        from_rest({.shortest_flight = flight}, 60, 10));
  for (const double speed : {1e-4, 1e-3, 2e-3})
    add(fmt::format("cut off: speed < {}", speed), from_rest({.slowest_impact = speed}, 60, 10));
  for (const double speed : {1e-3, 2e-3})
    add(fmt::format("seen: no speed < {}", speed), by_visible_speed(speed));
  add("Eq. 24 as printed", from_rest({.printed_equation24 = true}, 60, 20));
  return table;
}

// The same of the frequencies above 0.5 at which mass 1 sticks, from rest.
Table sticking_above_one_half() {
  const Grid above{paper::figure3(0.5), {{"omega", 0.5, 0.7, 201}}};
  const Complete settled = sweep(above, [](const Scene &scene) {
    MotionState start = start_of(scene);
    return sticks(scene, start, {}, paper::figure3_settling_periods, 10);
  });
  Table table("sticks,from,to");
  const auto some = [&](std::size_t i) { return settled[i] > 0; };
  for (const auto &[first, last] : figures::runs_where(some, settled.size()))
    table.row("mass 1", shown(above, first), shown(above, last));
  return table;
}

// --- Random starts ----------------------------------------------------------------------------

// The numbers that identify a settled motion: its period, its counts and the greatest speeds of the
// masses.
bool same(const OrbitRecord &one, const OrbitRecord &other) {
  if (one.period == 0 || one.period != other.period || one.counts.sticks != other.counts.sticks ||
      one.counts.impacts != other.counts.impacts)
    return false;
  for (std::size_t i = 0; i < 2; ++i) {
    figures::Range speeds, others;
    for (const Event &impact : one.impacts[i]) speeds.include(std::abs(impact.velocity_before));
    for (const Event &impact : other.impacts[i]) others.include(std::abs(impact.velocity_before));
    if (!(std::abs(speeds.highest - others.highest) < 1e-6)) return false;
  }
  return true;
}

// A row: of so many random starts, how many different motions settle, how many starts do not settle
// in 400 periods, and in how many motions mass 1 sticks.
void add_starts(Table &table, double omega, std::size_t count) {
  const Scene scene = paper::figure3(omega);
  const auto starts = random_starts(scene, count, 0);
  const RecordOptions options{.impacts = true};
  const auto records =
      sweep(count, [&](std::size_t k) { return record_of(scene, starts[k], options); });
  std::vector<OrbitRecord> different;
  std::size_t unsettled = 0, sticking = 0;
  for (const OrbitRecord &record : records) {
    if (record.counts.sticks[0] > 0) ++sticking;
    if (record.period == 0)
      ++unsettled;
    else if (std::none_of(different.begin(), different.end(),
                          [&](const OrbitRecord &other) { return same(record, other); }))
      different.push_back(record);
  }
  table.row(omega, count, different.size(), unsettled, sticking);
}

Table starts() {
  Table table("omega,starts,settled_motions,unsettled_starts,starts_with_sticking_of_mass_1");
  for (int hundredth = 25; hundredth <= 46; ++hundredth) add_starts(table, 0.01 * hundredth, 20);
  for (const double omega : {0.472, 0.62, 0.63, 0.645, 0.65, 0.655, 0.66, 0.665, 0.67})
    add_starts(table, omega, 60);
  return table;
}

// --- Figure 5 ---------------------------------------------------------------------------------

// Dual sticks per forcing period in the scenes of Figure 5, with the second stop at places from 0
// to 0.5. They are counted up to t = 1000, without the first third of the forcing periods.
Table dual_sticking() {
  const auto rows = sweep(101, [](std::size_t i) {
    std::vector<double> row{0.005 * static_cast<double>(i)};
    for (Scene scene : {paper::figure5a(), paper::figure5b(), paper::figure5c()}) {
      scene.stops[1].position = row.front();
      const double period = Clock(scene.omega).period, last = std::floor(1000.0 / period),
                   first = std::floor(last / 3.0);
      row.push_back(figures::dual_sticks(scene, first * period, last * period) / (last - first));
    }
    return row;
  });
  Table table("s2,a,b,c");
  for (const auto &row : rows) table.row(row[0], row[1], row[2], row[3]);
  return table;
}

// Figure 5(c) with the second stop a little below the first one, and with lower r and Omega: when
// mass 1 is released, the time at which mass 2 has come to stick before it, and else the speed of
// the last impact of mass 2 before the release.
Table nearly_equal_stops() {
  Table table("omega,r,difference,release,stick,speed");
  const auto add = [&table](double omega, double restitution, double difference) {
    Scene scene = paper::figure5c();
    scene.omega = omega;
    scene.restitution = restitution;
    scene.stops[1].position -= difference;
    const double period = Clock(omega).period;
    double release = NAN, stick = NAN, speed = NAN;
    for (const Event &event : figures::events_of(scene, 2.5 * period, 3.5 * period)) {
      if (event.mass == 1 && event.kind == EventKind::release) {
        release = event.time;
        break;
      }
      if (event.mass == 2 && event.kind == EventKind::impact) speed = event.velocity_before;
      if (event.mass == 2 && event.kind == EventKind::stick) stick = event.time;
    }
    table.row(omega, restitution, difference, release, stick, speed);
  };
  for (const double difference : {1e-4, 1e-7, 1e-8, 3e-9, 1e-9, 0.0}) add(0.02, 0.7, difference);
  add(0.01, 0.7, 0.0);
  add(0.02, 0.3, 0.0);
  return table;
}

void draw(const std::filesystem::path &output) {
  write(windows(), output / "procedures_windows.csv");
  write(sticking_above_one_half(), output / "procedures_sticking.csv");
  write(starts(), output / "procedures_starts.csv");
  write(dual_sticking(), output / "procedures_dual.csv");
  write(nearly_equal_stops(), output / "procedures_figure5c.csv");
}

}  // namespace

int main(int argc, char **argv) {
  return figures::drive(argc, argv, "What the author's procedure may have made of the motion",
                        draw);
}
