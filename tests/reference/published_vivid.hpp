// The published curves of period doublings and folds of one oscillator,
// reference/published_vivid.csv (reference/README.md): Ghosh and Simpson (arXiv 2510.16218), x'' +
// 0.04 x' + x = F cos(omega t), x <= 1, r = 0.9; orbits of two forcing periods with one impact.
#pragma once

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include "figures/table_reader.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact {

inline Scene vivid_oscillator(double omega, double amplitude) {
  Scene scene;
  scene.mass = {1.0};
  scene.stiffness = {1.0};
  scene.beta = 0.04;
  scene.amplitude = {amplitude};
  scene.omega = omega;
  scene.restitution = 0.9;
  scene.stops = {{1, Side::upper, 1.0}};
  return scene;
}

// A row: on the curves of period doubling (multiplier -1) and of folds (+1).
struct VividRow {
  std::string name;
  double omega, amplitude, multiplier, speed, time;
};

inline const std::vector<VividRow> &published_vivid() {
  static const std::vector<VividRow> rows = [] {
    const std::string path = REFERENCE_DIR "/published_vivid.csv";
    std::ifstream file = figures::opened(path);
    std::vector<VividRow> read;
    for (const auto &cells : figures::read_rows(file, path, 7))
      read.push_back({cells[0] + " " + cells[1], std::stod(cells[2]), std::stod(cells[3]),
                      std::stod(cells[4]), std::stod(cells[5]), std::stod(cells[6])});
    return read;
  }();
  return rows;
}

inline const VividRow &vivid_row(const std::string &name) {
  return *std::find_if(published_vivid().begin(), published_vivid().end(),
                       [&](const VividRow &row) { return row.name == name; });
}

// Followed in F.
inline ImpactFamily vivid_family(double omega, double amplitude) {
  return {vivid_oscillator(omega, amplitude), {Parameter::Kind::amplitude, 1}, 0, 2};
}

inline ImpactOrbit vivid_orbit(const VividRow &row) {
  ImpactOrbit guess;
  const double period = 2.0 * std::numbers::pi / row.omega;
  guess.speed = row.speed;
  guess.parameter = row.amplitude;
  guess.state = {
      {0, row.time - period * std::floor(row.time / period)}, {1.0}, {-0.9 * row.speed}, {0}};
  return impact_orbit(vivid_family(row.omega, row.amplitude), guess, row.speed).value();
}

}  // namespace vibro_impact
