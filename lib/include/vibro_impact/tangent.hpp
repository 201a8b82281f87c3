// Tangents of a run: the exact derivative of the state at a later time by the state at the start.
//
// Between events the difference of two neighbouring motions obeys the unforced equations of the
// contact mode. At an event it jumps (saltation), because the neighbour reaches the stop at another
// time: with E = dz- + f- dt the change of the state *at the event* and R the derivative of the
// impact law of Eq. 16,
//   dt = -dx_i / x_i',   dz+ = R E - f+ dt,
// f- and f+ being the vector fields before the event and after everything that happens at that
// instant (sticking at r = 0, the release of a neighbour by the jump of its hold force). A release
// at a root of the hold force (Eqs. 12-13, 23) changes nothing: state and vector field are
// continuous there.
//
// Complete chatter: the other masses move as if the chattering one stuck, but for order x^3 of the
// time x that is left. So do tangents: with the mass brought to rest at an impact and held from
// then on, those of the accumulation point differ by order x^3, a smooth function of x over
// consecutive impacts that is extrapolated to x = 0. (The run itself carries the state by the
// moments of the impacts to come; a recorder sees the impacts that were, and no more.) The held
// mass has no freedom left: each sticking mass costs the derivative two of its rank.
//
// A recorder, so that a run that does not ask for tangents pays nothing.
#pragma once

#include <memory>

#include "matrix.hpp"
#include "record.hpp"
#include "simulate.hpp"

namespace vibro_impact {

class TangentRecorder {
 public:
  // `start` is the state the run starts from, `columns` (2N x any number, rows x_1 .. x_N, x_1' ..
  // x_N') the changes of it that are followed; the rows of masses held there must be zero. Throws
  // std::invalid_argument for a start or a number of rows that does not fit the scene.
  TangentRecorder(const Scene &scene, const MotionState &start, const Matrix &columns);
  ~TangentRecorder();
  TangentRecorder(TangentRecorder &&) noexcept;
  TangentRecorder &operator=(TangentRecorder &&) noexcept;

  void event(const Event &event, const Moment &moment);

  // Brings the tangents to the end of the run. To be called once, after the run.
  void finish(const Instant &end);

  // The changes at the last event, or at the end: 2N x columns. Rows of held masses are zero.
  Matrix tangent() const;
  // False when the motion met an event at which its state is not differentiable: impacts of several
  // masses at one instant, grazing, a mass coming to rest at its stop without chatter.
  bool differentiable() const;
  // Largest estimated error of a chatter limit of the tangents, relative to the tangents there.
  double chatter_error() const;

 private:
  struct Tangents;
  std::unique_ptr<Tangents> tangents_;
};

}  // namespace vibro_impact
