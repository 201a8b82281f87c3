// The ends of a branch: where the sequence of events of its orbits changes. Each end is an orbit
// that fulfils one condition more. It is solved by itself, from a step beyond it, where the
// equations are still smooth.
//
//   end                            condition
//   graze, from either side        a `touch` replaces the impact or is added, and its gap is 0
//   multi-sliding                  a `dip` is added, and its press is 0; from the split side the
//                                  excursion of the mass is closed first
//   border orbit, r = 0            the press at the impact is 0
//   border orbit                   impacts are self-similar there: w = c f s^2 (border_constant)
//   events of two masses at once   the flight between them has no length
#pragma once

#include "sequence.hpp"
#include "vibro_impact/analysis/follow_orbit.hpp"

namespace vibro_impact::branches {

// An orbit of the branch with what its tests need.
struct Place {
  Sequence sequence;
  Vector u;
  Vector direction;  // tangent
  double orientation = 1.0;
  Multipliers multipliers;
  Inspection seen;

  double parameter() const {
    return u(0);
  }
};
// The place of a solution, with the sign of the tangent of `along`.
Place place_of(const Problem &problem, const Sequence &s, const Vector &u, const Vector &along);

// How an end is told from another orbit that solves the same condition.
enum class Guess {
  at_part,  // it lies near the part of the step that the test function predicts
  nearby,   // it lies within the step or shortly beyond it: the test function is none
  collapse  // an excursion shrinks, and its length predicts the parameter
};

struct End {
  BranchPoint kind = BranchPoint::graze;
  Condition condition;
  Sequence sequence;
  Vector u;           // a guess, then the orbit
  double part = 0.5;  // of the step: a guess, then that of the orbit
  Guess guess = Guess::at_part;
  bool replaces_impact = false;  // a graze from the side of the impact
  bool is_unexplained = false;   // a change for which no end is known, as of a jump that ends
  size_t group = 0;              // of guesses for the same end; 0: none
  double expected = 0.0;         // the parameter of a collapse
  double error = 0.0;            // of the parameter, once it is solved
};

// The ends that the test functions find between two orbits of a sequence.
std::vector<End> ends_between(const Problem &problem, const Place &from, const Vector &to,
                              const Inspection &seen_to);
// The border orbits that the chatters of an orbit may come to.
std::vector<End> border_ends(const Problem &problem, const Place &from);
// The multi-slidings at which excursions between two sticking phases close, as they shrink from one
// orbit of a sequence to another.
std::vector<End> collapses_between(const Problem &problem, const Sequence &s, const Vector &from,
                                   const Vector &to);

// Solves an end, moves it to the solution and returns true if it is an orbit of the chain: no
// flight is shorter than nothing, and no contact lies below zero.
bool solve_end(const Problem &problem, End &end);

}  // namespace vibro_impact::branches
