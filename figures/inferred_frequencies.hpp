// The forcing frequencies of Figures 2, 5(a) and 5(b), which the paper's text does not give. A
// value of four decimals fits a figure if the motion fills the printed axes and does what the text
// says. Where several values fit, the one drawn is our choice among them, and nothing computed
// prefers it.
//
// The paper's plots are autoscaled: an axis ends at the first tick beyond the data. So each end of
// a printed axis says between which two ticks the extreme of the data lies. We assume that data
// which reach a stop exceed it a little, by the tolerance of the paper's simulation: an axis ends
// at 0.12 above a stop at 0.1, ticks 0.02 apart.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "figures/panel.hpp"
#include "reference/paper_scenes.hpp"
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
inline bool fills_abscissa(const Range &data, const paper::AxisBox &box) {
  return fills(data, {box.from, box.to}, box.tick_across);
}

// A figure at one trial frequency. `lowest` is the lowest displacement in the panel drawn.
struct Trial {
  double omega = 0.0, lowest = 0.0;
  bool boxes = false;  // the displacements fill the printed axes
  bool text = false;   // the motion does what the text says, in the window shown
};

// A window has 2000 samples: an extreme is missed by (50 / 2000)^2 x'' / 8 at most, a thousandth of
// a tick.
inline SampleRecorder scan_samples(const paper::AxisBox &box) {
  return samples_across(box, (box.to - box.from) / 2000.0);
}

constexpr double never = std::numeric_limits<double>::quiet_NaN();

// A chatter that ends in sticking: its first impact and the stick, or `never`.
inline Range chatter_in(const std::vector<Event> &events, int mass, const paper::AxisBox &box) {
  double first_impact = never;  // since the mass was released
  for (const Event &event : events) {
    if (event.mass != mass || event.time > box.to) continue;
    if (event.kind == EventKind::release) first_impact = never;
    if (event.kind == EventKind::impact && std::isnan(first_impact)) first_impact = event.time;
    if (event.kind == EventKind::stick && event.time >= box.from) return {first_impact, event.time};
  }
  return {never, never};
}

// Figure 2. The text: each mass has one complete chatter and sticking period in every forcing
// period, and (b) is a close-up of the chatter of mass 2. We assume that the window of (b) ends at
// the first ticks beyond that chatter.
inline Trial try_figure2(double omega) {
  const paper::AxisBox &a = paper::figure2a_box, &b = paper::figure2b_box;
  SampleRecorder samples = scan_samples(a), close_up = scan_samples(b);
  EventRecorder events{a.to - 10.0 * Clock(omega).period};
  require_complete(simulate(paper::stops_of_different_sign(omega), a.to, all_visible_chatter,
                            samples, close_up, events));
  int sticks[] = {0, 0};
  for (const Event &event : events.events)
    if (event.kind == EventKind::stick) ++sticks[event.mass - 1];
  const Range close = range_of(close_up, 2);
  return {omega, close.lowest, fills_ordinate(range_of(samples), a) && fills_ordinate(close, b),
          sticks[0] == 10 && sticks[1] == 10 && fills_abscissa(chatter_in(events.events, 2, b), b)};
}

// Figure 5(a). The text: mass 1 has a complete chatter and sticking sequence, mass 2 has two
// impacts during its sticking phase. All of that is shown.
inline Trial try_figure5a(double omega) {
  Scene scene = paper::figure5a();
  scene.omega = omega;
  const paper::AxisBox &box = paper::figure5a_box;
  const double period = Clock(omega).period;
  SampleRecorder samples = scan_samples(box);
  EventRecorder events{box.from - period};
  require_complete(simulate(scene, box.to + period, all_visible_chatter, samples, events));
  const Range chatter = chatter_in(events.events, 1, box), data = range_of(samples);
  int impacts = 0;  // of mass 2 while mass 1 sticks
  double last = never;
  for (const Event &event : events.events) {
    if (!(event.time > chatter.highest)) continue;
    if (event.mass == 1) break;
    ++impacts;
    last = event.time;
  }
  return {omega, data.lowest, fills_ordinate(data, box),
          chatter.lowest >= box.from && impacts == 2 && last <= box.to};
}

// Figure 5(b). The text: at t of about 920 mass 2 grazes its stop while mass 1 is stuck. Grazing is
// to come within what a plot can show, a thousandth of the box; about 920 is nearer to 920 than to
// 919 or 921. A mass that sticks stands exactly where its stop is.
inline Trial try_figure5b(double omega) {
  Scene scene = paper::figure5b();
  scene.omega = omega;
  const paper::AxisBox &box = paper::figure5b_box;
  SampleRecorder samples = scan_samples(box);
  require_complete(simulate(scene, box.to, all_visible_chatter, samples));
  const Range data = range_of(samples);
  double time = never, gap = std::numeric_limits<double>::infinity();  // mass 2 nearest its stop
  for (std::size_t i = 0; i < samples.times.size(); ++i) {
    const double x1 = samples.displacements[2 * i], x2 = samples.displacements[2 * i + 1];
    if (x1 != scene.stops[0].position || !(scene.stops[1].position - x2 < gap)) continue;
    time = samples.times[i];
    gap = scene.stops[1].position - x2;
  }
  return {omega, data.lowest, fills_ordinate(data, box),
          gap <= (box.highest - box.lowest) / 1000.0 && std::abs(time - 920.0) <= 0.5};
}

// Tries every multiple of 1e-4 from `from` to `to`, in order.
inline std::vector<Trial> scan(double from, double to, Trial (*attempt)(double omega)) {
  const long first = std::lround(from * 1e4), last = std::lround(to * 1e4);
  return sweep(static_cast<std::size_t>(last - first + 1), [&](std::size_t i) {
    return attempt(static_cast<double>(first + static_cast<long>(i)) / 1e4);
  });
}

}  // namespace vibro_impact::figures
