// A program written by hand for two masses with one stop each and nothing else. It shows how fast
// the algorithm of the library can be: Taylor series from event to event, and the limit of a
// chatter by extrapolation. It has neither a bound that proves a root to be the first one, nor
// twice the precision at a stop, nor rules for simultaneous events.
#include "by_hand.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "two_masses.hpp"

namespace vibro_impact::comparison {

namespace {

using namespace hand;

// A state at the time `time` + `time_rest`, and the forcing there.
struct ForcedState : GapState {
  double time_rest = 0.0, cosine = 0.0, sine = 0.0;

  void set_forcing(double omega) {
    const double phase = omega * time + omega * time_rest;
    cosine = std::cos(phase);
    sine = std::sin(phase);
  }
  double pressing(const TwoMasses &chain, std::size_t i) const {
    return -chain.acceleration(i, y, cosine);
  }
};

struct Program {
  const TwoMasses &chain;
  double beta, tolerance, until;
  ForcedState now;
  Result result = {};
  double fastest = 0.0;  // a bound of the frequencies
  Weights weights = Weights(chain.restitution);
  std::array<Chatter, 2> chatters = {};
  // The coefficients of the equation of motion, u' = diagonal w + off w of the other mass +
  // constant + drive cos, w = g + beta u.
  Pair diagonal = {}, off = {}, constant = {}, drive = {};
  std::size_t order = 0;
  std::array<Pair, highest_order> gap = {}, guards = {};  // Taylor coefficients

  Program(const TwoMasses &of, const Problem &problem, double its_tolerance)
      : chain(of),
        beta(problem.scene.beta),
        tolerance(its_tolerance),
        until(problem.until),
        now{gap_state(of, problem.from, problem.start)} {
    double largest = chain.omega * chain.omega;
    for (std::size_t i = 0; i < 2; ++i) {
      const GapEquation &e = chain.equation[i];
      diagonal[i] = e.gap[i];
      off[i] = e.gap[1 - i];
      constant[i] = e.constant;
      drive[i] = e.drive;
      largest = std::max(largest, std::abs(e.gap[0]) + std::abs(e.gap[1]));
    }
    fastest = std::sqrt(largest);
    now.set_forcing(chain.omega);
  }

  // The Taylor series of the gaps, and of the guards: the gap of a free mass, and the force on a
  // held one.
  void expand(double h) {
    for (order = 4; order + 3 < highest_order && orders.reach[order] < h * fastest;) ++order;
    const Pair free{now.held[0] ? 0.0 : 1.0, now.held[1] ? 0.0 : 1.0}, held = 1.0 - free;
    gap[0] = Pair{now.y[0], now.y[2]};
    gap[1] = Pair{now.y[1], now.y[3]};
    Pair outside = constant;
    double force = now.cosine, next_force = -chain.omega * now.sine;
    for (std::size_t n = 0; n <= order; ++n) {
      const double inverse = orders.inverse[n];
      const double damping = beta * inverse * static_cast<double>(n + 1);
      const Pair known =
          inverse * (diagonal * gap[n] + off * swapped(gap[n]) + outside + drive * force);
      const Pair next =
          known + ((damping * diagonal) * gap[n + 1] + (damping * off) * swapped(gap[n + 1]));
      gap[n + 2] = free * next;
      guards[n] = gap[n] - held * next / inverse;
      outside = Pair{};
      force = std::exchange(next_force, -chain.omega * chain.omega * inverse * force);
    }
  }

  ValueAndSlope<Pair> guards_at(double tau) const {
    return polynomial<Pair>([this](std::size_t n) { return guards[n]; }, order, tau);
  }

  // The zero of guard i in (a, b], where the guard is positive at or just after a and not at b.
  // Newton's method, kept within the bracket.
  double zero(std::size_t i, double a, double b, double guess) const {
    double tau = guess;
    for (int iteration = 0; iteration < 60; ++iteration) {
      if (!(tau > a && tau < b)) tau = 0.5 * (a + b);
      const auto [value, slope] =
          polynomial<double>([&](std::size_t n) { return guards[n][i]; }, order, tau);
      (value > 0.0 ? a : b) = tau;
      const double change = value / slope;
      tau -= change;
      if (std::abs(change) <= 2e-8 * tau || b - a <= 1e-16 * b) break;
    }
    return tau;
  }

  // The duration of the flight that begins with guard i at zero, by its first four derivatives.
  double flight_of(std::size_t i) const {
    const double u = guards[1][i], c2 = guards[2][i], c3 = guards[3][i], c4 = guards[4][i];
    double tau = -u / c2;
    for (int iteration = 0; iteration < 2; ++iteration)
      tau -= (u + tau * (c2 + tau * (c3 + tau * c4))) / (c2 + tau * (2.0 * c3 + tau * 3.0 * c4));
    return tau;
  }

  // Moves to the time tau of the series.
  void move(double tau) {
    const auto [value, slope] =
        polynomial<Pair>([this](std::size_t n) { return gap[n]; }, order + 2, tau);
    now.y = {value[0], slope[0], value[1], slope[1]};
    const double sum = now.time + tau, moved = sum - now.time;
    now.time_rest += (now.time - (sum - moved)) + (tau - moved);
    now.time = sum;
    now.set_forcing(chain.omega);
  }

  void forget() {
    for (Chatter &chatter : chatters) chatter.nodes.clear();
  }
  void record(std::size_t i, EventKind kind, double velocity = 0.0) {
    result.record(now.time + now.time_rest, i, kind, velocity);
  }
  void release(std::size_t i) {
    now.held[i] = false;
    now.y[2 * i] = now.y[2 * i + 1] = 0.0;
    record(i, EventKind::release);
    forget();
  }

  // Ends the chatter of mass i + 1 where the limits of two orders agree and the masses stay where
  // they are there.
  void end_chatter(std::size_t i) {
    const Chatter &chatter = chatters[i];
    const std::size_t m = std::min(chatter.nodes.size() - 1, highest_power), j = 1 - i;
    if (m < 2) return;
    Chatter::Node limit;
    for (std::size_t c = 0; c < 3; ++c) {
      limit[c] = chatter.limit(weights, m, c);
      if (!(std::abs(limit[c] - chatter.limit(weights, m - 1, c)) <= tolerance)) return;
    }
    ForcedState end = now;
    end.time = chatter.begin + limit[0];
    end.time_rest = chatter.begin - end.time + limit[0];
    end.set_forcing(chain.omega);
    end.held[i] = true;
    end.y[2 * i] = end.y[2 * i + 1] = 0.0;
    end.y[2 * j] = limit[1];
    end.y[2 * j + 1] = limit[2];
    if (end.time > until || !(end.pressing(chain, i) > 0.0)) return;
    if (!((now.held[j] ? end.pressing(chain, j) : limit[1]) > 0.0)) return;
    now = end;
    record(i, EventKind::stick);
    forget();
  }

  void impact(std::size_t i) {
    const std::size_t j = 1 - i;
    now.y[2 * i] = 0.0;
    double &speed = now.y[2 * i + 1];
    result.count_impact(now.time, i, speed);
    record(i, EventKind::impact, -chain.side[i] * speed);
    speed = std::abs(chain.restitution * speed);
    chatters[j].nodes.clear();
    Chatter &chatter = chatters[i];
    if (chatter.nodes.empty()) chatter.begin = now.time + now.time_rest;
    chatter.nodes.push_back(
        {now.time - chatter.begin + now.time_rest, now.y[2 * j], now.y[2 * j + 1]});
    if (now.held[j] && !(now.pressing(chain, j) > 0.0)) release(j);
    if (!chatter.nodes.empty()) end_chatter(i);
  }

  // The end of the part of [a, b] in which guard i falls: b, or its lowest place if it may be zero
  // there. The lines through its values at a and b with its slopes meet below a convex curve.
  double end_of_fall(std::size_t i, double a, double b, const ValueAndSlope<Pair> &at_a,
                     const ValueAndSlope<Pair> &at_b) const {
    const double from = at_a.slope[i], to = at_b.slope[i];
    if (at_b.value[i] <= 0.0 || !(from < 0.0 && to > 0.0)) return b;
    const double meet = (at_a.value[i] - at_b.value[i] + to * (b - a)) / (to - from);
    if (at_a.value[i] + from * meet > 0.0) return b;
    for (int bisection = 0; bisection < 50; ++bisection) {
      const double middle = 0.5 * (a + b);
      (guards_at(middle).slope[i] < 0.0 ? a : b) = middle;
    }
    return b;
  }

  void step() {
    const double h = std::min({until - now.time, longest_step, 1.1 * flight_ahead(chain, now)});
    expand(h);
    const int parts = std::max(1, static_cast<int>(std::ceil(h / longest_part)));
    double a = 0.0;
    ValueAndSlope<Pair> at_a{guards[0], guards[1]};
    for (int part = 1; part <= parts; ++part) {
      const double b = part == parts ? h : h * part / parts;
      const auto at_b = guards_at(b);
      double first = b;
      std::size_t mass = 2;
      for (std::size_t i = 0; i < 2; ++i) {
        const double end = end_of_fall(i, a, b, at_a, at_b);
        const double lowest = end < b ? guards_at(end).value[i] : at_b.value[i];
        if (lowest > 0.0) continue;
        const double highest = at_a.value[i];
        const double tau = zero(
            i, a, end, highest > 0.0 ? a + (end - a) * highest / (highest - lowest) : flight_of(i));
        if (mass == 2 || tau < first) {
          first = tau;
          mass = i;
        }
      }
      if (mass < 2) {
        move(first);
        return now.held[mass] ? release(mass) : impact(mass);
      }
      a = b;
      at_a = at_b;
    }
    move(h);
  }
};

Result run_by_hand(const Problem &problem, double tolerance) {
  const TwoMasses chain = two_masses(problem.scene);
  Program program(chain, problem, tolerance);
  while (program.now.time < problem.until && program.result.failure.empty()) program.step();
  return program.result;
}

}  // namespace

std::vector<Method> by_hand() {
  return {{"by hand", {1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13}, run_by_hand}};
}

}  // namespace vibro_impact::comparison
