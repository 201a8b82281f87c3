// A walk along a branch: what it knows, its steps, and the events of two masses at one instant.
#pragma once

#include <utility>

#include "follow.hpp"

namespace vibro_impact::branches {

// The state of a walk along the branch.
struct Walk {
  Problem problem;
  double low, high;             // the ends of the range
  double longest;               // step
  double step;                  // the next one
  Place here;                   // the latest orbit
  std::optional<Place> before;  // the one before, if its sequence is the same
  Place first;
  int coincidences = 0;  // in a row
  std::vector<Point> points = {};

  void add(BranchPoint kind, const Place &place, double error = 0.0) {
    points.push_back({kind, place, error});
  }
  // The latest orbit ends the branch. It stands behind a special point as a point of its own.
  bool end(BranchPoint kind, std::string why_lost = {}) {
    if (points.back().kind != BranchPoint::orbit) add(kind, here);
    points.back().kind = kind;
    points.back().why_lost = std::move(why_lost);
    return false;
  }
  // The end of the range in the direction of the tangent.
  double end_ahead() const {
    return here.direction(0) > 0.0 ? high : low;
  }
};

// The product of two vectors of unknowns in their units.
double scaled_dot(const Walk &walk, const Vector &a, const Vector &b);

// The orbit at the end of the next step.
struct Step {
  Place to;
  bool at_end_of_range = false;
  bool found = false;  // if false, `to` has the prediction alone
};

Step take_step(const Walk &walk);

// The ends that a step, or the lack of one, makes possible, and the nearest of them that is an
// orbit. A press that vanishes at the event of another mass is a coincidence. Of two solutions at
// one place the more exact one counts.
std::vector<End> possible_ends(const Walk &walk, const Step &step);
std::optional<End> nearest_of(const Walk &walk, const Step &step, std::vector<End> ends);

// The last orbit of the sequence before an end, by bisection: special points may lie before it.
std::optional<Place> last_before_end(const Walk &walk, const Step &step);

// The orbit at an end. It has no multipliers where an impact has lost its speed: one of them grows
// beyond all bounds from its side.
Place place_of_end(const Problem &problem, const End &end);

// The events of two masses at one instant change places. False if there is no orbit beyond.
bool exchange(Walk &walk, const End &end);
// Many coincidences follow each other where two chatters pass through each other. A run beyond all
// of them has the new order. False if none is found.
bool pass_coincidences(Walk &walk);

}  // namespace vibro_impact::branches
