#include "vibro_impact/scene.hpp"

#include <algorithm>
#include <cmath>

#include "list.hpp"
#include "require.hpp"
#include "scene.hpp"
#include "vibro_impact/scene_fields.hpp"

namespace vibro_impact {

using detail::require;

namespace {

void require_one_per_mass(const std::vector<double> &values, const Scene &scene, const char *what) {
  require(values.size() == scene.mass.size(), what, ": ", values.size(),
          " values given, the chain has ", scene.mass.size(), " masses");
  for (double value : values) require(std::isfinite(value), what, " = ", value, ": must be finite");
}

void require_restitution(double restitution) {
  require(restitution >= 0.0 && restitution <= 1.0, "restitution = ", restitution,
          ": must lie in [0, 1]");
}

// Each stop by itself, and the two stops of a mass against each other.
void check_stops(const Scene &scene) {
  struct StopsOfMass {
    const Stop *lower = nullptr, *upper = nullptr;
  };
  detail::List<StopsOfMass> stops_of(scene.mass.size());
  for (const Stop &stop : scene.stops) {
    require(stop.mass >= 1 && stop.mass <= scene.masses(), "stop on mass ", stop.mass,
            ": the chain has masses 1 to ", scene.masses());
    require(stop.side == Side::lower || stop.side == Side::upper, "stop on mass ", stop.mass,
            ", side = ", static_cast<int>(stop.side), ": must be lower (-1) or upper (1)");
    require(std::isfinite(stop.position), "stop on mass ", stop.mass, " at ", stop.position,
            ": must be finite");
    if (stop.restitution) require_restitution(*stop.restitution);
    auto &[lower, upper] = stops_of[static_cast<std::size_t>(stop.mass - 1)];
    const Stop *&same_side = stop.side == Side::upper ? upper : lower;
    require(!same_side, "stop on mass ", stop.mass, ": two stops on the same side");
    same_side = &stop;
    if (lower && upper)
      require(lower->position < upper->position, "stops on mass ", stop.mass, ", lower at ",
              lower->position, ", upper at ", upper->position,
              ": the lower must lie below the upper");
  }
}

}  // namespace

const char *name(Side side) {
  return side == Side::upper ? "upper" : "lower";
}

MotionState start_of(const Scene &scene) {
  check(scene);
  return detail::first_motion(scene);
}

double stiffness_at(const Scene &scene, std::size_t i) {
  const double above = i + 1 < scene.mass.size() ? scene.stiffness[i + 1] : 0.0;
  return scene.stiffness[i] + above + detail::entry_of(scene.ground, i);
}

double spring_force(const Scene &scene, std::size_t i, const std::vector<double> &x) {
  double force = scene.stiffness[i] * ((i > 0 ? x[i - 1] : 0.0) - x[i]);
  if (i + 1 < scene.mass.size()) force += scene.stiffness[i + 1] * (x[i + 1] - x[i]);
  return force - detail::entry_of(scene.ground, i) * x[i];
}

void check(const Scene &scene) {
  const std::size_t n = scene.mass.size();
  require(n > 0, "masses = 0: a chain has at least one mass");
  require_one_per_mass(scene.stiffness, scene, "stiffness");
  for (double m : scene.mass)
    require(std::isfinite(m) && m > 0.0, "mass = ", m, ": must be positive and finite");
  for (std::size_t i = 0; i < n; ++i) {
    const double k = scene.stiffness[i];
    require(i == 0 ? k >= 0.0 : k > 0.0, "stiffness of link ", i + 1, " = ", k, ": must be ",
            i == 0 ? "non-negative" : "positive");
  }
  require(std::isfinite(scene.beta) && scene.beta >= 0.0, "beta = ", scene.beta,
          ": must be non-negative and finite");
  static_cast<void>(Clock(scene.omega));  // refuses an Omega that is negative or not finite
  require_restitution(scene.restitution);
  for (const auto &field : list_fields)
    if (field.optional && !(scene.*field.value).empty())
      require_one_per_mass(scene.*field.value, scene, field.name);
  for (double k : scene.ground) require(k >= 0.0, "ground = ", k, ": must be non-negative");
  const double rate = detail::rate_bound(scene);
  require(std::isfinite(rate * rate), "rate = ", rate,
          ": the largest rate that k, m, beta and omega allow, and its square, must be finite");
  check_stops(scene);
  check(scene, detail::first_motion(scene));
}

void check(const Scene &scene, const MotionState &start) {
  require_one_per_mass(start.displacement, scene, "start: displacement");
  require_one_per_mass(start.velocity, scene, "start: velocity");
  detail::check_place(scene, start.instant, start.held);
  for (const Stop &stop : scene.stops) {
    const auto i = static_cast<std::size_t>(stop.mass - 1);
    const double x = start.displacement[i], v = start.velocity[i];
    require(sign(stop.side) * (stop.position - x) >= 0.0, "start: mass ", stop.mass, " at ", x,
            ", beyond its ", name(stop.side), " stop at ", stop.position,
            "; its displacement (--displacement) must lie within its stops");
    if (start.held[i] == static_cast<signed char>(stop.side))
      require(x == stop.position && v == 0.0, "start: mass ", stop.mass, " is held at its ",
              name(stop.side), " stop at ", stop.position, ", and stands at ", x, " with velocity ",
              v);
  }
}

namespace detail {

void refuse_omega(double omega) {
  throw std::invalid_argument(
      line("omega = ", omega, ": must be non-negative and finite, with a finite period"));
}

void refuse_time(double time) {
  throw std::invalid_argument(
      line("time ", time, ": more forcing periods than double precision can count"));
}

double largest_eigenvalue_bound(const Scene &scene) {
  require_one_per_mass(scene.stiffness, scene, "stiffness");
  double bound = 0.0;
  for (std::size_t i = 0; i < scene.mass.size(); ++i) {
    const double above = i + 1 < scene.mass.size() ? scene.stiffness[i + 1] : 0.0;
    const double row = 2.0 * (scene.stiffness[i] + above) + entry_of(scene.ground, i);
    bound = std::max(bound, row / scene.mass[i]);
  }
  return bound;
}

double root_modulus(double kappa, double lambda) {
  const double alpha = kappa / 2, discriminant = alpha * alpha - lambda;
  return discriminant > 0 ? alpha + std::sqrt(discriminant) : std::sqrt(lambda);
}

double rate_bound(const Scene &scene) {
  const double lambda = largest_eigenvalue_bound(scene);
  const double rate = std::max(root_modulus(scene.beta * lambda, lambda), scene.omega);
  return rate > 0.0 ? rate : 1.0;
}

MotionState first_motion(const Scene &scene) {
  const std::size_t n = scene.mass.size();
  const auto or_zero = [n](const std::vector<double> &values) {
    return values.empty() ? std::vector<double>(n, 0.0) : values;
  };
  return {Instant{}, or_zero(scene.displacement), or_zero(scene.velocity), Held(n, 0)};
}

void check_place(const Scene &scene, const Instant &instant, const Held &held) {
  const Clock clock(scene.omega);
  require(static_cast<double>(instant.cycle) <= most_periods, "start: period ", instant.cycle,
          ": more forcing periods than double precision can count");
  require(instant.cycle >= 0 && instant.phase >= 0.0 && instant.phase < clock.period,
          "start: phase = ", instant.phase, " in period ", instant.cycle, ": must lie in [0, ",
          clock.period, ")");
  require(held.size() == scene.mass.size(), "start: the contact mode of ", held.size(),
          " masses given, the chain has ", scene.mass.size());
  for (std::size_t i = 0; i < held.size(); ++i)
    require(held[i] == 0 || std::any_of(scene.stops.begin(), scene.stops.end(),
                                        [&](const Stop &stop) {
                                          return static_cast<std::size_t>(stop.mass - 1) == i &&
                                                 held[i] == static_cast<signed char>(stop.side);
                                        }),
            "start: mass ", i + 1, " held as ", static_cast<int>(held[i]),
            ": it has no such stop (0 free, 1 upper, -1 lower)");
}

}  // namespace detail

}  // namespace vibro_impact
