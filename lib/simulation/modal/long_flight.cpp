#include "long_flight.hpp"

#include <algorithm>
#include <cmath>

#include "simulation/chain/tolerances.hpp"

namespace vibro_impact::detail {

bool LongFlight::takes_over(const Chain &chain, long long quiet_steps) const {
  const auto n = static_cast<long long>(chain.masses);
  return is_under_way() || quiet_steps >= fewest_short_steps + n * n / short_steps_divisor;
}

void LongFlight::end(const Chain &chain, const Real &tau, Motion &motion) {
  origin_ = at(chain, tau);
  motion = origin_;
  form_ = nullptr;
}

void LongFlight::begin(const Chain &chain, Motion &motion) {
  const Real flown = elapsed(origin_.now, motion.now, chain.clock);
  motion = origin_;
  form_ = std::make_shared<const ModalForm>(modal_form(chain, motion, blocks_));
  motion_tau_ = -1.0;
  is_at_event_ = false;
  coordinates_.assign(form_->size(), {});
  l_ = form_->fastest > 0.0 ? 1.0 / form_->fastest : longest_step;
  evaluate(chain, rounded(flown));
  sight_.clear();
  for (const Value &value : values_)
    sight_.push_back(value.is_zero() ? Sight::hidden : Sight::seen);
}

// True when a hidden contact is seen below zero. One that is seen above zero is hidden no more.
bool LongFlight::look_at_hidden() {
  bool below = false;
  for (std::size_t k = 0; k < sight_.size(); ++k) {
    if (sight_[k] != Sight::hidden || values_[k].is_zero()) continue;
    if (values_[k].value.hi > 0.0)
      sight_[k] = Sight::seen;
    else
      below = true;
  }
  return below;
}

// Evaluates what bounds need at a time of the flight, which has been searched to there.
void LongFlight::evaluate(const Chain &chain, double time) {
  searched_to_ = time;
  find_values(chain, time);
  turn_ = motion_.turn;
  const ComplexOf<Real> wave = wave_at(Real(time) * form_->omega);
  for (std::size_t j = 0; j < coordinates_.size(); ++j) {
    Coordinate &c = coordinates_[j];
    const ModalForce &f = form_->forces[j];
    const Real &lambda = form_->oscillators[j].lambda;
    c.y = state_.y(static_cast<Eigen::Index>(j));
    c.dy = state_.dy(static_cast<Eigen::Index>(j));
    c.force = {f.a * wave.re + f.b * wave.im, f.b * wave.re - f.a * wave.im, f.c};
    c.deviation = lambda.hi > 0.0 ? c.y - f.c / lambda : c.y;
  }
}

// Evaluates the motion and the contacts at a time of the flight.
void LongFlight::find_values(const Chain &chain, const Real &tau) {
  at(chain, tau);
  values_.clear();
  for (const Contact &contact : motion_.mode->contacts)
    values_.push_back(detail::evaluate(chain, contact, motion_));
}

// A time up to l in which no contact comes to zero.
double LongFlight::safe_time(double l, Counters &counters) {
  double time = l;
  for (std::size_t k = 0; k < values_.size() && time > 0.0; ++k) {
    if (sight_[k] != Sight::seen) continue;
    const std::optional<double> root = first_root(bound_of(k, l), time / l, counters);
    if (root) time = *root > 0.0 && *root < infinity ? *root * l : 0.0;
  }
  return time;
}

// The length of the next step of the search, in which no contact comes to zero. Bounds for a longer
// time are worse: the time for which they are made follows the step that they allow.
double LongFlight::next_step(Counters &counters) {
  const double longest = std::min(longest_blind_step(), longest_step);
  l_ = std::min(l_, longest);
  double step = safe_time(l_, counters);
  while (step == l_ && l_ < longest) {
    const double longer = std::min(4.0 * l_, longest), next = safe_time(longer, counters);
    if (next < 2.0 * step && next < longer) break;
    l_ = longer;
    step = next;
  }
  while (step < 0.25 * l_ && l_ * form_->fastest > 1.0) {
    l_ = std::max(0.25 * l_, 1.0 / form_->fastest);
    step = std::max(step, safe_time(l_, counters));
  }
  return step;
}

// The earliest of the steps of Newton's to a root of a contact.
LongFlight::NewtonStep LongFlight::newton_step() const {
  NewtonStep earliest;
  for (std::size_t k = 0; k < values_.size(); ++k) {
    if (sight_[k] != Sight::seen || !(values_[k].slope.hi < 0.0)) continue;
    const Real time = -values_[k].value / values_[k].slope;
    if (time < earliest.time) earliest = {time, k};
  }
  return earliest;
}

// The earliest root, which lies within rounding of `searched_to_`, by Newton's steps in twice the
// precision, each at most half as long as the one before. A radian may be as short as 1e-12 of the
// flight, so that one step is not enough.
Real LongFlight::refined(const Chain &chain, std::vector<Near> &near) {
  const List<Contact> &contacts = origin_.mode->contacts;
  Real tau = searched_to_;
  find_values(chain, tau);
  near.assign(contacts.size(), Near::perhaps);
  if (look_at_hidden()) {
    for (std::size_t k = 0; k < sight_.size(); ++k)
      if (sight_[k] == Sight::hidden && !values_[k].is_zero())
        near[k] = contacts[k].held ? Near::zero : Near::rest;
    return tau;
  }
  double longest = step_rounding * searched_to_;
  for (NewtonStep step = newton_step(); std::abs(step.time.hi) <= longest; step = newton_step()) {
    std::fill(near.begin(), near.end(), Near::perhaps);
    near[step.contact] = Near::zero;
    if (step.time.hi == 0.0) break;
    longest = 0.5 * std::abs(step.time.hi);
    tau += step.time;
    find_values(chain, tau);
  }
  const auto touches = [&](std::size_t k) {
    if (!contacts[k].held) return false;
    const Polynomial p = bound_of(k, l_);
    return only_touches(values_[k].value.hi, p.coefficient[1], p.coefficient[2],
                        sum_of_forces(chain, contacts[k].mass, motion_));
  };
  for (std::size_t k = 0; k < contacts.size(); ++k)
    if (touches(k)) near[k] = Near::touch;
  return tau;
}

const Motion &LongFlight::at(const Chain &chain, const Real &tau) {
  if (tau == motion_tau_) return motion_;
  motion_tau_ = tau;
  motion_ = origin_;
  if (tau.hi == 0.0) {
    state_ = form_->start;
  } else {
    fly(*form_, tau, state_);
    set_masses(*form_, state_, motion_);
    pass(tau, chain.clock, motion_.now);
    set_turn(chain, motion_);
  }
  find_acceleration(chain, motion_);
  return motion_;
}

// Goes back to the time, after `before`, at which a hidden contact is first seen below zero.
// Returns false at a time at which one is seen above zero: the search goes on from there.
bool LongFlight::find_appearance(const Chain &chain, double before, Counters &counters) {
  const auto hidden = std::ranges::count(sight_, Sight::hidden);
  double after = searched_to_;
  while (after - before > step_rounding * after) {
    const double middle = before + 0.5 * (after - before);
    if (middle == before || middle == after) break;  // next to 0 no time lies between
    evaluate(chain, middle);
    ++counters.search_steps;
    const bool appears = look_at_hidden();
    if (!appears && std::ranges::count(sight_, Sight::hidden) < hidden) return false;
    (appears ? after : before) = middle;
  }
  evaluate(chain, after);
  return true;
}

FlightEnd LongFlight::search(const Chain &chain, double end, long long most_steps,
                             std::vector<Near> &near, Counters &counters) {
  const long long last = counters.search_steps + most_steps;
  while (!is_at_event_) {
    const double l = l_, step = next_step(counters);
    // The step goes beyond the end of the call where a hidden contact may appear: it may do so
    // before that end.
    const bool is_last = searched_to_ + step >= end && longest_blind_step() == infinity;
    if (searched_to_ >= end || is_last) {
      l_ = l;  // the next call makes this step
      return {infinity, false};
    }
    const double before = searched_to_;
    evaluate(chain, searched_to_ + step);
    ++counters.search_steps;
    const bool appears = look_at_hidden() && find_appearance(chain, before, counters);
    const bool is_root = newton_step().time.hi <= step_rounding * searched_to_;
    // A search that no longer moves has come to rounding: short steps go on from there.
    is_at_event_ = appears || is_root || searched_to_ == before;
    if (!is_at_event_ && counters.search_steps >= last) return {searched_to_, false};
  }
  // Also for a call that goes on after one that ended between `searched_to_` and the event.
  return {refined(chain, near), true};
}

}  // namespace vibro_impact::detail
