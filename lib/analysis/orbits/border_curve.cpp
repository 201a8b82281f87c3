#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "held_chatter.hpp"
#include "motion_state.hpp"
#include "vibro_impact/analysis/periodic_orbit.hpp"

namespace vibro_impact {

namespace {

using Eigen::Index;

// Where Newton's method is: the section, in the scene of a point of the plane.
struct BorderIterate {
  PlanePoint at;
  MotionState section;
  double time;
  std::size_t least = 0;  // impact of the chatter to compare speeds at
};

std::optional<BorderEquations> equations(const BifurcationCurve &curve, const BorderIterate &at) {
  try {
    return border_equations(curve, at.at, at.section, at.time, at.least);
  } catch (const std::exception &) {  // outside the scene's limits, a run given up
    return std::nullopt;
  }
}

// A step of Newton's method.
struct BorderStep {
  Eigen::VectorXd section;
  PlanePoint place;
};

// The iterate a part of a step away, at the same angle of the forcing.
BorderIterate moved(const BifurcationCurve &curve, const BorderIterate &from,
                    const BorderStep &step, double part) {
  BorderIterate to = from;
  to.at = moved(from.at, step.place, part);
  const Scene before = curve.at(from.at), after = curve.at(to.at);
  to.section.instant.phase = same_angle(from.section.instant.phase, before, after);
  to.time = same_angle(from.time, before, after);
  Index k = 0;
  for (const std::size_t row : free_coordinates(from.section.held))
    coordinate(to.section, row) += part * step.section(k++);
  hold_at_stops(after, to.section);
  return to;
}

// The step of Newton's method for the section and the place together, to where the excess is `aim`
// on the line through `guess`. Nothing where there is none, or it leads far away.
std::optional<BorderStep> newton_step(const BorderEquations &eq, const PlanePoint &from,
                                      const PlanePoint &guess, const PlanePoint &across,
                                      double aim) {
  constexpr double farthest = 0.1;
  const Index n = eq.residual.size();
  const Eigen::Vector2d to_guess{guess.x - from.x, guess.y - from.y}, line{across.x, across.y};
  Eigen::MatrixXd matrix(n + 1, n + 1);
  matrix << eq.residual_by.leftCols(n), eq.residual_by.rightCols(2) * line, eq.excess_by.head(n),
      eq.excess_by.tail(2) * line;
  Eigen::VectorXd residual(n + 1);
  residual << eq.residual + eq.residual_by.rightCols(2) * to_guess,
      eq.excess - aim + eq.excess_by.tail(2) * to_guess;
  const Eigen::VectorXd step = -matrix.partialPivLu().solve(residual);
  const Eigen::Vector2d place = to_guess + step(n) * line;
  if (!step.allFinite() || place.norm() > farthest) return std::nullopt;
  return BorderStep{step.head(n), {place(0), place(1)}};
}

// How the excess changes with the place, the orbit moving along.
PlanePoint gradient_of(const BorderEquations &eq) {
  const Index n = eq.residual.size();
  const Eigen::MatrixXd section =
      -eq.residual_by.leftCols(n).partialPivLu().solve(eq.residual_by.rightCols(2));
  const Eigen::RowVectorXd gradient = eq.excess_by.tail(2) + eq.excess_by.head(n) * section;
  return {gradient(0), gradient(1)};
}

}  // namespace

std::optional<CurvePoint> by_held_chatter(const BifurcationCurve &curve, const PlanePoint &guess,
                                          const PlanePoint &across, const CurvePoint &from) {
  BorderIterate at{from.at, from.state, from.time};
  auto eq = equations(curve, at);
  double last = std::numeric_limits<double>::infinity(), aim = 0.0;
  for (int iteration = 0; eq && iteration < 20; ++iteration) {
    const bool deeper = iteration > 0 && eq->compared.impact >= at.least;
    // A chatter that does not complete may end before it can be told from one that does: back then
    // to where one has.
    aim = deeper || iteration == 0 ? 0.0 : std::max(2.0 * aim, eq->compared.next);
    const auto step = newton_step(*eq, at.at, guess, across, aim);
    if (!step) return std::nullopt;
    const double size = std::hypot(step->place.x, step->place.y);
    if (deeper && eq->compared.similar && (size < 3e-15 || (size < 1e-11 && size > 0.5 * last))) {
      const Condition reading{eq->excess, gradient_of(*eq), at.section, eq->end, eq->events};
      return point_from(curve, at.at, at.at, reading, std::max(size, 1e-16));
    }
    last = size;
    const std::size_t least = eq->compared.impact + 1;
    BorderIterate next = at;
    eq.reset();
    for (double part = 1.0; !eq && part > 0.05; part /= 2.0) {
      next = moved(curve, at, *step, part);
      eq = equations(curve, next);
    }
    at = next;
    at.least = least;
    if (eq) at.time = eq->end;
  }
  return std::nullopt;
}

}  // namespace vibro_impact
