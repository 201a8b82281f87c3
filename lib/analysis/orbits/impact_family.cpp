#include "vibro_impact/analysis/impact_family.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "fits.hpp"
#include "impact_section.hpp"
#include "motion_state.hpp"
#include "parameter_flow.hpp"
#include "vibro_impact/analysis/locate.hpp"

namespace vibro_impact {

namespace {

using Eigen::Index;

void check_family(const ImpactFamily &family) {
  check(family.scene);
  require(family.stop < family.scene.stops.size(), "stop ", family.stop, ": the scene has ",
          family.scene.stops.size(), " stops");
  require(family.periods >= 1, "periods = ", family.periods, ": must be at least 1");
  require(family.scene.omega > 0.0, "omega = ", family.scene.omega,
          ": a periodic orbit needs a forcing period");
  require_differentiable(family.scene, {family.parameter});
}

// What the orbit found tells of itself.
ImpactOrbit describe(const ImpactSection &section, const ImpactUnknowns &at,
                     const ImpactEquations &eq, double from, double to) {
  ImpactOrbit orbit;
  orbit.speed = section.speed;
  orbit.parameter = at.values(at.values.size() - 1);
  orbit.state = section.state;
  const Eigen::VectorXd by_speed = -eq.by_unknowns.partialPivLu().solve(eq.by_speed);
  orbit.by_speed.assign(by_speed.begin(), by_speed.end());
  orbit.parameter_by_speed = orbit.by_speed.back();
  orbit.first_other = eq.back.others.first;
  orbit.last_other = eq.back.others.last;
  orbit.real = is_real(section, from, to);
  // `singular` has rank one: the determinant is linear in it.
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(eq.regular.rows(), eq.regular.cols());
  const double regular = (one + eq.regular).determinant();
  orbit.doubling =
      section.speed * regular + (one + eq.regular + eq.singular).determinant() - regular;
  if (section.speed == 0.0) return orbit;
  const Eigen::MatrixXd monodromy = eq.regular + eq.singular / section.speed;
  Matrix derivative(2 * at.held.size(), 2 * at.held.size());
  const std::vector<std::size_t> free = free_coordinates(at.held);
  for (std::size_t i = 0; i < free.size(); ++i)
    for (std::size_t j = 0; j < free.size(); ++j)
      derivative(free[i], free[j]) = monodromy(static_cast<Index>(i), static_cast<Index>(j));
  orbit.multipliers = floquet_multipliers(derivative, at.held);
  return orbit;
}

std::optional<ImpactOrbit> solve(const ImpactFamily &family, ImpactUnknowns at, double speed,
                                 double first_other, double last_other,
                                 const NewtonOptions &options) {
  // Halfway to the events at the stop in between; none: nowhere.
  const bool any = first_other <= last_other;
  const double from = any ? 0.5 * first_other : 1.0, to = any ? 0.5 * (1.0 + last_other) : 0.0;
  std::vector<double> residuals;
  for (int iteration = 0; iteration <= options.max_iterations; ++iteration) {
    const ImpactSection section(family, at, speed);
    const auto eq = equations(section, at, from, to);
    if (!eq || !eq->residual.allFinite() || !eq->by_unknowns.allFinite()) return std::nullopt;
    residuals.push_back(eq->residual.cwiseAbs().maxCoeff());
    const double scale = std::max(1.0, view(coordinates(section.state)).cwiseAbs().maxCoeff());
    if (residuals.back() <= options.tolerance * scale) {
      ImpactOrbit orbit = describe(section, at, *eq, from, to);
      orbit.residuals = residuals;
      return orbit;
    }
    const Eigen::VectorXd step = eq->by_unknowns.partialPivLu().solve(eq->residual);
    if (!step.allFinite()) return std::nullopt;
    at.values -= step;
  }
  return std::nullopt;
}

ImpactUnknowns unknowns_of(const ImpactFamily &family, const ImpactOrbit &orbit) {
  const auto mass = static_cast<std::size_t>(family.scene.stops[family.stop].mass - 1);
  ImpactUnknowns at{{}, orbit.state.held};
  const Scene scene = with(family.scene, family.parameter, orbit.parameter);
  const std::vector<double> z = coordinates(orbit.state);
  std::vector<double> values{scene.omega * orbit.state.instant.phase};
  for (const std::size_t row : at.others(mass)) values.push_back(z[row]);
  values.push_back(orbit.parameter);
  at.values = view(values);
  return at;
}

// The state right after one event of a run.
struct StateAfter {
  std::size_t stop, wanted;
  std::size_t seen = 0;
  std::optional<Event> at = {};
  MotionState state = {};
  int simultaneous = 0;

  void event(const Event &event, const Moment &moment) {
    if (at && event.time == at->time) ++simultaneous;
    if (event.kind != EventKind::impact || event.stop != stop || seen++ != wanted) return;
    at = event;
    state = state_at(moment, event.held);
  }
};

std::optional<ImpactOrbit> zero_between(const ImpactFamily &family, const ImpactOrbit &a,
                                        const ImpactOrbit &b, double ImpactOrbit::*function) {
  check_family(family);
  if ((a.*function > 0.0) == (b.*function > 0.0) || a.speed == b.speed) return std::nullopt;
  ImpactOrbit last = a;
  const auto at = [&](double speed) {
    // From the nearer of the orbits known.
    const bool near_b = std::abs(speed - b.speed) < std::abs(speed - last.speed);
    auto found = impact_orbit(family, near_b ? b : last, speed);
    if (!found) throw std::runtime_error(line("speed = ", speed, ": no orbit of the family found"));
    last = std::move(*found);
    return last.*function;
  };
  const double root = zero(at, std::min(a.speed, b.speed), std::max(a.speed, b.speed)).value;
  at(root);
  return last;
}

}  // namespace

std::optional<ImpactOrbit> impact_orbit(const ImpactFamily &family, const ImpactOrbit &neighbour,
                                        double speed, const NewtonOptions &options) {
  check_family(family);
  require(std::isfinite(speed), "speed = ", speed, ": must be finite");
  require_fits(family.scene, neighbour.state);
  ImpactUnknowns at = unknowns_of(family, neighbour);
  if (neighbour.by_speed.size() == static_cast<std::size_t>(at.values.size()))
    at.values += (speed - neighbour.speed) * view(neighbour.by_speed);
  try {
    return solve(family, at, speed, neighbour.first_other, neighbour.last_other, options);
  } catch (const std::exception &) {  // an iterate outside the scene's limits, a run given up
    return std::nullopt;
  }
}

ImpactOrbit impact_orbit_of(const ImpactFamily &family, const PeriodicOrbit &orbit,
                            std::size_t impact) {
  check_family(family);
  require(orbit.converged && orbit.periods == family.periods,
          "orbit: must have converged and have ", family.periods, " periods");
  StateAfter found{family.stop, impact};
  stroboscopic_map(family.scene, orbit.state, orbit.periods, {}, found);
  require(found.at.has_value(), "impact ", impact, ": the orbit has ", found.seen, " at this stop");
  require(found.simultaneous == 0, "impact ", impact, ": another event at the same instant");
  found.state.displacement[static_cast<std::size_t>(found.at->mass - 1)] =
      family.scene.stops[family.stop].position;  // told to within rounding
  ImpactOrbit guess;
  guess.speed = std::abs(found.at->velocity_before);
  guess.parameter = get(family.scene, family.parameter);
  guess.state = found.state;
  // Events at the stop in the orbit that begins at this impact.
  const double begin = found.at->time,
               period = time_after(family.scene, found.state, orbit.periods) - begin;
  OtherEvents others{family.stop, begin, period};
  simulate_from(family.scene, found.state, begin + period * (1.0 - 1e-6), {}, others);
  guess.first_other = others.first;
  guess.last_other = others.last;
  auto solved = impact_orbit(family, guess, guess.speed);
  if (!solved)
    throw std::runtime_error(line("speed = ", guess.speed, ": no orbit of the family found"));
  return *solved;
}

std::vector<ImpactOrbit> follow(const ImpactFamily &family, const ImpactOrbit &start, double speed,
                                double step) {
  require(std::isfinite(step) && step > 0.0, "step = ", step, ": must be positive and finite");
  require(std::isfinite(speed), "speed = ", speed, ": must be finite");
  std::vector<ImpactOrbit> orbits{start};
  double now = step;
  while (orbits.back().speed != speed && now > step / 1024.0) {
    const double left = speed - orbits.back().speed;
    const double next =
        std::abs(left) <= now ? speed : orbits.back().speed + std::copysign(now, left);
    auto found = impact_orbit(family, orbits.back(), next);
    if (found) orbits.push_back(std::move(*found));
    now = found ? std::min(step, 2.0 * now) : 0.5 * now;
  }
  return orbits;
}

std::optional<ImpactOrbit> fold_between(const ImpactFamily &family, const ImpactOrbit &a,
                                        const ImpactOrbit &b) {
  return zero_between(family, a, b, &ImpactOrbit::parameter_by_speed);
}

std::optional<ImpactOrbit> doubling_between(const ImpactFamily &family, const ImpactOrbit &a,
                                            const ImpactOrbit &b) {
  return zero_between(family, a, b, &ImpactOrbit::doubling);
}

}  // namespace vibro_impact
