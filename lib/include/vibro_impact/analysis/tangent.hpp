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
// Changes by parameters of the scene are taken at a fixed phase of the forcing: z(theta), theta =
// Omega t, because a stroboscopic map is read at a phase, and the period changes with Omega. Only
// the omega column feels the difference. Such changes obey the same equations with an inhomogeneous
// term g from the motion itself (Eq. 4 differentiated at fixed theta):
//   beta: -K x';  A_i: cos(Omega t);  m_i: -x_i'';  k_i: its link;  Omega: -(2 M x'' + beta K x') /
//   Omega, with dx' = (dx)' + x' / Omega for the velocity in time;
// the stop s moves the surface, dt = (ds - dx_i) / x_i', and a mass held at it moves along,
// dx_i = ds; r enters the impact law, dv+ = -r dv- - v- dr. Late impacts of a chatter fall as r^n,
// so that by r the smooth function of x above takes on terms n x^3, n x^4, ..., which have an
// extrapolation of their own.
//
// A recorder, so that a run that does not ask for tangents pays nothing.
#pragma once

#include <memory>
#include <vector>

#include "matrix.hpp"
#include "parameter.hpp"
#include "vibro_impact/record.hpp"
#include "vibro_impact/simulate.hpp"

namespace vibro_impact {

struct TangentOptions {
  // The last by.size() columns are changes that go with a unit change of these parameters, one
  // each; what is given of them is the change of the start that goes with it (zero: the same
  // state at the same phase; masses held there move with their stops). All kinds but initial
  // displacements and velocities, which are changes of the start.
  std::vector<Parameter> by = {};
  bool events = false;  // keep the changes of the events, too
};

// How the time of an event, counted from t = 0 as in Event, and the velocity before it change: one
// entry per column. NaN where they have no derivative. That of a stick at the end of a chatter is
// extrapolated from the impacts before.
struct EventChange {
  Event event;
  std::vector<double> time, velocity_before;
};

// What has become of the changes by the end of a run.
struct ChangesAtEnd {
  Matrix changes;  // 2N x columns; rows of held masses are zero, but for the change of their stop
  // False when the motion met an event at which its state is not differentiable: impacts of several
  // masses at one instant, grazing, a mass coming to rest at its stop without chatter.
  bool differentiable = true;
  // Largest estimated error of a chatter limit of the changes, relative to the changes there.
  double chatter_error = 0.0;
  std::vector<EventChange> events;  // if TangentOptions::events asks for them, in their order
};

class TangentRecorder {
 public:
  // `start` is the state the run starts from, `columns` (2N x any number, rows x_1 .. x_N, x_1' ..
  // x_N') the changes of it that are followed; the rows of masses held there must be zero. Throws
  // std::invalid_argument for a start or a number of rows that does not fit the scene, and for
  // parameters it does not have.
  TangentRecorder(const Scene &scene, const MotionState &start, const Matrix &columns,
                  const TangentOptions &options = {});
  ~TangentRecorder();

  void event(const Event &event, const Moment &moment);

  // Carries the changes to the end of the run: once, after it. Throws std::invalid_argument, as
  // `event` does, for a recorder that has finished, and for what is of another scene or time.
  ChangesAtEnd finish(const Instant &end);

 private:
  struct Tangents;
  std::unique_ptr<Tangents> tangents_;
};

}  // namespace vibro_impact
