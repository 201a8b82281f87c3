// The derivative of the end of a motion by its start, or the reason why it does not exist.
//
// Between events the difference of two neighbouring motions obeys the unforced equations of the
// contact mode. At an event it jumps (saltation), because the neighbour reaches the stop at another
// time. Let dz- and dz+ be the difference before and after the event, f- and f+ the vector fields
// before and after everything that happens at that instant (sticking at r = 0, the release of a
// neighbour by the jump of its hold force), and R the derivative of the impact law of Eq. 16. Then
//   dt = -dx_i / x_i',   E = dz- + f- dt,   dz+ = R E - f+ dt,
// where E is the difference of the states at their events. A release at a root of the hold force
// (Eqs. 12-13, 23) changes nothing: state and vector field are continuous there.
//
// Complete chatter: let x be the time from an impact to the accumulation point. The other masses
// move as if the chattering mass were held from that impact on, up to terms of order x^3. So do the
// tangents: those computed with the mass held from an impact on differ at the accumulation point by
// x^3 times a smooth function of x, which is extrapolated to x = 0 over consecutive impacts. A
// sticking mass has no freedom: each costs the derivative two of its rank.
//
// The derivative does not exist where a mass grazes, where a mass comes to rest without a chatter
// or is at rest at its stop without a force, and where two masses hit at one instant and a damper
// joins them: the jump of one velocity changes the force on the other, so that the derivative
// depends on which mass is first.
#pragma once

#include <map>
#include <vector>

#include "modal_basis.hpp"
#include "motion.hpp"
#include "vibro_impact/analysis/smooth.hpp"

namespace vibro_impact {

// Moves tangents through a flight in one contact mode, in closed form.
class TangentFlow {
 public:
  TangentFlow(const Scene &scene, const Held &held);
  // Rows of held masses become zero, also where no time passes.
  void move(Eigen::MatrixXd &tangents, double time);

 private:
  double beta_;
  ModalBasis modes_;
  Eigen::MatrixXd y_ = {}, dy_ = {}, was_ = {};  // storage
};

// Tangents, 2N rows and any number of columns, carried from knot to knot.
class Tangents {
 public:
  Tangents(const Scene &scene, const MotionState &start, Eigen::MatrixXd first);
  // The knots of a motion from the start, or from the end of the motion before.
  void pass(const std::vector<Knot> &knots);
  Smooth<Eigen::MatrixXd> get() const {
    return why_not_.empty() ? Smooth<Eigen::MatrixXd>(tangents_)
                            : Smooth<Eigen::MatrixXd>::none(why_not_);
  }
  // Multiplies all tangents by a number.
  void scale(double factor);

 private:
  // An impact: E, dt, and the vector field just after it with its mass held from then on.
  struct Node {
    Instant instant;
    Eigen::MatrixXd tangents;
    Eigen::RowVectorXd dt;
    Eigen::VectorXd held;
  };

  Scene scene_;
  Clock clock_;
  MotionState before_;  // the latest knot
  bool at_start_ = true;
  Eigen::MatrixXd tangents_;
  std::map<Held, TangentFlow> flows_ = {};
  std::vector<Node> nodes_ = {};  // consecutive impacts at one stop
  int nodes_stop_ = 0;
  std::string why_not_ = {};

  Eigen::VectorXd force_ = {};  // at the knot, without the dampers

  void carry(const Held &held, double time, Eigen::MatrixXd &tangents);
  Eigen::VectorXd vector_field(const Held &held, const std::vector<double> &v) const;
  void apply(const std::vector<Event> &events, const MotionState &after);
  void apply_impacts(const std::vector<Event> &impacts, const MotionState &after, bool alone);
  void apply_stick(const MotionState &after);
};

// The derivative of the end of a motion, 2N rows, by the coordinates that are free at the start, in
// units of theirs (2N). Displacements and velocities should be equally large in them.
Smooth<Eigen::MatrixXd> derivative_of(const Motion &motion, const Eigen::VectorXd &units);

}  // namespace vibro_impact
