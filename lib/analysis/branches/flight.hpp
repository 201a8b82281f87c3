// Flights between events, with the derivatives of the state by the unknowns of an orbit.
//
// A row has a value and its derivatives: column 0 is the value, column 1 + j the derivative by
// unknown j, and unknown 0 is the parameter of the branch. The equations of a contact mode are
// linear in the state. So the Taylor recurrence (2) of the chain serves values and derivatives
// alike; only the parameter adds the derivatives of the coefficients.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "vibro_impact/scene.hpp"

namespace vibro_impact::branches {

using std::size_t;
using Row = Eigen::Array<double, 1, Eigen::Dynamic>;
using Rows = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

inline Eigen::Index index(size_t k) {
  return static_cast<Eigen::Index>(k);
}

// A number of the scene and its derivative by the parameter.
struct Coefficient {
  double value = 0.0, slope = 0.0;
};

struct ModelStop {
  size_t mass = 0;  // from 0
  double sigma = 1.0;
  Coefficient position;
  ImpactLaw law, law_below, law_above;  // at q, q - law_step and q + law_step
  Coefficient ratio_at_rest() const;    // of the gap speeds after and before a slow impact
};

// The numbers of a scene at a value of the parameter. Each is independent of it or equal to it.
struct Model {
  std::vector<Coefficient> inverse_mass, link, ground, cosine, sine, constant;
  Coefficient beta, omega;
  std::vector<ModelStop> stops;
  double rate = 1.0;  // a bound of every rate of the chain

  Model(const Scene &scene, const std::string &parameter, double q);
  size_t masses() const {
    return inverse_mass.size();
  }
  const ModelStop &stop(int k) const {
    return stops[static_cast<size_t>(k)];
  }
};

// The gap speed after an impact with the gap speed `closing`, and its derivative by both. Beyond a
// grazing, where `closing` is negative, the law is continued as an odd function.
struct Rebound {
  double speed, by_closing, by_parameter;
};
Rebound rebound(const ModelStop &stop, double closing);

// The motion at an instant. The displacement y of a mass counts from the stop that it touched last,
// so that the gap of a chattering mass has no cancellation.
struct State {
  Rows y, v;
  Row angle;                       // Omega t
  std::vector<int> touched, held;  // by mass: the number of a stop from 0, or -1
};

// The Taylor expansion of a model, which moves states through flights.
class Flow {
 public:
  Flow(const Model &model, Eigen::Index columns);

  // The coefficients of the displacement of a mass, and of the force on it, at the latest
  // expansion.
  auto displacement(int order, size_t mass) {
    return x_.row(order * masses_ + index(mass));
  }
  auto force(int order, size_t mass) {
    return force_.row(order * masses_ + index(mass));
  }

  // The time of a radian of the fastest rate. In this unit, the coefficients of all orders are far
  // from underflow, whatever the unit of time.
  double radian() const {
    return 1.0 / model_.rate;
  }
  // Expands so many columns of the state up to an order.
  void expand(const State &state, Eigen::Index columns, int order);

  // Moves the values of the state on, or so many columns of it, where the length of the flight is
  // unknown `by`. Values alone may be watched: `watch` is called for every step.
  using Watch = std::function<void(double begin, double step, int order)>;
  void fly(State &state, double time, const Watch &watch = {});
  void fly(State &state, double time, Eigen::Index by, Eigen::Index columns);

  static constexpr int most_orders = 34;

 private:
  const Model &model_;
  Eigen::Index masses_;
  Rows x_, force_, z_, wave_;

  void move(State &state, double time, Eigen::Index columns, const Watch &watch);
};

}  // namespace vibro_impact::branches
