// The equations of an impact family: the section at an impact, the flight back to it without its
// stop, and what must be zero there, with its derivatives.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <optional>
#include <vector>

#include "vibro_impact/analysis/impact_family.hpp"

namespace vibro_impact {

// The unknowns: the angle of the forcing, the free coordinates of the other masses, the parameter.
struct ImpactUnknowns {
  Eigen::VectorXd values;
  Held held;

  std::vector<std::size_t> others(std::size_t mass) const {
    std::vector<std::size_t> rows = free_coordinates(held);
    const std::size_t n = held.size();
    std::erase_if(rows, [&](std::size_t row) { return row % n == mass; });
    return rows;
  }
};

// What is fixed of a family at one speed and one set of unknowns.
struct ImpactSection {
  const ImpactFamily &family;
  Scene scene;
  std::size_t mass;
  double sigma, speed;
  ImpactLaw law;
  MotionState state;  // right after the impact

  ImpactSection(const ImpactFamily &of, const ImpactUnknowns &at, double closing);
};

// The first and the last event at a stop, in fractions of the time from `begin` to `begin` +
// `whole`; 1 and 0 where there is none.
struct OtherEvents {
  std::size_t stop;
  double begin, whole;
  double first = 1.0, last = 0.0;

  void event(const Event &event, const Moment &) {
    if (event.stop != stop || event.time < begin) return;
    first = std::min(first, (event.time - begin) / whole);
    last = std::max(last, (event.time - begin) / whole);
  }
};

// The motion one orbit after the impact, just before the next one, and its derivatives.
struct ImpactReturn {
  MotionState state;
  Eigen::MatrixXd tangent;       // by the free coordinates after the impact
  Eigen::VectorXd by_parameter;  // at a fixed phase
  OtherEvents others;
};

// What must be zero, its derivatives by the unknowns and by the speed, and what W is made of.
struct ImpactEquations {
  ImpactReturn back;
  Eigen::VectorXd residual, by_speed;
  Eigen::MatrixXd by_unknowns;
  Eigen::MatrixXd regular, singular;  // W = regular + singular / v, on the free coordinates
};

// Where the stop is in place between `from` and `to`, in fractions of the orbit, only. Nothing when
// the motion returns in another contact mode.
std::optional<ImpactEquations> equations(const ImpactSection &section, const ImpactUnknowns &at,
                                         double from, double to);

// True when the stop, put back, is not met on the halves of the flights it was taken from.
bool is_real(const ImpactSection &section, double from, double to);

}  // namespace vibro_impact
