// A plane in units of a box.
#pragma once

#include <cmath>

#include "vibro_impact/analysis/continuation.hpp"

namespace vibro_impact {

// Vectors of the plane in units of the box.
struct Units {
  double width, height;

  explicit Units(const PlaneBox &box)
      : width(box.x_to - box.x_from), height(box.y_to - box.y_from) {
  }
  // Along the curve, of length one, with its gradient to the left.
  PlanePoint tangent(const CurvePoint &point) const {
    const double gx = point.gradient.x * width, gy = point.gradient.y * height;
    const double length = std::hypot(gx, gy);
    return {gy / length, -gx / length};
  }
  // Across it, to the left.
  PlanePoint across(const CurvePoint &point) const {
    const PlanePoint along = tangent(point);
    return {-along.y * width, along.x * height};
  }
  PlanePoint moved(const PlanePoint &from, const PlanePoint &direction, double by) const {
    return {from.x + by * direction.x * width, from.y + by * direction.y * height};
  }
  double distance(const PlanePoint &a, const PlanePoint &b) const {
    return std::hypot((a.x - b.x) / width, (a.y - b.y) / height);
  }
};

inline bool inside(const PlaneBox &box, const PlanePoint &at) {
  return at.x >= box.x_from && at.x <= box.x_to && at.y >= box.y_from && at.y <= box.y_to;
}

}  // namespace vibro_impact
