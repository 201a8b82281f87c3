// K = G^T G, where G gives the tensions of the springs, so that the modes are the right singular
// vectors of G M^-1/2. Rotations of its columns (one-sided Jacobi) keep the relative accuracy of
// soft modes in stiff chains.
#include "modes.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "simulation/chain/tolerances.hpp"

namespace vibro_impact::detail {

namespace {

using Eigen::Index;

// The tensions of the springs of a block for a displacement of each mass times the root of the
// mass.
struct Tensions {
  RealMatrix matrix;
  bool tied = false;  // to the ground or to a held mass
};

Tensions tensions_of(const Chain &chain, std::size_t first, const RealVector &root) {
  const Index n = root.size();
  const std::size_t last = first + static_cast<std::size_t>(n) - 1;
  Tensions tensions{RealMatrix::Constant(2 * n + 1, n, Real(0.0))};
  Index row = 0;
  // `upper` and `lower` outside 0, ..., n - 1 do not move.
  const auto add_spring = [&](double stiffness, Index upper, Index lower) {
    if (stiffness == 0.0) return;
    const Real tension = sqrt(Real(stiffness));
    if (upper < n) tensions.matrix(row, upper) = tension / root(upper);
    if (lower >= 0) tensions.matrix(row, lower) = -tension / root(lower);
    tensions.tied = tensions.tied || upper == n || lower < 0;
    ++row;
  };
  for (Index i = 0; i < n; ++i) {
    add_spring(chain.link[first + static_cast<std::size_t>(i)], i, i - 1);
    add_spring(chain.ground[first + static_cast<std::size_t>(i)], i, -1);
  }
  add_spring(chain.above(last), n, n - 1);
  tensions.matrix.conservativeResize(row, n);
  return tensions;
}

// Rotates columns p and q of a matrix by the angle with this cosine and sine.
void rotate(RealMatrix &matrix, Index p, Index q, const Real &cosine, const Real &sine) {
  for (Index i = 0; i < matrix.rows(); ++i) {
    const Real old = matrix(i, p), other = matrix(i, q);
    matrix(i, p) = cosine * old - sine * other;
    matrix(i, q) = sine * old + cosine * other;
  }
}

// Rotates the columns of `factor` until they are orthogonal; `vectors` takes part.
void make_orthogonal(RealMatrix &factor, RealMatrix &vectors) {
  const Index n = factor.cols();
  double largest = 0.0;
  for (Index j = 0; j < n; ++j) largest = std::max(largest, rounded(factor.col(j).squaredNorm()));
  bool rotated = true;
  for (int sweep = 0; rotated && sweep < most_sweeps; ++sweep) {
    rotated = false;
    for (Index p = 0; p < n; ++p) {
      for (Index q = p + 1; q < n; ++q) {
        const Real pp = factor.col(p).squaredNorm(), qq = factor.col(q).squaredNorm(),
                   pq = factor.col(p).dot(factor.col(q));
        // A weak link may be all that ties two columns: the rounding of their product is relative
        // to its terms.
        double terms = 0.0;
        for (Index i = 0; i < factor.rows(); ++i)
          terms += std::abs(factor(i, p).hi * factor(i, q).hi);
        constexpr double rounding = 16.0 * twofold_unit;
        if (!(std::abs(rounded(pq)) > rounding * terms)) continue;
        // The mode of a rigid body has no tension, but for rounding.
        if (std::min(rounded(pp), rounded(qq)) < rounding * rounding * largest) continue;
        const Real zeta = (qq - pp) / (2.0 * pq), root = sqrt(1.0 + zeta * zeta);
        const Real t = zeta.hi < 0.0 ? -1.0 / (root - zeta) : 1.0 / (root + zeta);
        const Real cosine = 1.0 / sqrt(1.0 + t * t), sine = cosine * t;
        rotate(factor, p, q, cosine, sine);
        rotate(vectors, p, q, cosine, sine);
        rotated = true;
      }
    }
  }
}

// The eigenvectors of G^T G in double precision, made orthogonal by a step V (3 - V^T V) / 2 of
// Newton's in twice the precision: rotations from here on are few.
RealMatrix start_of_modes(const RealMatrix &factor) {
  const Index n = factor.cols();
  const Eigen::MatrixXd rounded_factor = factor.unaryExpr([](const Real &x) { return x.hi; });
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(rounded_factor.transpose() *
                                                              rounded_factor);
  const RealMatrix v = solver.eigenvectors().unaryExpr([](double x) { return Real(x); });
  const RealMatrix correction = RealMatrix::Identity(n, n) * Real(3.0) - v.transpose() * v;
  return v * correction * Real(0.5);
}

}  // namespace

BlockModes modes_of_block(const Chain &chain, std::size_t first, std::size_t last) {
  const auto n = static_cast<Index>(last - first + 1);
  RealVector root(n);
  for (Index i = 0; i < n; ++i)
    root(i) = sqrt(Real(chain.mass[first + static_cast<std::size_t>(i)]));
  const Tensions tensions = tensions_of(chain, first, root);
  RealMatrix vectors = start_of_modes(tensions.matrix), factor = tensions.matrix * vectors;
  make_orthogonal(factor, vectors);
  BlockModes modes{{}, RealVector(n)};
  for (Index j = 0; j < n; ++j) modes.lambda(j) = factor.col(j).squaredNorm();
  if (!tensions.tied) {
    Index rigid = 0;
    for (Index j = 1; j < n; ++j)
      if (modes.lambda(j) < modes.lambda(rigid)) rigid = j;
    vectors.col(rigid) = root;
    modes.lambda(rigid) = 0.0;
  }
  modes.shape.resize(n, n);
  for (Index j = 0; j < n; ++j) {
    const Real norm = sqrt(vectors.col(j).squaredNorm());
    for (Index i = 0; i < n; ++i) modes.shape(i, j) = vectors(i, j) / (norm * root(i));
  }
  return modes;
}

}  // namespace vibro_impact::detail
