#include "long_flight.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "simulation/chain/tolerances.hpp"

namespace vibro_impact::detail {

void LongFlight::begin(const Chain &chain, const Clock &clock,
                       std::shared_ptr<const ModalForm> form, const Motion &motion,
                       const std::vector<Start> &starts, double flown) {
  form_ = std::move(form);
  start_ = modal_state(chain, *form_, motion);
  forces_ = forces_from(*form_, motion);
  starts_ = starts;
  motion_tau_ = -1.0;
  omega_ = chain.omega;
  turn_ = std::max(form_->fastest, omega_);
  evaluations_ = 0;
  is_at_event_ = false;
  longest_ = longest_step;
  coordinates_.assign(form_->size(), {});
  for (std::size_t j = 0; j < form_->size(); ++j) {
    const Oscillator<double> &o = form_->rounded[j];
    coordinates_[j].modulus = std::hypot(forces_[j].a.hi, forces_[j].b.hi);
    const double distance = std::hypot(o.lambda - omega_ * omega_, o.kappa * omega_);
    if (coordinates_[j].modulus > 0.0 && distance < near_resonance * (o.lambda + omega_ * omega_))
      longest_ = std::min(longest_, 1.0 / o.rate);
  }
  l_ = std::min(turn_ > 0.0 ? 1.0 / turn_ : longest_, longest_);
  evaluate(chain, clock, motion, flown);
}

double LongFlight::sign_of(std::size_t k) const {
  const Contact &contact = motion_.mode->contacts[k];
  return contact.held ? contact.sigma : -contact.sigma;
}

// Evaluates the motion and all contacts at the time u of the flight. The derivatives of a stiff
// coordinate cancel: they are found in twice the precision.
void LongFlight::evaluate(const Chain &chain, const Clock &clock, const Motion &start, double u) {
  u_ = u;
  at(chain, clock, start, u);
  const ComplexOf<Real> wave = wave_at(Real(u) * omega_);
  const double square = omega_ * omega_;
  for (std::size_t j = 0; j < coordinates_.size(); ++j) {
    Coordinate &c = coordinates_[j];
    const Oscillator<Real> &o = form_->exact[j];
    const ModalForce<Real> &f = forces_[j];
    const auto column = static_cast<Eigen::Index>(j);
    const Real &y = state_.y(column), &dy = state_.dy(column);
    const Real even = f.a * wave.re + f.b * wave.im, odd = f.b * wave.re - f.a * wave.im;
    const Real second = even + f.c - o.kappa * dy - o.lambda * y,
               third = omega_ * odd - o.kappa * second - o.lambda * dy,
               fourth = -(square * even) - o.kappa * third - o.lambda * second;
    c.force = {even.hi, odd.hi, f.c.hi};
    c.deviation = o.lambda.hi > 0.0 ? rounded(y - f.c / o.lambda) : y.hi;
    c.d[1] = dy.hi;
    c.d[2] = second.hi;
    c.d[3] = third.hi;
    c.d[4] = fourth.hi;
    // The energies of the second and of the third derivative grow by the forcing alone.
    const double root = std::sqrt(o.lambda.hi);
    c.third = std::hypot(c.d[3], root * c.d[2]);
    c.fourth = std::hypot(c.d[4], root * c.d[3]);
  }
  const double cosine = motion_.turn.cosine.hi, sine = motion_.turn.sine.hi;
  watch_forces_.clear();
  for (const Watch &w : form_->watches)
    watch_forces_.push_back({w.a * cosine + w.b * sine, w.b * cosine - w.a * sine, 0.0});
  values_.clear();
  for (const Contact &contact : motion_.mode->contacts)
    values_.push_back(detail::evaluate(chain, contact, motion_));
}

double LongFlight::safe_time(double l) const {
  double time = l;
  for (std::size_t k = 0; k < values_.size() && time > 0.0; ++k)
    if (!starts_[k].idle) time = std::min(time, bound_of(k, l).first_root(time));
  return time;
}

// The length of the next step of the search, in which no contact comes to zero. Bounds for a longer
// time are worse: the time for which they are made follows the step that they allow.
double LongFlight::next_step() {
  double step = safe_time(l_);
  while (step == l_ && l_ < longest_) {
    const double longer = std::min(4.0 * l_, longest_), next = safe_time(longer);
    if (next < 2.0 * step && next < longer) break;
    l_ = longer;
    step = next;
  }
  while (step < 0.25 * l_ && l_ * turn_ > 1.0) {
    l_ = std::max(0.25 * l_, 1.0 / turn_);
    step = std::max(step, safe_time(l_));
  }
  return step;
}

// True if an event is at u: a contact is zero, or has a simple root within the rounding of its
// time.
bool LongFlight::is_root() const {
  for (std::size_t k = 0; k < values_.size(); ++k) {
    const double value = values_[k].value.hi, rate = values_[k].rate.hi;
    if (!starts_[k].idle && rate <= 0.0 &&
        (value <= zero_threshold * values_[k].terms || value <= -time_rounding * u_ * rate))
      return true;
  }
  return false;
}

// The earliest root, which lies within rounding of u, by Newton's steps in twice the precision.
Real LongFlight::refined(const Chain &chain, const Clock &clock, const Motion &start,
                         std::vector<Near> &near) {
  const std::vector<Contact> &contacts = start.mode->contacts;
  Real tau = u_;
  std::fill(near.begin(), near.end(), Near::perhaps);
  for (int k = 0; k < exact_newton_steps; ++k) {
    Real earliest = infinity;
    std::size_t first = 0;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      if (starts_[i].idle) continue;
      const Value value = detail::evaluate(chain, contacts[i], at(chain, clock, start, tau));
      if (!(value.rate.hi < 0.0)) continue;
      const Real newton = -value.value / value.rate;
      if (!(newton < earliest)) continue;
      earliest = newton;
      first = i;
    }
    if (!(std::abs(earliest.hi) <= longest_correction * u_)) break;
    std::fill(near.begin(), near.end(), Near::perhaps);
    near[first] = Near::zero;
    if (earliest.hi == 0.0) break;
    tau += earliest;
  }
  return tau;
}

const Motion &LongFlight::at(const Chain &chain, const Clock &clock, const Motion &start,
                             const Real &tau) {
  if (tau == motion_tau_) return motion_;
  motion_tau_ = tau;
  motion_ = start;
  if (tau.hi == 0.0) {
    state_ = start_;
  } else {
    fly(*form_, omega_, start_, forces_, tau, state_);
    set_masses(*form_, state_, motion_);
    pass(tau, clock, motion_.now);
    set_turn(chain, motion_);
  }
  find_acceleration(chain, motion_);
  return motion_;
}

LongFlight::Result LongFlight::search(const Chain &chain, const Clock &clock, const Motion &start,
                                      double end, std::vector<Near> &near, long long &steps) {
  while (!is_at_event_) {
    const double l = l_, step = next_step();
    if (u_ + step >= end) {
      l_ = l;  // the next call makes this step
      return {Found::end_of_call};
    }
    const double before = u_;
    evaluate(chain, clock, start, u_ + step);
    ++steps;
    if (is_root() || u_ == before)
      is_at_event_ = true;
    else if (++evaluations_ >= most_search_steps)
      return {Found::nothing, u_};
  }
  // Also for a call that goes on after one that ended between u and the event.
  return {Found::event, refined(chain, clock, start, near)};
}

}  // namespace vibro_impact::detail
