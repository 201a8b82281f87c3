// A scene as the equations of a run take it: every list has an entry for every mass, padded to an
// even number, and stops are counted from 0.
#pragma once

#include <cstddef>

#include "list.hpp"
#include "twofold.hpp"
#include "vibro_impact/scene.hpp"

namespace vibro_impact::detail {

// Masses are taken two at a time. Adds the first mass of the pair of a mass to a list that ends
// with this pair or an earlier one.
inline void add_pair(std::size_t mass, List<std::size_t> &pairs) {
  const std::size_t first = mass / 2 * 2;
  if (pairs.empty() || pairs.back() != first) pairs.push_back(first);
}

// A contact stays positive until something happens at a stop. It is the gap g = sigma (s - x) of a
// free mass, or sigma F of a held one, the force that presses it into the stop (Eqs. 12-13).
struct Contact {
  std::size_t stop = 0, mass = 0;
  double sigma = 1.0;  // the sign of the side of the stop
  double position = 0.0;
  ImpactLaw law = {1.0};
  bool held = false;
};

// M x'' + C x' + K x = A cos(Omega t) + B sin(Omega t) + P with C = beta K (Eq. 4).
struct Chain {
  std::size_t masses = 0, padded = 0;
  List<double> mass, a, b, p, ground;
  List<double> link;             // entry i ties mass i to mass i - 1, entry 0 to the ground
  List<Contact> stops;           // with all masses free
  List<double> lowest, highest;  // the stops of each mass, or -infinity and infinity
  bool grounded = false;         // some mass has a spring to the ground
  // The first masses of pairs with a mass that has a stop, and of pairs with one that is forced.
  List<std::size_t> stopped_pairs, forced_pairs;
  double beta = 0.0;
  double omega = 0.0;        // of the forcing, 0 where nothing is forced
  Clock clock;               // counts time in periods 2 pi / Omega, forced or not
  double rate_bound = 1.0;   // of all contact modes and Omega, 1 if all these are 0
  double rate_unit = 1.0;    // the power of two above it: exact as a unit
  double force_bound = 0.0;  // the largest |A_i| + |B_i| + |P_i| per mass m_i

  explicit Chain(const Scene &scene);

  // The stiffness of the link from mass i to mass i + 1; none beyond the last mass.
  double above(std::size_t i) const {
    return i + 1 < masses ? link[i + 1] : 0.0;
  }
  // Calls `use` with the stiffness of each link from mass i to a neighbour, and the neighbour.
  template <class Use>
  void each_link(std::size_t i, const Use &use) const {
    if (i > 0) use(link[i], i - 1);
    if (i + 1 < masses) use(link[i + 1], i + 1);
  }
  // The sum of the stiffnesses of the springs of mass i.
  double stiffness_at(std::size_t i) const {
    return link[i] + above(i) + ground[i];
  }
};

}  // namespace vibro_impact::detail
