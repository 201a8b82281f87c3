#include "rest.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "simulation/chain/forces.hpp"

namespace vibro_impact {

namespace {

enum class Kind : char { moving, at_rest, undecided };

// x, x', x'' of the order looked at, in units of rate^order, with bounds of their errors.
struct Derivatives {
  std::vector<double> x, v, a, x_error, v_error, a_error;

  // x, x', x'' -> x', x'', and the oldest to be written over.
  void next_order() {
    x.swap(v);
    v.swap(a);
    x_error.swap(v_error);
    v_error.swap(a_error);
  }
};

// Decides those still undecided, order by order; a force within its error bound counts as zero.
// Returns how many are left.
std::size_t decide_by_order(const Scene &scene, double phase, double rate, Derivatives at,
                            std::vector<Kind> &kind, std::vector<Resting> &resting) {
  const std::size_t n = scene.mass.size();
  const double angle = scene.omega * phase, c = std::cos(angle), s = std::sin(angle);
  const std::array<double, 4> cosine{c, -s, -c, s};  // and its derivatives
  double power = 1.0;                                // (Omega / rate)^order
  std::size_t left = 0;
  for (const Resting &mass : resting) left += kind[mass.mass] == Kind::undecided;
  for (int order = 0; left > 0 && order < 2 * static_cast<int>(n) + 4; ++order) {
    const auto links = [&](std::size_t i, const std::vector<double> &values) {
      return link_force(scene, i, values[i], [&](std::size_t j) { return values[j]; });
    };
    // The same of error bounds: -E_i in place of x_i adds up what the difference takes off.
    const auto bound = [&](std::size_t i, const std::vector<double> &errors) {
      return link_force(scene, i, -errors[i], [&](std::size_t j) { return errors[j]; });
    };
    const double damping = scene.beta * rate,
                 forcing = power * cosine[static_cast<std::size_t>(order % 4)];
    const auto force_on = [&](std::size_t i) {
      return links(i, at.x) + damping * links(i, at.v) + amplitude_on(scene, i) * forcing;
    };
    const auto error_of = [&](std::size_t i) {
      return bound(i, at.x_error) + damping * bound(i, at.v_error);
    };
    const auto set_acceleration = [&](std::size_t i, double force, double error) {
      at.a[i] = force / (scene.mass[i] * rate * rate);
      at.a_error[i] = error / (scene.mass[i] * rate * rate);
    };
    for (std::size_t i = 0; i < n; ++i) {
      const bool moves = kind[i] == Kind::moving;
      set_acceleration(i, moves ? force_on(i) : 0.0, moves ? error_of(i) : 0.0);
    }
    for (Resting &mass : resting) {
      if (kind[mass.mass] != Kind::undecided) continue;
      const double force = force_on(mass.mass), error = error_of(mass.mass);
      if ((order == 0 && mass.force_is_zero) || std::abs(force) <= error) continue;
      mass.held = mass.sigma * force > 0.0;
      kind[mass.mass] = mass.held ? Kind::at_rest : Kind::moving;
      if (!mass.held) set_acceleration(mass.mass, force, error);
      mass.zeros = mass.held ? order : order + 2;
      mass.leading = mass.held ? mass.sigma * force : -mass.sigma * at.a[mass.mass];
      --left;
    }
    at.next_order();
    power *= scene.omega / rate;
  }
  return left;
}

}  // namespace

double rate_of(const Scene &scene) {
  const double lambda = largest_eigenvalue_bound(scene);
  const double rate = std::max(root_modulus(scene.beta * lambda, lambda), scene.omega);
  return rate > 0.0 ? rate : 1.0;
}

void decide(const Scene &scene, double phase, double rate, std::vector<double> x,
            std::vector<double> v, std::vector<double> error, const Held &held,
            std::vector<Resting> &resting) {
  const std::size_t n = scene.mass.size();
  for (double &value : v) value /= rate;
  std::vector<Kind> kind(n);
  for (std::size_t i = 0; i < n; ++i) kind[i] = held[i] != 0 ? Kind::at_rest : Kind::moving;
  for (Resting &mass : resting) {
    kind[mass.mass] = Kind::undecided;
    x[mass.mass] = scene.stops[mass.stop].position;
    mass.zeros = all_zeros;
    mass.leading = 0.0;
  }
  for (std::size_t i = 0; i < n; ++i)  // at rest means exactly where its stop is
    if (kind[i] != Kind::moving) v[i] = error[i] = 0.0;
  const std::vector<double> none(n, 0.0);
  // Where nothing but the rounding of the others tells: by that.
  if (decide_by_order(scene, phase, rate, {x, v, none, error, error, none}, kind, resting) > 0)
    decide_by_order(scene, phase, rate, {x, v, none, none, none, none}, kind, resting);
}

}  // namespace vibro_impact
