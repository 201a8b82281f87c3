#include "rest.hpp"

#include <array>
#include <cmath>

#include "simulation/chain/forces.hpp"

namespace vibro_impact {

namespace {

using Kind = Question::Kind;

// Decides those still undecided, order by order; a force within its error bound counts as zero.
// Returns how many are left.
std::size_t decide_by_order(const Scene &scene, double phase, double rate, Question &question) {
  const std::size_t n = scene.mass.size();
  std::vector<Kind> &kind = question.kind;
  Derivatives &at = question.looked_at;
  const double angle = scene.omega * phase, c = std::cos(angle), s = std::sin(angle);
  const std::array<double, 4> cosine{c, -s, -c, s};  // and its derivatives
  double power = 1.0;                                // (Omega / rate)^order
  std::size_t left = 0;
  for (const Resting &mass : question.resting) left += kind[mass.mass] == Kind::undecided;
  for (int order = 0; left > 0 && order < 2 * static_cast<int>(n) + 4; ++order) {
    const double forcing = power * cosine[static_cast<std::size_t>(order % 4)];
    const auto force_of = [&](std::size_t i) {
      return force_on(
          scene, i, [&](std::size_t j) { return at.x[j]; },
          [&](std::size_t j) { return rate * at.v[j]; }, forcing);
    };
    // The same of error bounds: -E_i in place of x_i adds up what the difference takes off.
    const auto error_of = [&](std::size_t i) {
      const auto bound = [i](const std::vector<double> &errors, double unit) {
        return
            [&errors, i, unit](std::size_t j) { return unit * (j == i ? -errors[j] : errors[j]); };
      };
      return force_on(scene, i, bound(at.x_error, 1.0), bound(at.v_error, rate), 0.0);
    };
    const auto set_acceleration = [&](std::size_t i, double force, double error) {
      at.a[i] = force / (scene.mass[i] * rate * rate);
      at.a_error[i] = error / (scene.mass[i] * rate * rate);
    };
    for (std::size_t i = 0; i < n; ++i) {
      const bool moves = kind[i] == Kind::moving;
      set_acceleration(i, moves ? force_of(i) : 0.0, moves ? error_of(i) : 0.0);
    }
    for (Resting &mass : question.resting) {
      if (kind[mass.mass] != Kind::undecided) continue;
      const double force = force_of(mass.mass), error = error_of(mass.mass);
      if ((order == 0 && mass.force_is_zero) || std::abs(force) <= error) continue;
      mass.held = mass.sigma * force > 0.0;
      kind[mass.mass] = mass.held ? Kind::held : Kind::moving;
      if (!mass.held) set_acceleration(mass.mass, force, error);
      mass.zeros = order;
      mass.leading = mass.held ? mass.sigma * force : -mass.sigma * at.a[mass.mass];
      --left;
    }
    at.x.swap(at.v);  // x, x', x'' become x', x'', and the oldest to be written over
    at.v.swap(at.a);
    at.x_error.swap(at.v_error);
    at.v_error.swap(at.a_error);
    power *= scene.omega / rate;
  }
  return left;
}

}  // namespace

void decide(const Scene &scene, const MotionState &motion, double rate, Question &question) {
  const std::size_t n = scene.mass.size();
  Derivatives &at = question.at;
  std::vector<Kind> &kind = question.kind;
  kind.resize(n);
  at.x = motion.displacement;
  at.v = motion.velocity;
  at.x_error = question.error;
  for (std::size_t i = 0; i < n; ++i) {
    at.v[i] /= rate;
    kind[i] = motion.held[i] != 0 ? Kind::held : Kind::moving;
  }
  for (Resting &mass : question.resting) {
    kind[mass.mass] = Kind::undecided;
    at.x[mass.mass] = scene.stops[mass.stop].position;
  }
  for (std::size_t i = 0; i < n; ++i)  // at rest means exactly where its stop is
    if (kind[i] != Kind::moving) at.v[i] = at.x_error[i] = 0.0;
  at.a.assign(n, 0.0);
  at.a_error.assign(n, 0.0);
  at.v_error = at.x_error;
  question.looked_at = at;
  if (decide_by_order(scene, motion.instant.phase, rate, question) == 0) return;
  // Where nothing but the rounding of the others tells: by that.
  at.x_error.assign(n, 0.0);
  at.v_error.assign(n, 0.0);
  question.looked_at = at;
  decide_by_order(scene, motion.instant.phase, rate, question);
}

}  // namespace vibro_impact
