// Tangents of a run: the exact derivative of the state at a later time by the state at the start.
//
// Between events the difference of two neighbouring motions obeys the unforced equations of the
// contact mode. At an event it jumps (saltation), because the neighbour reaches the stop at another
// time: with E = dz- + f- dt the change of the state *at the event* and R the impact law of Eq. 16,
//   dt = -dx_i / x_i',   dz+ = R E - f+ dt,
// f- and f+ being the vector fields before the event and after everything that happens at that
// instant (sticking at r = 0, the release of a neighbour by the jump of its hold force). A release
// at a root of the hold force (Eqs. 12-13, 23) changes nothing: state and vector field are
// continuous there.
//
// Complete chatter: the other masses move as if the chattering one stuck, but for order x^3 of the
// time x that is left (chatter_limit.hpp). So do tangents: with the mass brought to rest at an
// impact and held from then on, those of the accumulation point differ by order x^3, a smooth
// function of x over consecutive impacts that is extrapolated to x = 0. The held mass has no
// freedom left: each sticking mass costs the derivative two of its rank.
//
// A recorder, so that a run that does not ask for tangents pays nothing.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <vector>

#include "record.hpp"
#include "scene.hpp"

namespace vibro_impact {

// Forces of the links of the chain on its masses, -K x, for every column of x (N rows).
Eigen::MatrixXd link_forces(const Scene &scene, const Eigen::MatrixXd &x);

// Accelerations of all masses in the contact mode `held` (Eq. 4); zero for a held mass.
Eigen::VectorXd acceleration(const Scene &scene, const Held &held, const Eigen::VectorXd &x,
                             const Eigen::VectorXd &v, const Instant &instant);

struct TangentRecorder {
  // The derivative of (x_1 .. x_N, x_1' .. x_N') at `now`, 2N x columns. Rows of held masses are
  // zero.
  Eigen::MatrixXd tangent;
  // False when the motion met an event at which its state is not differentiable: impacts of several
  // masses at one instant, grazing, a mass coming to rest at its stop without chatter.
  bool differentiable = true;
  // Largest estimated error of a chatter limit of the tangents, relative to the tangents there.
  double chatter_error = 0.0;
  Instant now;

  // `start` is the state the run starts from, `columns` (2N x any number) the changes of it that
  // are followed; the rows of masses held there must be zero.
  TangentRecorder(const Scene &scene_of_run, const MotionState &start, Eigen::MatrixXd columns);

  void event(const Event &event, const Moment &moment);

  // Brings the tangents to the end of the run. To be called once, after the run.
  void finish(const Instant &end);

 private:
  // An impact of a chatter sequence, and the derivative of the state just after it with the mass
  // held from then on.
  struct Node {
    Instant instant;
    Eigen::MatrixXd derivative;
  };

  Scene scene, unforced;
  Clock clock;
  Instant started;
  Held held;  // up to the events of `group`
  long long stride;
  Modes<Eigen::Dynamic> modes = {};
  Counters counters = {};
  // The events of one instant, gathered until a later one shows that they are all.
  std::vector<Event> group = {};
  Eigen::VectorXd displacement = {}, velocity_before = {}, velocity = {};
  std::vector<Node> sequence = {};  // consecutive impacts of one mass
  int sequence_mass = 0;
  long long sequence_impacts = 0;
  double sequence_speed = 0.0;

  Eigen::Index masses() const {
    return tangent.rows() / 2;
  }
  static bool same(const Instant &a, const Instant &b) {
    return a.cycle == b.cycle && a.phase == b.phase;
  }
  void clear_rows_of_held();
  Eigen::VectorXd vector_field(const Held &mode, const Eigen::VectorXd &v) const;

  void flow_to(const Instant &instant);

  // Carries tangents (2N x any number) through a flight of tau in the contact mode `in`.
  void flow_columns(Eigen::MatrixXd &columns, double tau, const Held &in);

  // Short flights in physical coordinates: late in a chatter the change of the chattering mass is
  // small, and modal coordinates would lose it beside the others.
  void flow_by_series(Eigen::MatrixXd &columns, double tau, int order, const Held &in) const;

  void close();

  void saltation(const std::vector<const Event *> &impacts, const Held &after, bool impacts_only);

  // `tangent` is here the derivative of the state at the event.
  void extend_sequence(const Event &impact, const Eigen::RowVectorXd &dt);

  void chatter_limit(const Held &after);
};

}  // namespace vibro_impact
