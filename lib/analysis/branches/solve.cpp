#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/orbits/newton.hpp"
#include "sequence.hpp"
#include "tolerances.hpp"
#include "vibro_impact/analysis/parameter.hpp"

namespace vibro_impact::branches {

Scene scene_at(const Problem &problem, double q) {
  return with_start_inside(with(problem.scene, problem.parameter, q));
}

Vector units_of(const Problem &problem, const Sequence &s) {
  Vector units(problem.unknowns(s));
  // The angle and the times count so that all flights together weigh as much as the angle alone.
  const double angle =
      2.0 * std::numbers::pi * std::sqrt(1.0 + static_cast<double>(s.items.size()));
  units(0) = problem.width;
  units(1) = angle;
  const double rate = std::min(rate_bound(problem.scene), 10.0 * problem.scene.omega);
  for (size_t i = 0; i < problem.masses(); ++i) {
    units(problem.y_at(i)) = problem.length;
    units(problem.v_at(i)) = problem.length * rate;
  }
  units.tail(index(s.items.size())).setConstant(angle / problem.scene.omega);
  return units;
}

Condition at_parameter(const Problem &problem, const Sequence &s, double q) {
  return {.normal = Vector::Unit(problem.unknowns(s), 0), .offset = q};
}

Condition on_plane(const Problem &problem, const Sequence &s, const Vector &point,
                   const Vector &direction) {
  const Vector units = units_of(problem, s);
  Condition plane{.normal = direction.cwiseQuotient(units.cwiseProduct(units))};
  plane.offset = plane.normal.dot(point);
  return plane;
}

bool solve(const Problem &problem, const Sequence &s, Vector &u, const Condition &condition,
           bool to_rounding, double *error) {
  Vector units = units_of(problem, s);
  units(0) = std::max(units(0), least_width * std::abs(u(0)));
  Vector scale;
  Eigen::PartialPivLU<Dense> lu;
  double before = infinity;
  for (int iteration = 0; iteration < newton_iterations; ++iteration) {
    const bool fresh = !(before < near);
    Equations equations = evaluate(problem, s, u, &condition, fresh);
    if (!equations.values.allFinite()) return false;
    if (fresh) {
      Dense jacobian = equations.jacobian * units.asDiagonal();
      if (!jacobian.allFinite()) return false;
      scale = jacobian.cwiseAbs().rowwise().maxCoeff();
      if (!(scale.minCoeff() > 0.0)) return false;
      scale = scale.cwiseInverse();
      lu.compute(scale.asDiagonal() * jacobian);
    }
    const Vector step = lu.solve(equations.values.cwiseProduct(scale));
    const double length = step.cwiseAbs().maxCoeff();
    if (!(length < longest_correction)) return false;
    u -= step.cwiseProduct(units);
    // The steps that rounding leaves measure the error.
    if (error) *error = 4.0 * (std::abs(step(0)) * units(0) + rounding * std::abs(u(0)));
    if (!to_rounding && length < (fresh ? solved : solved_by_old_jacobian)) return true;
    if (to_rounding && (length < 4.0 * rounding || (length < 0.1 * solved && length >= before / 2)))
      return true;
    if (iteration > 3 && length > before * 2.0) return false;
    before = !fresh && length > before / 10.0 ? 1.0 : length;  // a new Jacobian, if it is slow
  }
  return to_rounding && before < solved;
}

Tangent tangent_of(const Problem &problem, const Sequence &s, const Dense &jacobian,
                   const Vector &along) {
  const Vector units = units_of(problem, s);
  const Eigen::Index size = along.size();
  Dense matrix(size, size);
  matrix.topRows(size - 1) = jacobian * units.asDiagonal();
  for (Eigen::Index k = 0; k + 1 < size; ++k) matrix.row(k) /= matrix.row(k).cwiseAbs().maxCoeff();
  matrix.row(size - 1) = along.cwiseQuotient(units).transpose().normalized();
  const Eigen::PartialPivLU<Dense> lu(matrix);
  const Vector direction = lu.solve(Vector::Unit(size, size - 1)).normalized();
  auto orientation = static_cast<double>(lu.permutationP().determinant());
  for (Eigen::Index k = 0; k < size; ++k)
    if (lu.matrixLU()(k, k) < 0.0) orientation = -orientation;
  return {direction.cwiseProduct(units), orientation};
}

Multipliers multipliers_of(const Problem &problem, const Sequence &s, const Dense &jacobian) {
  const Eigen::Index count = index(s.items.size()), z = index(2 * problem.masses());
  // The equations of the events give the lengths of the flights by the angle and the state. That of
  // event k depends on the flights up to it: the matrix is lower triangular.
  const Dense by_times = jacobian.block(0, 2 + z, count, count),
              times = -by_times.triangularView<Eigen::Lower>().solve(
                  jacobian.block(0, 1, count, 1 + z));
  Dense map(z + 1, z + 1);
  map.bottomRows(z) =
      jacobian.block(count, 1, z, 1 + z) + jacobian.block(count, 2 + z, z, count) * times;
  map.bottomRightCorner(z, z).diagonal().array() += 1.0;
  const double omega = jacobian(count + z, 2 + z);
  map.row(0) = omega * times.colwise().sum();
  map(0, 0) += 1.0;
  if (!map.allFinite()) return {};
  // Angle, displacements and velocities count in their units.
  const Vector units = units_of(problem, s).segment(1, z + 1);
  Multipliers multipliers =
      eigenvalues_of(units.cwiseInverse().asDiagonal() * map * units.asDiagonal());
  multipliers.pop_back();  // the event at the start ties the state to the angle
  return multipliers;
}

}  // namespace vibro_impact::branches
