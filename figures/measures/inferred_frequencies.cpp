#include "inferred_frequencies.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "vibro_impact/analysis/sweep.hpp"

namespace vibro_impact::figures {

bool fills(const Range &data, const Range &axis, double tick) {
  constexpr double rounding = 1e-9;  // in ticks
  const auto within_a_tick = [&](double distance) {
    return distance >= -rounding * tick && distance <= (1.0 + rounding) * tick;
  };
  return within_a_tick(data.lowest - axis.lowest) && within_a_tick(axis.highest - data.highest);
}

bool fills_ordinate(const Range &data, const paper::AxisBox &box) {
  return fills(data, {box.lowest, box.highest}, box.tick);
}

namespace {

// A window has 2000 samples: an extreme is missed by (50 / 2000)^2 x'' / 8 at most, a thousandth of
// a tick.
SampleRecorder scan_samples(const paper::AxisBox &box) {
  return {box.from, box.to, (box.to - box.from) / 2000.0};
}

}  // namespace

Range shown(const Scene &scene, const std::vector<int> &masses, const SampleRecorder &samples,
            const std::vector<Event> &events) {
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

Chatter chatter_after(std::vector<Event> events, int mass, double from, double height) {
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

double invisible(const paper::AxisBox &box) {
  return (box.highest - box.lowest) / 1000.0;
}

Trial try_figure2(double omega) {
  const Scene scene = paper::figure3(omega);
  const paper::AxisBox a = paper::panel("figure2a"), b = paper::panel("figure2b");
  SampleRecorder samples = scan_samples(a), close_up = scan_samples(b);
  const double ten_periods_before = a.to - 10.0 * Clock(omega).period;
  EventRecorder events{std::min(ten_periods_before, b.from - Clock(omega).period), infinity};
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

Trial try_figure5a(double omega) {
  const Scene scene = with(paper::figure5a(), "omega", omega);
  const paper::AxisBox box = paper::panel("figure5a");
  const double period = Clock(omega).period;
  SampleRecorder samples = scan_samples(box);
  EventRecorder events{box.from - period, infinity};
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

Trial try_figure5b(double omega) {
  const Scene scene = with(paper::figure5b(), "omega", omega);
  const paper::AxisBox box = paper::panel("figure5b");
  SampleRecorder samples = scan_samples(box);
  EventRecorder events{box.from, infinity};
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

Trial try_figure5c(double omega) {
  const Scene scene = with(paper::figure5c(), "omega", omega);
  const paper::AxisBox box = paper::panel("figure5c");
  SampleRecorder samples = scan_samples(box);
  EventRecorder events{box.from};
  require_complete(simulate(scene, box.to, samples, events));
  double last = never;  // impact of mass 2
  bool hits_until_the_release = false;
  for (const Event &event : events.events) {
    if (event.mass == 2 && event.kind == EventKind::impact) last = event.time;
    if (event.mass != 1 || event.kind != EventKind::release) continue;
    hits_until_the_release = event.time - last <= 10.0;
    break;
  }
  return {
      omega,
      {fills_ordinate(shown(scene, {1, 2}, samples, events.events), box), hits_until_the_release}};
}

std::vector<InferredFigure> inferred_figures() {
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
           paper::figure5b()},
          {"5(c)",
           try_figure5c,
           {"displacements fill the axes", "mass 2 hits until mass 1 is released"},
           paper::figure5c(),
           0.01,
           0.15}};
}

int decimals(double omega) {
  long digits = std::lround(omega * 1e4);
  int count = 4;
  for (; count > 0 && digits % 10 == 0; digits /= 10) --count;
  return count;
}

bool is_printed(double omega) {
  return omega == paper::figure4a().omega || omega == paper::figure4b().omega ||
         omega == paper::figure5c().omega;
}

double choice_among(std::vector<double> fitting) {
  const auto rank = [](double omega) { return is_printed(omega) ? 0 : 1 + decimals(omega); };
  std::ranges::sort(fitting, {}, rank);
  if (fitting.empty() || (fitting.size() > 1 && rank(fitting[0]) == rank(fitting[1])))
    throw std::runtime_error(
        fmt::format("the rule of choice leaves none or several of {} that fit", fitting.size()));
  return fitting.front();
}

std::vector<Trial> scan(double from, double to, Trial (*attempt)(double omega)) {
  const long first = std::lround(from * 1e4), last = std::lround(to * 1e4);
  return sweep(static_cast<std::size_t>(last - first + 1), [&](std::size_t i) {
    return attempt(static_cast<double>(first + static_cast<long>(i)) / 1e4);
  });
}

}  // namespace vibro_impact::figures
