// Vectors and matrices of numbers of twice the precision, as Eigen takes them.
#pragma once

#include <Eigen/Core>

#include "simulation/chain/twofold.hpp"

namespace Eigen {

template <>
struct NumTraits<vibro_impact::detail::Real> : GenericNumTraits<vibro_impact::detail::Real> {
  using Real = vibro_impact::detail::Real;
  using NonInteger = Real;
  using Nested = Real;
  using Literal = double;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 2,
    AddCost = 11,
    MulCost = 22
  };
  static Real epsilon() {
    return 0x1p-104;
  }
  static Real dummy_precision() {
    return 0x1p-90;
  }
};

}  // namespace Eigen

namespace vibro_impact::detail {

using RealVector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
using RealMatrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

}  // namespace vibro_impact::detail
