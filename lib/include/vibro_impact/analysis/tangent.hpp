// Tangents of a run: the exact derivative of the state at a later time by the state at the start.
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
// A recorder carries the tangents, so that a run that does not ask for them pays nothing.
#pragma once

#include <memory>

#include "matrix.hpp"
#include "vibro_impact/record.hpp"
#include "vibro_impact/simulate.hpp"

namespace vibro_impact {

// The tangents at the end of a run.
struct TangentsAtEnd {
  Matrix tangents;  // 2N x columns; rows of held masses are zero
  // False when the motion met an event at which its state is not differentiable: impacts of several
  // masses at one instant, grazing, a mass coming to rest at its stop without chatter.
  bool differentiable = true;
  // Largest estimated error of the limit of a chatter, relative to the largest tangent there.
  double chatter_error = 0.0;
};

class TangentRecorder {
 public:
  // `start` is the state the run starts from. `columns` (2N x any number, rows x_1 .. x_N, x_1' ..
  // x_N') are the tangents there; the rows of held masses must be zero. Throws
  // std::invalid_argument for a start or columns that do not fit the scene.
  TangentRecorder(const Scene &scene, const MotionState &start, const Matrix &columns);
  ~TangentRecorder();

  // Throws std::invalid_argument after `finish`, and for an event of another scene.
  void event(const Event &event, const Moment &moment);

  // Carries the tangents to the end of the run. To be called once, after the run. Throws
  // std::invalid_argument when called again, and for an end before the start.
  TangentsAtEnd finish(const Instant &end);

 private:
  class Tangents;
  std::unique_ptr<Tangents> tangents_;
};

}  // namespace vibro_impact
