#include "long_flight.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "simulation/chain/tolerances.hpp"

namespace vibro_impact::detail {

void LongFlight::begin(const Chain &chain, std::shared_ptr<const ModalForm> form,
                       const Motion &motion, const std::vector<Start> &starts) {
  form_ = std::move(form);
  state_ = modal_state(chain, *form_, motion);
  forces_ = forces_from(*form_, motion);
  contacts_ = motion.mode->contacts;
  starts_ = starts;
  omega_ = chain.omega;
  turn_ = std::max(form_->fastest, omega_);
  evaluations_ = 0;
  there_tau_ = -1.0;
  longest_ = longest_step;
  coordinates_.assign(form_->size(), {});
  for (std::size_t j = 0; j < form_->size(); ++j) {
    const Oscillator<double> &o = form_->rounded[j];
    const auto column = static_cast<Eigen::Index>(j);
    Coordinate &c = coordinates_[j];
    c.y0 = rounded(state_.y(column));
    c.dy0 = rounded(state_.dy(column));
    c.force = {rounded(forces_[j].a), rounded(forces_[j].b), rounded(forces_[j].c)};
    const Oscillator<Real> &exact = form_->exact[j];
    c.second0 = rounded(forces_[j].a + forces_[j].c - exact.kappa * state_.dy(column) -
                        exact.lambda * state_.y(column));
    c.modulus = std::hypot(c.force.a, c.force.b);
    const double distance = std::hypot(o.lambda - omega_ * omega_, o.kappa * omega_);
    if (c.modulus > 0.0 && distance < near_resonance * (o.lambda + omega_ * omega_))
      longest_ = std::min(longest_, 1.0 / o.rate);
  }
  const double cosine = rounded(motion.turn.cosine), sine = rounded(motion.turn.sine);
  waves_.clear();
  for (const Watch &w : form_->watches)
    waves_.push_back({w.a * cosine + w.b * sine, w.b * cosine - w.a * sine, 0.0});
  values_.assign(contacts_.size(), 0.0);
  rates_ = errors_ = values_;
  l_ = std::min(turn_ > 0.0 ? 1.0 / turn_ : longest_, longest_);
  evaluate(0.0);
}

double LongFlight::sign_of(std::size_t k) const {
  return contacts_[k].held ? contacts_[k].sigma : -contacts_[k].sigma;
}

// Evaluates the motion, and with it all contacts, at the time u of the flight.
void LongFlight::evaluate(double u) {
  u_ = u;
  const ComplexOf<double> wave = wave_at(omega_ * u);
  const double square = omega_ * omega_;
  for (std::size_t j = 0; j < coordinates_.size(); ++j) {
    Coordinate &c = coordinates_[j];
    const Oscillator<double> &o = form_->rounded[j];
    const ModalForce<double> &f = c.force;
    const ModalChange<double> d =
        u > 0.0 ? change(o, c.y0, c.dy0, f, omega_, u, wave) : ModalChange<double>{0.0, 0.0};
    c.change = d.y;
    c.slope = d.dy;
    c.d[0] = c.y0 + u * c.dy0 + d.y;
    c.d[1] = c.dy0 + d.dy;
    const double even = f.a * wave.re + f.b * wave.im,
                 odd = omega_ * (f.b * wave.re - f.a * wave.im);
    c.d[2] = even + f.c - o.kappa * c.d[1] - o.lambda * c.d[0];
    c.d[3] = odd - o.kappa * c.d[2] - o.lambda * c.d[1];
    c.d[4] = -square * even - o.kappa * c.d[3] - o.lambda * c.d[2];
    // The energies of y'' and of y''' grow by the forcing alone.
    const double root = std::sqrt(o.lambda);
    c.third = std::hypot(c.d[3], root * c.d[2]);
    c.fourth = std::hypot(c.d[4], root * c.d[3]);
  }
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const Watch &w = form_->watches[form_->watch_of[k]];
    double change_of = 0.0, rate = 0.0, terms = 0.0;
    for (std::size_t j = 0; j < coordinates_.size(); ++j) {
      const Coordinate &c = coordinates_[j];
      const double row = w.row[j], size = std::abs(row);
      change_of += row * (c.change + w.damping * (c.slope - u * c.second0));
      rate += row * (c.slope + w.damping * (c.d[2] - c.second0));
      // A rounded angle moves what turns by its rate.
      terms += size * (std::abs(c.change) + w.damping * std::abs(c.slope) +
                       u * (std::abs(c.d[1]) + w.damping * std::abs(c.d[2])));
    }
    if (w.a != 0.0 || w.b != 0.0) {
      const ModalForce<double> &f = waves_[form_->watch_of[k]];
      change_of += f.a * (wave.re - 1.0) + f.b * (wave.im - omega_ * u);
      rate += omega_ * (f.b * (wave.re - 1.0) - f.a * wave.im);
      terms += (1.0 + omega_ * u) * (std::abs(f.a) + std::abs(f.b));
    }
    const Start &start = starts_[k];
    values_[k] = start.value + u * start.rate + sign_of(k) * change_of;
    rates_[k] = start.rate + sign_of(k) * rate;
    errors_[k] = search_rounding * (std::abs(start.value) + u * std::abs(start.rate) + terms);
  }
}

double LongFlight::safe_time(double l) const {
  double time = l;
  for (std::size_t k = 0; k < contacts_.size() && time > 0.0; ++k)
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

// True if an event is at u. Contacts close to zero are evaluated in twice the precision.
bool LongFlight::is_root(const Chain &chain, const Clock &clock, const Motion &start,
                         std::vector<Near> &near) {
  bool root = false;
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const bool idle = starts_[k].idle;
    near[k] = !idle && values_[k] <= near_roundings * errors_[k] ? Near::perhaps : Near::no;
    if (idle || values_[k] > suspicious * errors_[k]) continue;
    const Value value = detail::evaluate(chain, contacts_[k], at(chain, clock, start, u_));
    values_[k] = rounded(value.value);
    rates_[k] = rounded(value.rate);
    // Zero, or a simple root within the rounding of its time.
    root = root || (rates_[k] <= 0.0 && (values_[k] <= zero_threshold * value.terms ||
                                         values_[k] <= -time_rounding * u_ * rates_[k]));
    values_[k] = std::max(values_[k], 0.0);
  }
  return root;
}

// The earliest root, which lies within rounding of u, by Newton's steps in twice the precision.
Real LongFlight::refined(const Chain &chain, const Clock &clock, const Motion &start,
                         const std::vector<Near> &near) {
  Real tau = u_;
  for (int k = 0; k < exact_newton_steps; ++k) {
    double earliest = infinity;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      if (near[i] == Near::no) continue;
      const Value value = detail::evaluate(chain, contacts_[i], at(chain, clock, start, tau));
      if (value.rate.hi < 0.0) earliest = std::min(earliest, rounded(-value.value / value.rate));
    }
    if (!(std::abs(earliest) <= longest_correction * u_) || earliest == 0.0) break;
    tau += earliest;
  }
  return tau;
}

const Motion &LongFlight::at(const Chain &chain, const Clock &clock, const Motion &start,
                             const Real &tau) {
  if (!(tau == there_tau_)) {
    fly(chain, clock, *form_, start, state_, forces_, tau, there_);
    there_tau_ = tau;
  }
  return there_;
}

LongFlight::Result LongFlight::search(const Chain &chain, const Clock &clock, const Motion &start,
                                      double end, std::vector<Near> &near, long long &steps) {
  while (true) {
    const double l = l_, step = next_step();
    if (u_ + step >= end) {
      l_ = l;  // the next call makes this step
      return {Found::end_of_call};
    }
    const double before = u_;
    evaluate(u_ + step);
    ++steps;
    const bool root = is_root(chain, clock, start, near);
    if (root || u_ == before) return {Found::event, refined(chain, clock, start, near)};
    if (++evaluations_ >= most_search_steps) return {Found::nothing, u_};
  }
}

}  // namespace vibro_impact::detail
