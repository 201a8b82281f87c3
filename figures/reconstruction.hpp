// The frequencies that the paper's text does not give: which values of four digits, as many as the
// printed ones have, fill the printed axis boxes (axis_rule.hpp) and do what the text says of the
// figure, and by what number those left are told apart.
//
// The boxes and the text are the rule. Where they leave more than one value the rest is a choice,
// and said to be one.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "axis_rule.hpp"
#include "figures/figure3.hpp"
#include "figures/panel.hpp"
#include "figures/parallel.hpp"
#include "reference/paper_scenes.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::figures {

// Scanned: from where a forcing period is longer than any window but Figure 5(c)'s up to the end of
// the sticking region (printed: 0.5).
constexpr Range scanned{0.1, 0.5};

// Figure 2 is the paper's example of low forcing frequencies, before the chatter of mass 1 becomes
// incomplete at about 0.3 (printed, Section 3.2).
constexpr Range scanned_of_figure2{0.1, 0.3};

constexpr double never = std::numeric_limits<double>::quiet_NaN();

// What a frequency makes of a figure.
struct Trial {
  double omega;
  std::vector<AxisCheck> axes;                               // that of the table's columns first
  std::vector<std::pair<std::string, double>> columns = {};  // what else the text is about
  bool text = false;  // the motion does what the text says, with what that says of the time axis
  // Of those left the one with the least is chosen.
  double apart = std::numeric_limits<double>::infinity();

  bool boxes() const {
    return std::all_of(axes.begin(), axes.end(), [](const AxisCheck &check) {
      return check.quantity == "t" || check.passes();
    });
  }
  bool passes() const {
    return boxes() && text;
  }
  double at(const std::string &column) const {
    for (const auto &[name, value] : columns)
      if (name == column) return value;
    throw std::out_of_range(column);
  }
};

// A window has 2000 samples: an extreme is missed by (50 / 2000)^2 x'' / 8 at most, a thousandth of
// a tick.
inline SampleRecorder scan_samples(const paper::AxisBox &box) {
  return samples_across(box, (box.to - box.from) / 2000.0);
}

// A chatter that ends in sticking: the times of its impacts, and of the stick (`never`: there is
// none).
struct StickingChatter {
  std::vector<double> impacts = {};
  double complete = never;
  std::size_t stick = 0;  // its place among the events

  double begins() const {
    return impacts.empty() ? never : impacts.front();
  }
};

// The chatter of `mass` that ends first in [from, to]: all impacts since the mass was let go.
inline StickingChatter chatter_in(const std::vector<Event> &events, int mass, double from,
                                  double to) {
  StickingChatter chatter;
  for (std::size_t i = 0; i < events.size() && events[i].time <= to; ++i) {
    if (events[i].mass != mass) continue;
    if (events[i].kind == EventKind::release) chatter.impacts.clear();
    if (events[i].kind == EventKind::impact) chatter.impacts.push_back(events[i].time);
    if (events[i].kind != EventKind::stick || events[i].time < from) continue;
    chatter.complete = events[i].time;
    chatter.stick = i;
    return chatter;
  }
  return {};
}

// How far the peaks of a chatter of mass 2 are from falling as the powers of r^2, which is their
// law near the limit: the largest |log| of the ratio of two consecutive ones over r^2. Peaks lower
// than `visible` do not count.
inline double unevenness(const Scene &scene, const StickingChatter &chatter,
                         const SampleRecorder &samples, double visible) {
  const double law = scene.restitution * scene.restitution, stop = scene.stops[1].position;
  double previous = 0.0, most = 0.0;
  std::size_t sample = 0;
  for (std::size_t k = 0; k + 1 < chatter.impacts.size(); ++k) {
    double peak = 0.0;
    for (; sample < samples.times.size() && samples.times[sample] < chatter.impacts[k + 1];
         ++sample)
      if (samples.times[sample] > chatter.impacts[k])
        peak = std::max(peak, stop - samples.displacements[2 * sample + 1]);
    if (peak < visible) break;
    if (k > 0) most = std::max(most, std::abs(std::log(peak / previous / law)));
    previous = peak;
  }
  return most;
}

// Figure 2. The text: each mass has one complete chatter and sticking period in every forcing
// period; (b) is a close-up of the chatter of mass 2, its peaks diminishing approximately
// exponentially. So the window of (b) ends at the first ticks beyond that chatter, and of those
// left the one whose peaks are nearest to exponential is chosen.
inline Trial try_figure2(double omega) {
  const Scene scene = paper::stops_of_different_sign(omega);
  const paper::AxisBox &a = paper::figure2a_box, &b = paper::figure2b_box;
  SampleRecorder samples = scan_samples(a), close_up = scan_samples(b);
  EventRecorder events{a.to - 10.0 * Clock(omega).period};
  require_complete(simulate(scene, a.to, all_visible_chatter, samples, close_up, events));

  int sticks[] = {0, 0};
  for (const Event &event : events.events)
    if (event.kind == EventKind::stick) ++sticks[event.mass - 1];
  const StickingChatter chatter = chatter_in(events.events, 2, b.from, b.to);
  const AxisCheck whole_chatter = across("2(b)", b, {chatter.begins(), chatter.complete});
  const Range close = range_of(close_up, 2);
  Trial trial{
      omega,
      {upwards("2(a)", "x", a, range_of(samples)), upwards("2(b)", "x2", b, close), whole_chatter}};
  trial.text = sticks[0] == 10 && sticks[1] == 10 && whole_chatter.passes();
  if (trial.text)
    trial.apart = unevenness(scene, chatter, close_up, (b.highest - b.lowest) / 500.0);
  trial.columns = {{"lowest_x2_in_b", close.lowest},
                   {"begins", chatter.begins()},
                   {"complete", chatter.complete},
                   {"unevenness", trial.apart}};
  return trial;
}

// Figure 5(a). The text: mass 1 has a complete chatter and sticking sequence, mass 2 has two
// impacts during its sticking phase. All of that is shown; of those left the one whose sticking
// phase ends nearest to the end of the window is chosen.
inline Trial try_figure5a(double omega) {
  Scene scene = paper::figure5a();
  scene.omega = omega;
  const paper::AxisBox &box = paper::figure5a_box;
  const double period = Clock(omega).period;
  SampleRecorder samples = scan_samples(box);
  EventRecorder events{box.from - period};
  require_complete(simulate(scene, box.to + period, all_visible_chatter, samples, events));

  const StickingChatter chatter = chatter_in(events.events, 1, box.from, box.to);
  double released = never, last_impact = never;  // of mass 2 while mass 1 sticks
  int impacts = 0;
  for (std::size_t i = chatter.stick + 1; chatter.stick > 0 && i < events.events.size(); ++i) {
    const Event &event = events.events[i];
    if (event.mass == 1) {
      released = event.time;
      break;
    }
    ++impacts;
    last_impact = event.time;
  }
  Trial trial{omega,
              {upwards("5(a)", "x", box, range_of(samples))},
              {{"begins", chatter.begins()},
               {"complete", chatter.complete},
               {"released", released},
               {"impacts", impacts}}};
  trial.text = chatter.begins() >= box.from && impacts == 2 && last_impact <= box.to;
  if (trial.text) trial.apart = std::abs(released - box.to);
  return trial;
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

  double time = never, gap = std::numeric_limits<double>::infinity();  // mass 2 nearest its stop
  for (std::size_t i = 0; i < samples.times.size(); ++i) {
    const double x1 = samples.displacements[2 * i], x2 = samples.displacements[2 * i + 1];
    if (x1 != scene.stops[0].position || !(scene.stops[1].position - x2 < gap)) continue;
    time = samples.times[i];
    gap = scene.stops[1].position - x2;
  }
  Trial trial{omega,
              {upwards("5(b)", "x", box, range_of(samples))},
              {{"nearest_time", time}, {"gap", gap}}};
  trial.apart = std::abs(time - 920.0);
  trial.text = gap <= (box.highest - box.lowest) / 1000.0 && trial.apart <= 0.5;
  return trial;
}

// Tries every multiple of 1e-4 in the range; in order.
inline std::vector<Trial> scan(const Range &range, Trial (*attempt)(double omega)) {
  const long first = std::lround(range.lowest * 1e4), last = std::lround(range.highest * 1e4);
  std::vector<Trial> trials(static_cast<std::size_t>(last - first + 1));
  in_parallel(trials.size(), [&](std::size_t i) {
    trials[i] = attempt(static_cast<double>(first + static_cast<long>(i)) / 1e4);
  });
  return trials;
}

// Whether a frequency is left by boxes and text, within the range in question.
inline bool is_left(const Trial &trial, const Range &range) {
  return trial.passes() && trial.omega >= range.lowest && trial.omega < range.highest;
}

// The frequency chosen among those left (`never` where there is none).
inline double chosen(const std::vector<Trial> &trials, const Range &range) {
  const Trial *best = nullptr;
  for (const Trial &trial : trials)
    if (is_left(trial, range) && (best == nullptr || trial.apart < best->apart)) best = &trial;
  return best == nullptr ? never : best->omega;
}

// --- Where nothing had to be inferred: the figures whose parameters are printed ----------------

// Impact velocities of Figure 3 on a grid of `count` frequencies. From 181 on the extremes are met
// to a tenth of a tick.
inline std::vector<AxisCheck> checks_of_figure3(int count) {
  Range v1, v2;
  for (double omega : frequencies_of_figure3(count)) {
    const OrbitRecord record = record_of(paper::figure3(omega), recorded_in_figure3(40));
    for (double v : distinct(record.impact_velocities[0])) v1.include(v);
    for (double v : distinct(record.impact_velocities[1])) v2.include(v);
  }
  return {upwards("3(a)", "v1", paper::figure3a_box, v1),
          upwards("3(b)", "v2", paper::figure3b_box, v2)};
}

// Figure 4 shows a sticking phase, or two, and nothing else: its abscissa is data as well.
inline std::vector<AxisCheck> checks_of_figure4(const std::string &panel, const Scene &scene) {
  Range force, time;
  for (const HoldForceRecorder::Row &row : hold_force_rows(scene)) {
    force.include(row.force);
    time.include(row.time);
  }
  return {upwards(panel, "F2", paper::figure4_box, force), across(panel, paper::figure4_box, time)};
}

inline AxisCheck check_of_figure5c() {
  const paper::AxisBox &box = paper::figure5c_box;
  SampleRecorder samples = scan_samples(box);
  require_complete(simulate(paper::figure5c(), box.to, all_visible_chatter, samples));
  return upwards("5(c)", "x", box, range_of(samples));
}

}  // namespace vibro_impact::figures
