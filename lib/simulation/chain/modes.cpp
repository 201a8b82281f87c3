#include "modes.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Jacobi>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "forces.hpp"
#include "tolerances.hpp"

namespace vibro_impact::detail {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// The orthonormal eigenvectors u = M^1/2 x of M^-1/2 K M^-1/2 on the rows of the free masses. The
// matrix is tridiagonal. A held mass parts it into blocks, and its links stay on the diagonal.
MatrixXd eigenvectors_of(const Scene &scene, const std::vector<std::size_t> &free) {
  const auto modes = static_cast<Index>(free.size());
  VectorXd diagonal(modes), off(modes - 1);
  for (Index a = 0; a < modes; ++a) {
    const std::size_t i = free[static_cast<std::size_t>(a)];
    const double k_right = i + 1 < scene.mass.size() ? scene.stiffness[i + 1] : 0.0;
    diagonal(a) = (scene.stiffness[i] + k_right + entry_of(scene.ground, i)) / scene.mass[i];
    if (a + 1 < modes)
      off(a) = free[static_cast<std::size_t>(a) + 1] == i + 1
                   ? -k_right / std::sqrt(scene.mass[i]) / std::sqrt(scene.mass[i + 1])
                   : 0.0;
  }
  // The solver drops entries by a rule that is not homogeneous, so the matrix is brought to order
  // one. A power of two leaves the digits.
  const double largest = diagonal.maxCoeff();
  const double unit = largest > 0.0 ? std::exp2(-std::ilogb(largest)) : 1.0;
  diagonal *= unit;
  off *= unit;
  Eigen::SelfAdjointEigenSolver<MatrixXd> solver;
  solver.computeFromTridiagonal(diagonal, off);
  return solver.eigenvectors();
}

// Rotates orthonormal vectors among themselves until `first` is the first of them. Each rotation
// makes one of the other vectors orthogonal to `first`.
void rotate_to_front(const VectorXd &first, MatrixXd &vectors) {
  Eigen::RowVectorXd share = first.transpose() * vectors;
  for (Index j = 1; j < vectors.cols(); ++j) {
    Eigen::JacobiRotation<double> rotation;
    rotation.makeGivens(share(0), share(j));
    share.applyOnTheRight(0, j, rotation);
    vectors.applyOnTheRight(0, j, rotation);
  }
  vectors.col(0) = first;
}

// The tensions sqrt(k_i) (x_i - x_(i-1)) of the links (rows) in the modes (columns). The scalar
// product of the columns p and q is u_p^T M^-1/2 K M^-1/2 u_q.
MatrixXd tensions_of(const Scene &scene, const std::vector<std::size_t> &free,
                     const MatrixXd &vectors) {
  const auto n = static_cast<Index>(scene.mass.size());
  MatrixXd tension = MatrixXd::Zero(springs(scene), vectors.cols());
  for (Index j = 0; j < vectors.cols(); ++j)
    for (Index a = 0; a < vectors.rows(); ++a) {
      const std::size_t i = free[static_cast<std::size_t>(a)];
      const auto row = static_cast<Index>(i);
      const double x = vectors(a, j) / std::sqrt(scene.mass[i]);
      tension(row, j) += x;
      if (row + 1 < n) tension(row + 1, j) -= x;
      if (!scene.ground.empty()) tension(n + row, j) = std::sqrt(scene.ground[i]) * x;
    }
  for (Index i = 0; i < n; ++i)
    tension.row(i) *= std::sqrt(scene.stiffness[static_cast<std::size_t>(i)]);
  return tension;
}

// One-sided Jacobi rotations (Demmel and Veselic, SIAM J. Matrix Anal. Appl. 13 (1992) 1204): pairs
// of columns of the tensions, and the vectors with them, are rotated until all columns are
// orthogonal to rounding of their own lengths. The eigenvalues are then lambda_j = |tension_j|^2,
// and each mode is accurate relative to its own tensions.
//
// The eigenvalue solver leaves products u_p^T A u_q of epsilon lambda_max. These are large relative
// to |tension_p| |tension_q| when both modes are soft. Only pairs with |tension_p| |tension_q| <=
// soft lambda_max are rotated.
void make_orthogonal(MatrixXd &tension, MatrixXd &vectors, Index first) {
  VectorXd length = tension.colwise().norm().transpose();
  const double largest = length.maxCoeff(),
               tolerance = std::sqrt(static_cast<double>(tension.rows())) *
                           std::numeric_limits<double>::epsilon();
  bool rotated = true;
  for (int sweep = 0; rotated && sweep < most_jacobi_sweeps; ++sweep) {
    rotated = false;
    for (Index p = first; p < tension.cols(); ++p)
      for (Index q = p + 1; q < tension.cols(); ++q) {
        if (length(p) / largest * (length(q) / largest) > soft_pair) continue;
        const double product = tension.col(p).dot(tension.col(q));
        if (std::abs(product) <= tolerance * length(p) * length(q)) continue;
        Eigen::JacobiRotation<double> rotation;
        rotation.makeJacobi(length(p) * length(p), product, length(q) * length(q));
        tension.applyOnTheRight(p, q, rotation);
        vectors.applyOnTheRight(p, q, rotation);
        length(p) = tension.col(p).norm();
        length(q) = tension.col(q).norm();
        rotated = true;
      }
  }
}

// Sets the tensions of stiff links in softer modes. Their rounding is epsilon sqrt(lambda), so that
// the force k_i (x_i - x_(i-1)) errs by epsilon sqrt(k_i lambda). It also follows from the force of
// the next link, with its error and epsilon lambda sqrt(m_i): the forces on a free mass add up to
// -lambda m_i x_i.
void balance_forces(const Scene &scene, const std::vector<std::size_t> &free, ModalBasis &basis) {
  const std::size_t n = scene.mass.size();
  std::vector<double> force(n + 1), error(n + 1);  // of the links; none beyond the last mass
  for (Index j = 0; j < basis.lambda.size(); ++j) {
    const double lambda = basis.lambda(j);
    for (std::size_t i = 0; i < n; ++i) {
      force[i] = std::sqrt(scene.stiffness[i]) * basis.tension(static_cast<Index>(i), j);
      error[i] = std::sqrt(scene.stiffness[i] * lambda);
    }
    const auto balance = [&](std::size_t i, std::size_t to, std::size_t from, double sign) {
      const double ground = entry_of(scene.ground, i),
                   rounding =
                       error[from] + lambda * std::sqrt(scene.mass[i]) + std::sqrt(ground * lambda);
      if (!(rounding < error[to])) return;
      error[to] = rounding;
      force[to] = force[from] +
                  sign * (lambda * scene.mass[i] - ground) * basis.shape(static_cast<Index>(i), j);
      basis.tension(static_cast<Index>(to), j) = force[to] / std::sqrt(scene.stiffness[to]);
    };
    for (auto i = free.rbegin(); i != free.rend(); ++i) balance(*i, *i, *i + 1, 1.0);
    for (const std::size_t i : free) balance(i, i + 1, i, -1.0);
  }
}

}  // namespace

Eigen::Index springs(const Scene &scene) {
  return static_cast<Index>(scene.mass.size() * (scene.ground.empty() ? 1 : 2));
}

bool is_untied(const Scene &scene) {
  return scene.stiffness[0] == 0.0 &&
         std::all_of(scene.ground.begin(), scene.ground.end(), [](double k) { return k == 0.0; });
}

void set_static_positions(const Scene &scene, const Held &held, Eigen::VectorXd &x,
                          Eigen::VectorXd &tension) {
  const std::size_t n = scene.mass.size();
  std::vector<double> held_at(n, 0.0);
  for (const Stop &stop : scene.stops) {
    const auto i = static_cast<std::size_t>(stop.mass - 1);
    if (held[i] == static_cast<signed char>(stop.side)) held_at[i] = stop.position;
  }
  x.setZero(static_cast<Index>(n));
  tension.setZero(springs(scene));
  double left = 0.0;
  for (std::size_t i = 0; i < n;) {
    std::size_t anchor = i;
    while (anchor < n && held[anchor] == 0) ++anchor;
    const double right = anchor < n ? held_at[anchor] : left;
    if (i == 0 && scene.stiffness[0] == 0.0) left = right;  // not tied to the ground
    double total = 0.0, reached = 0.0;
    for (std::size_t j = i; j <= anchor && j < n; ++j) total += 1.0 / scene.stiffness[j];
    if (left != right)
      for (std::size_t j = i; j <= anchor && j < n; ++j)
        tension(static_cast<Index>(j)) = (right - left) / total / std::sqrt(scene.stiffness[j]);
    for (std::size_t j = i; j < anchor; ++j) {
      reached += 1.0 / scene.stiffness[j];
      x(static_cast<Index>(j)) = left == right ? left : left + (right - left) * (reached / total);
    }
    if (anchor < n) x(static_cast<Index>(anchor)) = right;
    left = right;
    i = anchor + 1;
  }
  for (std::size_t j = 0; j < n && !scene.ground.empty(); ++j)
    tension(static_cast<Index>(n + j)) = std::sqrt(scene.ground[j]) * x(static_cast<Index>(j));
}

ModalBasis modal_basis(const Scene &scene, const std::vector<std::size_t> &free) {
  const auto n = static_cast<Index>(scene.mass.size()), modes = static_cast<Index>(free.size());
  ModalBasis basis{VectorXd(modes), MatrixXd::Zero(n, modes), MatrixXd::Zero(modes, n),
                   MatrixXd::Zero(springs(scene), modes)};
  if (modes == 0) return basis;
  const bool floats = is_untied(scene) && modes == n;
  // A copy, because Eigen adds up in an order that depends on the alignment of the memory.
  const VectorXd mass = Eigen::Map<const VectorXd>(scene.mass.data(), n);
  MatrixXd vectors = eigenvectors_of(scene, free);
  if (floats)  // the rigid-body mode x = (1, ..., 1), in which no link has a tension
    rotate_to_front(mass.cwiseSqrt().normalized(), vectors);
  MatrixXd tension = tensions_of(scene, free, vectors);
  if (floats) tension.col(0).setZero();
  make_orthogonal(tension, vectors, floats ? 1 : 0);

  const VectorXd lambda = tension.colwise().squaredNorm().transpose();
  std::vector<Index> order(free.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(),
                   [&lambda](Index a, Index b) { return lambda(a) < lambda(b); });
  for (Index j = 0; j < modes; ++j) {
    const Index from = order[static_cast<std::size_t>(j)];
    const double orient = vectors(modes - 1, from) < 0.0 ? -1.0 : 1.0;
    basis.lambda(j) = lambda(from);
    basis.tension.col(j) = orient * tension.col(from);
    for (Index a = 0; a < modes; ++a) {
      const auto i = free[static_cast<std::size_t>(a)];
      const double u = orient * vectors(a, from), root_m = std::sqrt(scene.mass[i]);
      basis.shape(static_cast<Index>(i), j) = u / root_m;
      basis.inverse(j, static_cast<Index>(i)) = u * root_m;
    }
  }
  balance_forces(scene, free, basis);
  if (!floats) return basis;
  // The rigid-body mode is set without the rounding of roots, and the others are made orthogonal to
  // it.
  basis.shape.col(0).setConstant(1.0 / std::sqrt(mass.sum()));
  basis.inverse.row(0) = mass.transpose() / std::sqrt(mass.sum());
  for (Index j = 1; j < modes; ++j) {
    const double share = basis.inverse.row(0).dot(basis.shape.col(j));
    basis.shape.col(j) -= share * basis.shape.col(0);
    basis.inverse.row(j) -= share * basis.inverse.row(0);
  }
  return basis;
}

}  // namespace vibro_impact::detail
