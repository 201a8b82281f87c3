// A branch of orbits by pseudo-arclength in the unknowns of a sequence.
#pragma once

#include "ends.hpp"
#include "vibro_impact/analysis/sweep.hpp"

namespace vibro_impact::branches {

// A point of a branch.
struct Point {
  BranchPoint kind = BranchPoint::orbit;
  Place place;
  double error = 0.0;  // of the parameter, at a special point
  std::string why_lost = {};
};

// The branch from its first orbit on, at first towards range.to, until it has so many points.
std::vector<Point> follow(const Problem &problem, const Sequence &s, const Vector &u,
                          const Axis &range, int most_points);

// The point as the public headers have it.
OrbitPoint orbit_point_of(const Problem &problem, const Point &point);

}  // namespace vibro_impact::branches
