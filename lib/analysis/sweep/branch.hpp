// The orbits of a branch as points (z, q) in units of their own, and Newton's method for them.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "analysis/orbits/motion_state.hpp"
#include "vibro_impact/analysis/follow_orbit.hpp"

namespace vibro_impact {

// An orbit of the branch, with what Newton's method and the search for special points need.
struct Orbit {
  Eigen::VectorXd u;  // (z, q), each in its unit
  OrbitPoint point = {};
  Eigen::MatrixXd derivative = {};  // of the map, by the free coordinates in their units
  std::vector<Event> events = {};   // of one period, without the impacts that lead to sticks
};

// The free coordinates at a section, whose phase is a part of the forcing period, and a parameter.
class Branch {
 public:
  Branch(const Scene &scene, const Axis &range, int periods)
      : scene_(scene), range_(range), periods_(periods) {
  }

  // Makes the phase of a state the section, and its amplitude the unit of length.
  void set_section(const MotionState &state, double q);
  // Moves the section away from an event that has come near, and the latest two orbits to it.
  bool move_section(Orbit &last, Orbit &before);

  // The orbit on the plane through `guess` with this normal, a step of this length away from orbits
  // that are known. Nothing if Newton's method does not find it, and outside of what the scene
  // allows.
  std::optional<Orbit> orbit_at(const Eigen::VectorXd &guess, const Eigen::VectorXd &normal,
                                double length) const;

  Eigen::VectorXd vector_of(const MotionState &state, double q) const;
  double width() const {
    return std::abs(range_.to - range_.from);
  }
  double parameter(const Eigen::VectorXd &u) const {
    return u(u.size() - 1) * width();
  }
  // The scene at a point. A stop that moves takes the start of the scene along: no orbit depends on
  // it, and beyond a stop the scene would be refused.
  Scene scene_at(const Eigen::VectorXd &u) const;
  // The number of free coordinates, which is the index of the parameter.
  Eigen::Index coordinates_free() const {
    return unit_.size();
  }
  double unit_of_length() const {
    return length_;
  }

 private:
  const Scene &scene_;
  const Axis &range_;
  int periods_;
  double part_ = 0.0;  // of the section, in the forcing period
  Held held_ = {};     // at the section
  double length_ = 1.0;
  Eigen::VectorXd unit_ = {};

  MotionState state_of(const Scene &scene, const Eigen::VectorXd &u) const;
  std::optional<Orbit> correct(const Eigen::VectorXd &guess, const Eigen::VectorXd &normal,
                               double length) const;
};

}  // namespace vibro_impact
