// The bifurcation points of the paper's scenes for forcing frequencies from 0.25 to 0.5: where they
// are, found in two ways each.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <string>
#include <vector>

#include "paper_scenes.hpp"
#include "vibro_impact/bifurcation.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::figures {

struct BifurcationPoint {
  std::string symbol;
  Located omega;
  std::string method;
  double check = 0.0;  // the same by bisection on a count of events
  std::string checked_by;
};

// Forcing periods left out before the motion from rest counts as settled, and those then counted
// over: sticking motions of period 1, 2 and 4 give the same count in every window.
constexpr int settling = 150, counted = 4;

inline int sticks_from_rest(double omega, int mass) {
  return sticking_phases(paper::stops_of_different_sign(omega), mass, settling, counted);
}

// Every place in [below, above] where the count of a mass changes, by repeated bisection; those
// closer together than 1e-11 are one, blurred by the settling.
inline std::vector<Change> changes_between(int mass, double below, double above) {
  const auto count = [mass](double omega) { return sticks_from_rest(omega, mass); };
  std::vector<Change> changes;
  const int at_end = count(above);
  while (count(below) != at_end) {
    const Change change = bisect(count, below, above);
    below = std::min(change.above + 1e-11, above);
    changes.push_back(change);
    changes.back().count_above = count(below);
  }
  return changes;
}

// The zero of the least pressing force, when the change is a multi-sliding bifurcation: on the side
// with fewer sticking phases the force on `mass` is about to touch zero inside one.
inline std::optional<Located> multi_sliding(const Change &change, int mass) {
  const double side = change.count_below < change.count_above ? -1.0 : 1.0;
  const double near = change.below + side * 1e-6;
  const Scene scene = paper::stops_of_different_sign(near);
  const MotionState seed = at_quiet_phase(scene, settled(scene, settling));
  const auto force = [&](double omega) -> std::optional<double> {
    const Scene at = paper::stops_of_different_sign(omega);
    return least_pressing_force(at, orbit_near(at, seed, 1, {}),
                                at.stops[static_cast<std::size_t>(mass - 1)]);
  };
  const auto touching = force(near);
  if (!touching || *touching > 1e-5) return std::nullopt;
  return zero_from_one_side([&](double omega) { return force(omega).value(); },
                            change.below + side * 1e-4, change.below + side * 2e-5);
}

// The border orbit at the change: one of the chatters that complete on the side with more sticking
// phases does not on the other.
inline std::optional<BorderOrbit> border_orbit(const Change &change, int mass) {
  const double side = change.count_below > change.count_above ? -1.0 : 1.0;
  const double complete = change.below + side * 1e-7, incomplete = change.below - side * 1e-7;
  const Scene scene = paper::stops_of_different_sign(complete);
  MotionState seed = at_quiet_phase(scene, settled(scene, 4 * settling));
  const int periods = recurrence(scene, seed).periods;
  if (periods == 0) return std::nullopt;  // no periodic orbit to follow
  seed = orbit_near(scene, seed, periods, {});
  for (const FallingSequence &chatter : falling_sequences(scene, seed, mass, periods)) {
    if (!chatter.complete) continue;
    const auto border = find_border_orbit(paper::stops_of_different_sign, mass, seed, chatter.begin,
                                          periods, complete, incomplete);
    if (border) return border;
  }
  return std::nullopt;
}

// Multi-sliding or border orbit: the change located by its smooth function. Throws
// std::runtime_error when it is neither.
inline BifurcationPoint locate(const Change &change, int mass) {
  const double check = 0.5 * (change.below + change.above);
  const std::string counting = "bisection on sticking phases from rest";
  if (const auto tangent = multi_sliding(change, mass))
    return {fmt::format("multi_sliding_mass_{}", mass), *tangent,
            "hold force on the periodic orbit touches zero", check, counting};
  if (const auto border = border_orbit(change, mass))
    return {fmt::format("border_mass_{}", mass), border->parameter,
            "impact speeds on the periodic orbit keep the ratio of the border orbit", check,
            counting};
  throw std::runtime_error(
      fmt::format("mass {} at omega = {}: neither multi-sliding nor a border orbit", mass, check));
}

// --- Figure 5(b) ------------------------------------------------------------------------------------

inline Scene figure5b_at(double omega) {
  Scene scene = paper::figure5b();
  scene.omega = omega;
  return scene;
}

// The motion of mass 2 that does not touch its stop, with that stop taken away: it goes on existing,
// and its least gap passes smoothly through zero, where the real motion grazes.
inline MotionState motion_without_second_stop(double omega) {
  Scene scene = figure5b_at(omega);
  scene.stops.pop_back();
  const MotionState seed = at_quiet_phase(scene, settled(scene, settling));
  return orbit_near(scene, seed, 1, {});
}

// Impacts of mass 2 in the `counted` periods that come `after` periods after `start`.
inline int impacts_of_mass_2(double omega, const MotionState &start, int after, MotionState *end) {
  const Scene scene = figure5b_at(omega);
  const MotionState settled_state =
      after > 0 ? stroboscopic_map(scene, start, after, {}).state : start;
  ImpactSpeedRecorder impacts{2, -1.0};
  const MotionState last = stroboscopic_map(scene, settled_state, counted, {}, impacts).state;
  if (end != nullptr) *end = last;
  return static_cast<int>(impacts.velocities.size());
}

inline BifurcationPoint grazing() {
  const Stop second = paper::figure5b().stops[1];
  const auto gap = [&](double omega) {
    Scene scene = figure5b_at(omega);
    scene.stops.pop_back();
    return least_gap(scene, motion_without_second_stop(omega), second).value();
  };
  const Change change = bisect(
      [](double omega) {
        return impacts_of_mass_2(omega, motion_without_second_stop(omega), 0, nullptr) > 0 ? 1 : 0;
      },
      0.2995, 0.2996);
  return {"grazing_mass_2_figure5b", zero(gap, 0.2995, 0.2996),
          "gap of mass 2 on the periodic orbit without impact touches zero",
          0.5 * (change.below + change.above), "bisection on impacts from that orbit"};
}

// Below the grazing the motion with impacts of mass 2 lives on beside the one without, down to this
// frequency: followed downwards by ever smaller steps.
inline BifurcationPoint end_of_impacting_motion() {
  double omega = 0.2996, step = 1e-5;
  const Scene scene = figure5b_at(omega);
  MotionState state = settled(scene, settling), next = state;
  while (step > 1e-13) {
    if (impacts_of_mass_2(omega - step, state, 2 * settling, &next) > 0) {
      omega -= step;
      state = next;
    } else {
      step /= 2;
    }
  }
  const Change change = bisect(
      [](double at) {
        return impacts_of_mass_2(at, start_of(figure5b_at(at)), 2 * settling, nullptr) > 0 ? 1 : 0;
      },
      0.2995, 0.2996, 1e-13);
  return {"impacts_of_mass_2_end_figure5b", {omega, 1e-11}, "followed downwards from 0.2996",
          0.5 * (change.below + change.above), "bisection on impacts from rest"};
}

// --- All of them ------------------------------------------------------------------------------------

// Sticking phases of both masses in `counted` periods at every frequency of a grid.
using Counts = std::vector<std::array<int, 2>>;

inline std::vector<double> sticking_grid(int intervals) {
  std::vector<double> omegas;
  for (int i = 0; i <= intervals; ++i) omegas.push_back(0.25 + 0.25 * i / intervals);
  return omegas;
}

inline Counts scan_from_rest(const std::vector<double> &omegas, int threads) {
  Counts counts(omegas.size());
  std::exception_ptr failure;
#pragma omp parallel for schedule(dynamic, 8) num_threads(threads)
  for (std::size_t i = 0; i < omegas.size(); ++i) {
    try {
      counts[i] = {sticks_from_rest(omegas[i], 1), sticks_from_rest(omegas[i], 2)};
    } catch (...) {
#pragma omp critical
      failure = std::current_exception();
    }
  }
  if (failure) std::rethrow_exception(failure);
  return counts;
}

// The same along a branch: every frequency, in the order given, starts from the motion at the one
// before and settles for `periods` periods.
inline Counts scan_following(const std::vector<double> &omegas, int periods) {
  Counts counts;
  MotionState state = settled(paper::stops_of_different_sign(omegas.front()), settling);
  for (double omega : omegas) {
    const Scene scene = paper::stops_of_different_sign(omega);
    EventRecorder recorder;
    state = stroboscopic_map(scene, state, periods, {}).state;
    state = stroboscopic_map(scene, state, counted, {}, recorder).state;
    counts.push_back({0, 0});
    for (const Event &event : recorder.events)
      if (event.kind == EventKind::stick)
        ++counts.back()[static_cast<std::size_t>(event.mass - 1)];
  }
  return counts;
}

// Every change of the counts of a scan, located, in the order of the frequency; the orbits of one
// kind and mass are numbered from 1.
inline std::vector<BifurcationPoint> locate_all(const std::vector<double> &omegas,
                                                const Counts &counts, int threads) {
  struct Interval {
    int mass;
    std::size_t left;
    std::vector<BifurcationPoint> points = {};
  };
  std::vector<Interval> intervals;
  for (std::size_t i = 0; i + 1 < omegas.size(); ++i)
    for (int mass : {1, 2}) {
      const auto m = static_cast<std::size_t>(mass - 1);
      if (counts[i][m] != counts[i + 1][m]) intervals.push_back({mass, i});
    }
  std::exception_ptr failure;
#pragma omp parallel for schedule(dynamic) num_threads(threads)
  for (std::size_t k = 0; k < intervals.size(); ++k) {
    try {
      const auto [mass, left] = std::pair(intervals[k].mass, intervals[k].left);
      for (const Change &change : changes_between(mass, omegas[left], omegas[left + 1]))
        intervals[k].points.push_back(locate(change, mass));
    } catch (...) {
#pragma omp critical
      failure = std::current_exception();
    }
  }
  if (failure) std::rethrow_exception(failure);

  std::vector<BifurcationPoint> points;
  for (const Interval &interval : intervals)
    points.insert(points.end(), interval.points.begin(), interval.points.end());
  std::sort(points.begin(), points.end(), [](const auto &a, const auto &b) {
    return a.omega.value < b.omega.value;
  });
  for (std::size_t i = points.size(); i-- > 0;) {
    const auto same = [&](const BifurcationPoint &other) { return other.symbol == points[i].symbol; };
    const auto index = std::count_if(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(i), same);
    if (points[i].symbol.starts_with("border")) points[i].symbol += fmt::format("_{}", index + 1);
  }
  return points;
}

// Columns of the table of points. All numbers in it are computed; the error is the larger of the
// estimate of the method and the distance between the two methods.
inline Table bifurcation_table(const std::vector<BifurcationPoint> &points) {
  Table table("symbol,value,error,kind,method,check,checked_by");
  for (const BifurcationPoint &point : points)
    table.row(point.symbol, point.omega.value,
              std::max(point.omega.error, std::abs(point.omega.value - point.check)), "computed",
              point.method, point.check, point.checked_by);
  return table;
}

}  // namespace vibro_impact::figures
