// Special points between two orbits of a sequence: folds, flips, births of tori, branchings, and
// the parent of a branch of doubled period.
#pragma once

#include "ends.hpp"

namespace vibro_impact::branches {

struct SpecialPoint {
  BranchPoint kind = BranchPoint::fold;
  Sequence sequence;
  Vector u;
  double error = 0.0;  // of the parameter
  double part = 0.5;   // of the step
};

struct SpecialPoints {
  std::vector<SpecialPoint> points = {};  // in the order of the branch
  bool ends_the_branch = false;           // beyond the last one lies what has been passed, as at a
                                          // pitchfork its mirror image
};

SpecialPoints special_points_between(const Problem &problem, const Place &a, const Place &b);

}  // namespace vibro_impact::branches
