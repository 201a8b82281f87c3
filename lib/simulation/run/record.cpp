#include "vibro_impact/record.hpp"

#include <algorithm>
#include <cmath>

#include "simulation/chain/require.hpp"
#include "simulation/chain/tolerances.hpp"

namespace vibro_impact {

using detail::require;

MotionState state_at(const Moment &moment, const Held &held) {
  MotionState state{moment.instant, {}, {}, held};
  const int masses = moment.masses();
  for (std::vector<double> *list : {&state.displacement, &state.velocity})
    list->reserve(static_cast<std::size_t>(masses));
  for (int mass = 1; mass <= masses; ++mass) {
    state.displacement.push_back(moment.displacement(mass));
    state.velocity.push_back(moment.velocity(mass));
  }
  return state;
}

std::string contact_mode_name(const Held &held) {
  std::string text;
  for (std::size_t i = 0; i < held.size(); ++i)
    if (held[i] != 0) {
      if (!text.empty()) text.push_back('+');
      text += std::to_string(i + 1);
    }
  return text.empty() ? "-" : text;
}

void EventRecorder::event(const Event &event, const Moment &) {
  if (event.time < from) return;
  events.push_back(event);
}

double EventRecorder::slowest_impact(double first, double limit) const {
  return limit < from ? infinity : slowest_listed(slowest, first);
}

void EventRecorder::check(const Scene &) const {
  require(!std::isnan(from), "from = ", from, ": must be a time");
  if (slowest) require(*slowest >= 0.0, "slowest = ", *slowest, ": must be non-negative");
}

double sample_time(double from, double to, double every, std::size_t taken) {
  const double next = from + every * static_cast<double>(taken);
  return next <= to * (1.0 + detail::range_rounding) ? std::min(next, to) : infinity;
}

double SampleRecorder::next_time() const {
  return sample_time(from, to, every, times.size());
}

void SampleRecorder::sample(const Moment &moment) {
  times.push_back(moment.time);
  for (int i = 1; i <= moment.masses(); ++i) displacements.push_back(moment.displacement(i));
}

void SampleRecorder::check(const Scene &) const {
  require(std::isfinite(every) && every > 0.0, "every = ", every, ": must be positive and finite");
  require(std::isfinite(from) && std::isfinite(to), "samples from ", from, " to ", to,
          ": must be finite");
  require(!(from < to) || to + every > to, "every = ", every,
          ": must exceed the spacing of doubles at the latest sample, ", to);
}

}  // namespace vibro_impact
