// A periodic orbit as a sequence of events. The unknowns u are the parameter q of the branch, the
// angle Omega t and the state just after event 0, and the length of each flight. The equations are
// one for each event, the closure of the state and that of the period. They are smooth through a
// grazing and through events of two masses at one instant. An orbit starts at an event of its own,
// so that there is no section to choose.
//
// A complete chatter is its impacts down to a flight x with (rate x)^3 below rounding. The last one
// holds the mass. From there on the other masses move as in the chatter but for O(x^3).
#pragma once

#include <optional>
#include <utility>

#include "flight.hpp"
#include "vibro_impact/analysis/periodic_orbit.hpp"

namespace vibro_impact::branches {

using Vector = Eigen::VectorXd;
using Dense = Eigen::MatrixXd;

// The kind of an item of a sequence, and the equation that it gives.
enum class Happening {
  start,    // no event: the angle is a multiple of 2 pi
  impact,   // gap = 0
  hold,     // gap = 0: an impact after which the mass is held
  release,  // press = 0
  jump,     // a release by an event of a neighbour: no time passes before it
  touch,    // gap speed = 0, without effect
  dip,      // slope of the press = 0, without effect
  pause     // no time passes before it, without effect
};

struct Item {
  Happening what = Happening::impact;
  int stop = 0;  // from 0
  bool operator==(const Item &) const = default;
};

struct Sequence {
  int periods = 1;
  std::vector<Item> items;       // in the order of time; the first follows the last
  std::vector<int> always_held;  // by mass: a stop from 0, or -1
  bool operator==(const Sequence &) const = default;
};

constexpr bool hits(Happening what) {
  return what == Happening::impact || what == Happening::hold;
}
constexpr bool releases(Happening what) {
  return what == Happening::release || what == Happening::jump;
}

// The scene, what varies along the branch, and the units of the unknowns.
struct Problem {
  Scene scene;
  std::string parameter;
  double width = 1.0;   // of the range of the parameter
  double length = 1.0;  // of the displacements

  // The size of the parameter, to which its rounding refers.
  double parameter_size(double q) const {
    return std::max(std::abs(q), width);
  }
  size_t masses() const {
    return scene.mass.size();
  }
  size_t mass_of(const Item &item) const {  // from 0
    return static_cast<size_t>(scene.stops[static_cast<size_t>(item.stop)].mass - 1);
  }
  // The places of the unknowns. The angle is unknown 1.
  Eigen::Index y_at(size_t mass) const {
    return index(2 + mass);
  }
  Eigen::Index v_at(size_t mass) const {
    return index(2 + masses() + mass);
  }
  Eigen::Index time_at(size_t flight) const {
    return index(2 + 2 * masses() + flight);
  }
  Eigen::Index unknowns(const Sequence &s) const {
    return time_at(s.items.size());
  }
};

// The scene at a value of the parameter. No orbit depends on the start of the scene, which is moved
// inside the stops.
Scene scene_at(const Problem &problem, double q);

// One more equation than those of an orbit.
enum class Extra {
  plane,    // the unknowns lie on a plane
  contact,  // the gap is zero at a touch, or the press at a dip or a pause
  no_time,  // the flight that begins at the item has no length
  press,    // the press after the impact is zero
  speed,    // the impact has no speed
  border    // the chatter ends where the press does
};
struct Condition {
  Extra extra = Extra::plane;
  size_t item = 0;
  Vector normal = {};  // of the plane normal . u = offset
  double offset = 0.0;
};
// The orbits with this value of the parameter.
Condition at_parameter(const Problem &problem, const Sequence &s, double q);
// The orbits on the plane through a point that is normal to a direction, both in their units.
Condition on_plane(const Problem &problem, const Sequence &s, const Vector &point,
                   const Vector &direction);

// The lengths in which the unknowns are compared.
Vector units_of(const Problem &problem, const Sequence &s);

// The left sides of the equations, with those of a condition as the last one, and the derivatives
// of them by the unknowns where they are asked for.
struct Equations {
  Vector values;
  Dense jacobian;
};
Equations evaluate(const Problem &problem, const Sequence &s, const Vector &u,
                   const Condition *condition, bool derivatives);

// The state just after item 0, with so many columns.
State start_of(const Problem &problem, const Model &model, const Sequence &s, const Vector &u,
               Eigen::Index columns);

// Impacts with the gap speeds w_j accumulate where the press -f s vanishes, s being the time left,
// if w = c f s^2 after each of them. Returns c and its derivative by the parameter for the ratio of
// the gap speeds after and before an impact.
Coefficient border_constant(const Coefficient &ratio);

// Newton's method for the equations with a condition. Moves u to the solution and returns true if
// it is found, to rounding if asked for. `error` becomes the estimated error of the parameter.
bool solve(const Problem &problem, const Sequence &s, Vector &u, const Condition &condition,
           bool to_rounding = false, double *error = nullptr);

// The tangent of the branch in its unknowns, of length 1 in their units and with the sign of
// `along`, and the sign of the determinant bordered by it. Along a branch this sign changes at a
// branching alone.
struct Tangent {
  Vector direction;
  double orientation = 1.0;
};
Tangent tangent_of(const Problem &problem, const Sequence &s, const Dense &jacobian,
                   const Vector &along);

// The Floquet multipliers, largest modulus first: the event times are eliminated. Empty if the
// jacobian is not finite.
Multipliers multipliers_of(const Problem &problem, const Sequence &s, const Dense &jacobian);

// The orbit at an event, as the test functions of the ends need it.
struct AtItem {
  double speed = 0.0;  // closing speed of an impact
  double press = 0.0;  // on the mass: after a hold, after an impact without rebound, at a release
  double slope = 0.0;  // of the press, at the same events
  State after;
};
// A local minimum of a gap or a press, or the press after an event.
struct Minimum {
  bool is_press = false, after_event = false;
  int stop = 0;
  size_t flight = 0;
  double offset = 0.0, value = 0.0;
};
struct Inspection {
  std::vector<AtItem> items;
  std::vector<Minimum> minima;
};
// Minima are looked for at six nodes in each step of at most 1.5 radians of the fastest rate.
Inspection inspect(const Problem &problem, const Sequence &s, const Vector &u);

// --- The same orbit by another sequence ----------------------------------------------------------

// The sequence begins at item k instead of item 0.
void rotate(const Problem &problem, Sequence &s, Vector &u, size_t k);
// Changes the displacements at the start from the stops last touched in `from` to those in `to`.
void re_express(const Problem &problem, const Sequence &from, const Sequence &to, Vector &u);
// Divides a flight after a time `offset`, or joins the flights before and after item k.
Vector divided(const Problem &problem, const Vector &u, size_t flight, double offset);
Vector joined(const Problem &problem, const Vector &u, size_t k);
// Gives each chatter the impacts that it needs, no more and no less. True if there were others.
bool adapt_chatters(const Problem &problem, Sequence &s, Vector &u, Vector *tangent = nullptr);
// True if an orbit repeats itself after half of its periods.
bool repeats_after_half(const Problem &problem, const Sequence &s, const Vector &u);
// Halves the periods of an orbit as long as it repeats itself after half of them.
void reduce_period(const Problem &problem, Sequence &s, Vector &u);
// The index of the item after half the periods from which the kinds of events repeat but for the
// length of chatters; 0 if there is none. The first half as an orbit of its own.
size_t half_of_period(const Problem &problem, const Sequence &s, const Vector &u);
std::pair<Sequence, Vector> first_half(const Problem &problem, const Sequence &s, const Vector &u);

using SequenceOrbit = std::pair<Sequence, Vector>;
// The sequence of an orbit that a run finds from a state, whose scene is that of the problem.
// Nothing if its sticking phases do not all begin with an impact.
std::optional<SequenceOrbit> sequence_from_run(const Problem &problem, const MotionState &orbit,
                                               int periods);
// The state in the middle of the longest flight, in the first forcing period.
MotionState quiet_state(const Problem &problem, const Sequence &s, const Vector &u,
                        const Inspection &seen);

}  // namespace vibro_impact::branches
