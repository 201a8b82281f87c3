// The bifurcation diagrams of Figure 3: impact velocities against the forcing frequency.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <vector>

#include "paper_scenes.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::figures {

// Frequencies from 0.25 to 0.7, both included, at equal distances.
inline std::vector<double> frequencies_of_figure3(int count) {
  const paper::AxisBox &box = paper::figure3a_box;
  std::vector<double> omegas;
  for (int i = 0; i < count; ++i)
    omegas.push_back(box.from + (box.to - box.from) * i / (count - 1));
  return omegas;
}

// The distinct ones among `values`, sorted: those that agree to 1e-6 of their size, as the impacts
// of a periodic motion do from period to period, count as one.
inline std::vector<double> distinct(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto same = [](double a, double b) { return std::abs(a - b) <= 1e-6 * std::abs(a); };
  values.erase(std::unique(values.begin(), values.end(), same), values.end());
  return values;
}

// Impact velocities of masses 1 and 2 at one frequency: from rest, after the settling periods, over
// `periods` further ones; chatter impacts down to slowest_impact_shown.
inline std::array<std::vector<double>, 2> impact_velocities(double omega, int periods) {
  const Scene scene = paper::figure3(omega);
  const double period = Clock(omega).period, from = paper::figure3_settling_periods * period;
  RunOptions options;
  options.resolve_chatter = paper::slowest_impact_shown;
  ImpactSpeedRecorder first{1, from}, second{2, from};
  require_complete(simulate(scene, from + periods * period, options, first, second));
  return {distinct(first.velocities), distinct(second.velocities)};
}

// The diagrams of mass 1 and mass 2, rows in the order of `omegas`. The frequencies are shared out
// among `threads` threads; each is computed on its own, so their number does not change a digit.
// advance() is called after every frequency, from any thread.
template <class Advance>
std::array<Table, 2> bifurcation_diagrams(const std::vector<double> &omegas, int periods,
                                          int threads, Advance &&advance) {
  std::vector<std::array<std::vector<double>, 2>> velocities(omegas.size());
  std::exception_ptr failure;  // exceptions must not leave the parallel loop
#pragma omp parallel for schedule(dynamic) num_threads(threads)
  for (std::size_t i = 0; i < omegas.size(); ++i) {
    try {
      velocities[i] = impact_velocities(omegas[i], periods);
      advance();
    } catch (...) {
#pragma omp critical
      failure = std::current_exception();
    }
  }
  if (failure) std::rethrow_exception(failure);

  std::array<Table, 2> diagrams{Table("omega,v1"), Table("omega,v2")};
  for (std::size_t mass = 0; mass < 2; ++mass)
    for (std::size_t i = 0; i < omegas.size(); ++i)
      for (double v : velocities[i][mass]) diagrams[mass].row(omegas[i], v);
  return diagrams;
}

}  // namespace vibro_impact::figures
