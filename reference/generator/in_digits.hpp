// The scene that is simulated, in many digits: a chain of masses and its stops. The numbers of
// every scene stand in reference/scenes, in double.
#pragma once

#include "reference/scenes/paper_scenes.hpp"
#include "vibro_impact/scene_fields.hpp"

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cstddef>
#include <iterator>
#include <vector>

namespace vibro_impact_reference {

/// The number type of the whole generator.
using Real = boost::multiprecision::cpp_bin_float_50;

using Vector = std::vector<Real>;
using Matrix = std::vector<Vector>;  // rows of equal length

using vibro_impact::Side;

/// A rigid stop. An upper stop keeps its mass at x <= position, a lower one at x >= position. The
/// side is explicit: the sign of the position does not tell it, and a stop may sit at zero.
struct Stop {
  std::size_t mass;  // counted from 0; tables count from 1
  Side side;
  Real position;
  Real restitution;  // r of Eq. 8 (rebuilt)
};

/// Names the fields of a scene: `scene[&Field::mass]` are the masses.
using Field = vibro_impact::Scene;

/// One run from given initial conditions at t = 0 to end_time. The fields are those of
/// scene_fields.hpp, in the order of its lists. A list has an entry for each mass.
///
/// Link i joins mass i-1 to mass i, link 1 joins mass 1 to ground, the last mass is free: Eqs. 1-2.
/// The dampers are proportional to the springs, c_i = beta k_i (the paper's assumption before Eq.
/// 4). The forcing is f(t) = A cos(omega t) + B sin(omega t) + P. Everything is non-dimensional.
struct Scene {
  std::array<Vector, std::size(vibro_impact::list_fields)> lists = {};
  std::array<Real, std::size(vibro_impact::scalar_fields)> scalars = {};
  std::vector<Stop> stops = {};
  Real end_time = 0;

  const Vector &operator[](std::vector<double> Field::*field) const {
    return lists[place_of(field, vibro_impact::list_fields)];
  }
  const Real &operator[](double Field::*field) const {
    return scalars[place_of(field, vibro_impact::scalar_fields)];
  }
  Real &operator[](double Field::*field) {
    return scalars[place_of(field, vibro_impact::scalar_fields)];
  }
  std::size_t masses() const {
    return (*this)[&Field::mass].size();
  }

 private:
  template <class Member, class Fields>
  static std::size_t place_of(Member member, const Fields &fields) {
    std::size_t place = 0;
    while (fields[place].value != member) ++place;
    return place;
  }
};

/// A scene of reference/scenes, which are in double, as the library computes: every number is taken
/// over exactly, so that 0.1 is the double nearest to 0.1, too. A list that is left out is zero.
inline Scene in_digits(const vibro_impact::Scene &given, double until) {
  Scene scene{.end_time = Real(until)};
  for (std::size_t k = 0; k < scene.lists.size(); ++k) {
    const std::vector<double> &values = given.*vibro_impact::list_fields[k].value;
    scene.lists[k] = Vector(values.begin(), values.end());
    scene.lists[k].resize(given.mass.size());
  }
  for (std::size_t k = 0; k < scene.scalars.size(); ++k)
    scene.scalars[k] = Real(given.*vibro_impact::scalar_fields[k].value);
  for (const vibro_impact::Stop &stop : given.stops)
    scene.stops.push_back({static_cast<std::size_t>(stop.mass - 1), stop.side, Real(stop.position),
                           Real(stop.restitution.value_or(given.restitution))});
  return scene;
}

}  // namespace vibro_impact_reference
