// A flight of any length in closed form: its first event is found by bounds of the motion, without
// steps. A slow forcing, a stiff link that has come to rest, a chain far from its stops and one
// that has left them for good are all such flights.
#pragma once

#include <memory>
#include <vector>

#include "modal_form.hpp"
#include "simulation/flight/first_event.hpp"

namespace vibro_impact::detail {

// A flight under way. The calls of a run may end within it: its search stands between them, at the
// time `searched_to_` of the flight, and does not depend on where they end.
class LongFlight {
 public:
  bool is_under_way() const {
    return form_ != nullptr;
  }
  // True if the flight is under way, or takes over after so many steps without an event.
  bool takes_over(const Chain &chain, long long quiet_steps) const;
  // Keeps the start of the first of the steps without an event.
  void set_origin(const Motion &motion) {
    origin_ = motion;
  }
  // Sets the motion back to the origin, where the flight begins: a slow coordinate has lost digits
  // in the steps.
  void begin(const Chain &chain, Motion &motion);
  // Ends the flight at the time tau: moves the motion there, which is the origin of the next.
  void end(const Chain &chain, const Real &tau, Motion &motion);

  // Searches the first event, and counts the steps of the search. The time is infinite when the
  // call ends before any event. Without an event after `most_steps` the flight ends where it is.
  FlightEnd search(const Chain &chain, double end, long long most_steps, std::vector<Near> &near,
                   Counters &counters);

  // The motion at the time tau of the flight.
  const Motion &at(const Chain &chain, const Real &tau);

 private:
  // A coordinate at `searched_to_`, and its deviation from the static displacement.
  struct Coordinate {
    Real y = 0.0, dy = 0.0;
    ModalForce force{};
    Real deviation = 0.0;
  };
  // A part of the share of a coordinate in a contact: z'' + damping z' + stiffness z = force.
  struct Part {
    Real value, slope, damping, stiffness;
    double rate, amplitude;
    ModalForce force = {};
  };
  // The value of a contact is seen, or lies hidden below the rounding of its modal coordinates. It
  // then keeps its sign, by definition, until it is seen.
  enum class Sight : char { seen, hidden };
  struct NewtonStep {
    Real time = infinity;
    std::size_t contact = 0;
  };
  struct Bound;

  Motion origin_;  // where the flight begins
  Blocks blocks_;
  std::shared_ptr<const ModalForm> form_;
  ModalState state_;  // at the time evaluated last,
  Motion motion_;     // with the motion there
  Real motion_tau_ = -1.0;
  double searched_to_ = 0.0;
  std::vector<Coordinate> coordinates_;
  Turn turn_;                  // of the forcing, at `searched_to_`
  std::vector<Value> values_;  // of the contacts there,
  std::vector<Sight> sight_;   // and whether each is seen
  double l_ = 0.0;             // the time for which bounds are made
  bool is_at_event_ = false;   // the search has found an event there

  void evaluate(const Chain &chain, double time);
  template <class Use>
  void each_part_of(std::size_t coordinate, const Watch &watch, double length,
                    const Use &use) const;
  template <class Use>
  void each_part(const Watch &watch, double length, const Use &use) const;
  Polynomial bound_of(std::size_t contact, double l);
  double safe_time(double l, Counters &counters);
  double next_step(Counters &counters);
  void find_values(const Chain &chain, const Real &tau);
  NewtonStep newton_step() const;
  double longest_blind_step() const;
  bool look_at_hidden();
  bool find_appearance(const Chain &chain, double before, Counters &counters);
  Real refined(const Chain &chain, std::vector<Near> &near);
};

}  // namespace vibro_impact::detail
