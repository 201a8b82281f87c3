// Two modal coordinates in one vector register. Sums over the coordinates have few terms, for which
// the general expressions of Eigen are slow.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>

#include "contact_mode.hpp"

namespace vibro_impact::detail {

using Pair [[gnu::vector_size(16)]] = double;

inline Pair pair(const double *first) {
  Pair two;
  std::memcpy(&two, first, sizeof two);
  return two;
}

inline void store(Pair two, double *first) {
  std::memcpy(first, &two, sizeof two);
}

inline Pair abs(Pair two) {
  return Pair{std::abs(two[0]), std::abs(two[1])};
}

inline Pair smaller(Pair a, Pair b) {
  return Pair{std::min(a[0], b[0]), std::min(a[1], b[1])};
}

inline double sum(Pair two) {
  return two[0] + two[1];
}

// sum_j a_j b_j over an even number of coordinates.
inline double dot(const double *a, const PerCoordinate &b) {
  Pair total{};
  for (Eigen::Index j = 0; j < b.size(); j += 2) total += pair(a + j) * pair(b.data() + j);
  return sum(total);
}

inline double dot(const PerCoordinate &a, const PerCoordinate &b) {
  return dot(a.data(), b);
}

// sum_j (a_j + b_j).
inline double total(const PerCoordinate &a, const PerCoordinate &b) {
  Pair total{};
  for (Eigen::Index j = 0; j < b.size(); j += 2) total += pair(a.data() + j) + pair(b.data() + j);
  return sum(total);
}

// sum_j a_j |b_j|.
inline double dot_moduli(const PerCoordinate &a, const PerCoordinate &b) {
  Pair total{};
  for (Eigen::Index j = 0; j < a.size(); j += 2)
    total += pair(a.data() + j) * abs(pair(b.data() + j));
  return sum(total);
}

}  // namespace vibro_impact::detail
