// The forcing frequencies of Figures 2, 5(a) and 5(b), which the paper's text does not give.
//
// The rule of choice. A value of at most four decimals fits if the motion from rest fills the
// printed axes and does what the text says in the window shown. Among the values that fit, one that
// the paper prints of another figure comes first, then the one with the fewest decimals. The rule
// makes a value the most likely one. It does not make it known.
//
// The paper's plots are autoscaled: an axis ends at the first tick beyond the data. So each end of
// a printed axis says between which two ticks the extreme of the data lies. We assume that data
// which reach a stop exceed it a little, by the tolerance of the paper's simulation: an axis ends
// at 0.12 above a stop at 0.1, ticks 0.02 apart. A mass reaches its stop in every impact.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "reference/scenes/paper_scenes.hpp"
#include "runs.hpp"
#include "vibro_impact/analysis/sweep.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::figures {

// Whether data fill an axis of this range: at each end they lie within one tick of it. An extreme
// on a tick counts for either side of it, to within the rounding of the data.
inline bool fills(const Range &data, const Range &axis, double tick) {
  constexpr double rounding = 1e-9;  // in ticks
  const auto within_a_tick = [&](double distance) {
    return distance >= -rounding * tick && distance <= (1.0 + rounding) * tick;
  };
  return within_a_tick(data.lowest - axis.lowest) && within_a_tick(axis.highest - data.highest);
}

inline bool fills_ordinate(const Range &data, const paper::AxisBox &box) {
  return fills(data, {box.lowest, box.highest}, box.tick);
}

// A figure at one trial frequency: which of its conditions the motion meets, in their order.
struct Trial {
  double omega = 0.0;
  std::vector<bool> met = {};

  bool fits() const {
    return std::all_of(met.begin(), met.end(), [](bool condition) { return condition; });
  }
};

// A window has 2000 samples: an extreme is missed by (50 / 2000)^2 x'' / 8 at most, a thousandth of
// a tick.
inline SampleRecorder scan_samples(const paper::AxisBox &box) {
  return {box.from, box.to, (box.to - box.from) / 2000.0};
}

// The displacements of these masses that a window shows: their samples, and their stops if they hit
// them there.
inline Range shown(const Scene &scene, const std::vector<int> &masses,
                   const SampleRecorder &samples, const std::vector<Event> &events) {
  Range range;
  for (const int mass : masses) {
    const Range sampled = range_of(samples, mass);
    range.include(sampled.lowest);
    range.include(sampled.highest);
    for (const Event &event : events)
      if (event.mass == mass && event.kind == EventKind::impact && event.time >= samples.from &&
          event.time <= samples.to)
        range.include(stop_of(scene, event).position);
  }
  return range;
}

constexpr double never = std::numeric_limits<double>::quiet_NaN();

// A chatter that ends in sticking. All times are `never` if there is none.
struct Chatter {
  double first_impact = never;      // since the mass was released
  double last_bounce_ends = never;  // of the flights higher than `height`
  double stick = never;
};

// The first chatter of a mass that ends in sticking after `from`, with its flights higher than
// `height`. A flight of duration T that begins at speed v rises by v T / 4, because the
// acceleration is nearly constant over a late flight of a chatter.
inline Chatter chatter_after(std::vector<Event> events, int mass, double from,
                             double height = 0.0) {
  std::erase_if(events, [mass](const Event &event) { return event.mass != mass; });
  const auto stick = std::ranges::find_if(events, [from](const Event &event) {
    return event.kind == EventKind::stick && event.time >= from;
  });
  if (stick == events.end()) return {};
  Chatter chatter{.stick = stick->time};
  for (auto next = stick; next != events.begin(); --next) {  // back through the impacts before it
    const Event &impact = *std::prev(next);
    if (impact.kind != EventKind::impact) break;
    chatter.first_impact = impact.time;
    const double rise = std::abs(impact.velocity_after) * (next->time - impact.time) / 4;
    if (next != stick && rise > height && std::isnan(chatter.last_bounce_ends))
      chatter.last_bounce_ends = next->time;
  }
  return chatter;
}

// A plot does not show a height below a thousandth of its ordinate.
inline double invisible(const paper::AxisBox &box) {
  return (box.highest - box.lowest) / 1000.0;
}

// Figure 2. The text: each mass has one complete chatter and sticking period in every forcing
// period, and (b) is a close-up of the chatter of mass 2. So the window of (b) has to show the
// chatter from its first impact to the end of its last visible bounce. We assume that the author
// set its right end to the first tick beyond that bounce.
inline Trial try_figure2(double omega) {
  const Scene scene = paper::figure3(omega);
  const paper::AxisBox a = paper::panel("figure2a"), b = paper::panel("figure2b");
  SampleRecorder samples = scan_samples(a), close_up = scan_samples(b);
  const double ten_periods_before = a.to - 10.0 * Clock(omega).period;
  EventRecorder events{std::min(ten_periods_before, b.from - Clock(omega).period)};
  require_complete(simulate(scene, a.to, all_visible_chatter, samples, close_up, events));
  int sticks[] = {0, 0};
  for (const Event &event : events.events)
    if (event.kind == EventKind::stick && event.time >= ten_periods_before)
      ++sticks[event.mass - 1];
  const Chatter chatter = chatter_after(events.events, 2, b.from, invisible(b));
  return {omega,
          {fills_ordinate(shown(scene, {1, 2}, samples, events.events), a),
           fills_ordinate(shown(scene, {2}, close_up, events.events), b),
           sticks[0] == 10 && sticks[1] == 10,
           chatter.first_impact >= b.from && chatter.last_bounce_ends <= b.to}};
}

// Figure 5(a). The text: mass 1 has a complete chatter and sticking sequence, mass 2 has two
// impacts during its sticking phase. The window shows a bounce of that chatter, the stick and both
// impacts. Earlier impacts of mass 1 may lie before the window.
inline Trial try_figure5a(double omega) {
  const Scene scene = with(paper::figure5a(), "omega", omega);
  const paper::AxisBox box = paper::panel("figure5a");
  const double period = Clock(omega).period;
  SampleRecorder samples = scan_samples(box);
  EventRecorder events{box.from - period};
  require_complete(simulate(scene, box.to + period, all_visible_chatter, samples, events));
  const Chatter chatter = chatter_after(events.events, 1, box.from, invisible(box));
  int impacts = 0;  // of mass 2 while mass 1 sticks
  double last = never;
  for (const Event &event : events.events) {
    if (!(event.time > chatter.stick)) continue;
    if (event.mass == 1) break;  // its release
    if (event.kind != EventKind::impact) continue;
    ++impacts;
    last = event.time;
  }
  return {omega,
          {fills_ordinate(shown(scene, {1, 2}, samples, events.events), box),
           chatter.last_bounce_ends >= box.from && chatter.stick <= box.to,
           impacts == 2 && last <= box.to}};
}

// Figure 5(b). The text: at t of about 920 mass 2 grazes its stop while mass 1 is stuck. Grazing is
// to come so close that a plot does not show the gap. About 920 is nearer to 920 than to 919 or
// 921. A mass that sticks stands exactly where its stop is.
inline Trial try_figure5b(double omega) {
  const Scene scene = with(paper::figure5b(), "omega", omega);
  const paper::AxisBox box = paper::panel("figure5b");
  SampleRecorder samples = scan_samples(box);
  EventRecorder events{box.from};
  require_complete(simulate(scene, box.to, all_visible_chatter, samples, events));
  double time = never, gap = infinity;  // mass 2 nearest its stop
  for (std::size_t i = 0; i < samples.times.size(); ++i) {
    const double x1 = displacement(samples, i, 1), x2 = displacement(samples, i, 2);
    if (x1 != scene.stops[0].position || !(scene.stops[1].position - x2 < gap)) continue;
    time = samples.times[i];
    gap = scene.stops[1].position - x2;
  }
  return {omega,
          {fills_ordinate(shown(scene, {1, 2}, samples, events.events), box),
           gap <= invisible(box) && std::abs(time - 920.0) <= 0.5}};
}

// A figure whose frequency is inferred, the names of its conditions, and the scene drawn.
struct InferredFigure {
  const char *name;
  Trial (*attempt)(double omega);
  std::vector<const char *> conditions;
  Scene drawn;
};

inline std::vector<InferredFigure> inferred_figures() {
  return {{"2",
           try_figure2,
           {"displacements fill the axes of (a)", "x₂ fills the axes of (b)",
            "each mass sticks once a period", "(b) shows the visible bounces of mass 2"},
           paper::figure2()},
          {"5(a)",
           try_figure5a,
           {"displacements fill the axes", "mass 1 chatters and sticks in the window",
            "mass 2 hits twice while mass 1 sticks"},
           paper::figure5a()},
          {"5(b)",
           try_figure5b,
           {"displacements fill the axes", "mass 2 grazes at 920 as mass 1 sticks"},
           paper::figure5b()}};
}

// The number of decimals of a multiple of 1e-4.
inline int decimals(double omega) {
  long digits = std::lround(omega * 1e4);
  int count = 4;
  for (; count > 0 && digits % 10 == 0; digits /= 10) --count;
  return count;
}

// Whether the paper prints this frequency, of Figure 4 or of Figure 5(c).
inline bool is_printed(double omega) {
  return omega == paper::figure4a().omega || omega == paper::figure4b().omega ||
         omega == paper::figure5c().omega;
}

// The rule of choice among the frequencies that fit. Throws std::runtime_error if none does, or if
// the rule leaves several.
inline double choice_among(std::vector<double> fitting) {
  const auto rank = [](double omega) { return is_printed(omega) ? 0 : 1 + decimals(omega); };
  std::ranges::sort(fitting, {}, rank);
  if (fitting.empty() || (fitting.size() > 1 && rank(fitting[0]) == rank(fitting[1])))
    throw std::runtime_error(
        fmt::format("the rule of choice leaves none or several of {} that fit", fitting.size()));
  return fitting.front();
}

// Tries every multiple of 1e-4 from `from` to `to`, in order.
inline std::vector<Trial> scan(double from, double to, Trial (*attempt)(double omega)) {
  const long first = std::lround(from * 1e4), last = std::lround(to * 1e4);
  return sweep(static_cast<std::size_t>(last - first + 1), [&](std::size_t i) {
    return attempt(static_cast<double>(first + static_cast<long>(i)) / 1e4);
  });
}

}  // namespace vibro_impact::figures
