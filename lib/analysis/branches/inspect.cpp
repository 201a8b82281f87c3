#include <array>
#include <cmath>

#include "sequence.hpp"

namespace vibro_impact::branches {

namespace {

constexpr int nodes = 6;            // of a step
constexpr double slightly = 1e-13;  // below zero, relative to the unit of length

double value_of(const std::array<double, Flow::most_orders> &p, int degree, double time) {
  double sum = 0.0;
  for (int k = degree; k >= 0; --k) sum = sum * time + p[static_cast<size_t>(k)];
  return sum;
}

double slope_of(const std::array<double, Flow::most_orders> &p, int degree, double time) {
  double sum = 0.0;
  for (int k = degree; k >= 1; --k) sum = sum * time + k * p[static_cast<size_t>(k)];
  return sum;
}

// Adds the minima of a gap or a press p within a step to a list, and where there is none but the
// value is below zero, its lowest node. Times are in radians of the fastest rate. `at` has the
// beginning of the step. The first node is left out after a release.
void add_minima(const std::array<double, Flow::most_orders> &p, int degree, double step,
                double radian, bool after_release, double length, const Minimum &at,
                std::vector<Minimum> &minima) {
  const auto add = [&](double time) {
    minima.push_back(at);
    minima.back().offset += radian * time;
    minima.back().value = value_of(p, degree, time);
  };
  const int first = after_release ? 1 : 0;
  bool found = false;
  double left = slope_of(p, degree, step * first / nodes), lowest = -slightly * length,
         lowest_time = -1.0;
  for (int node = first + 1; node <= nodes; ++node) {
    const double time = step * node / nodes, right = slope_of(p, degree, time);
    if (left < 0.0 && right >= 0.0) {
      double falls = step * (node - 1) / nodes, rises = time;
      for (int k = 0; k < 50; ++k) {
        const double middle = (falls + rises) / 2.0;
        (slope_of(p, degree, middle) < 0.0 ? falls : rises) = middle;
      }
      add(falls);
      found = true;
    }
    left = right;
    const double value = value_of(p, degree, time);
    if (node < nodes && value < lowest) {
      lowest = value;
      lowest_time = time;
    }
  }
  if (!found && lowest_time > 0.0) add(lowest_time);
}

}  // namespace

Inspection inspect(const Problem &problem, const Sequence &s, const Vector &u) {
  const Model model(problem.scene, problem.parameter, u(0));
  const size_t count = s.items.size(), n = problem.masses();
  Flow flow(model, 3 + 2 * index(n));
  State state = start_of(problem, model, s, u, 1);
  Inspection result;
  result.items.resize(count);
  int released = releases(s.items[0].what) ? static_cast<int>(problem.mass_of(s.items[0])) : -1;
  const auto press = [&](int number, int order = 0) {
    const ModelStop &stop = model.stop(number);
    return stop.sigma * flow.force(order, stop.mass)(0);
  };
  for (size_t k = 0; k < count; ++k) {
    const auto watch = [&](double begin, double step, int order) {
      if (!(step > 0.0)) return;
      for (int number = 0; number < static_cast<int>(model.stops.size()); ++number) {
        const ModelStop &stop = model.stop(number);
        const bool is_held = state.held[stop.mass] >= 0;
        if (is_held && state.held[stop.mass] != number) continue;
        const int degree = is_held ? order - 2 : order;
        std::array<double, Flow::most_orders> p{};
        for (int j = 0; j <= degree; ++j)
          p[static_cast<size_t>(j)] =
              is_held ? press(number, j) : -stop.sigma * flow.displacement(j, stop.mass)(0);
        if (!is_held) p[0] += stop.sigma * stop.position.value;
        const bool after_release = begin == 0.0 && released == static_cast<int>(stop.mass);
        add_minima(p, degree, step / flow.radian(), flow.radian(), after_release, problem.length,
                   {.is_press = is_held, .stop = number, .flight = k, .offset = begin},
                   result.minima);
      }
    };
    flow.fly(state, u(problem.time_at(k)), watch);
    const size_t at = (k + 1) % count;
    const Item &item = s.items[at];
    AtItem &seen = result.items[at];
    released = -1;
    if (item.what != Happening::start) {
      const ModelStop &stop = model.stop(item.stop);
      const Eigen::Index i = index(stop.mass);
      const auto see_press = [&] {
        flow.expand(state, 1, 3);
        seen.press = press(item.stop);
        seen.slope = press(item.stop, 1) / flow.radian();
      };
      if (releases(item.what) || item.what == Happening::dip) see_press();
      seen.speed = stop.sigma * state.v(i, 0);
      if (hits(item.what)) {
        const double after = rebound(stop, seen.speed).speed;
        state.y(i, 0) = 0.0;
        state.v(i, 0) = item.what == Happening::hold ? 0.0 : -stop.sigma * after;
        state.touched[stop.mass] = item.stop;
        if (item.what == Happening::hold) state.held[stop.mass] = item.stop;
        if (item.what == Happening::hold || after == 0.0) see_press();
      }
      if (releases(item.what)) {
        state.held[stop.mass] = -1;
        released = static_cast<int>(stop.mass);
      }
      flow.expand(state, 1, 2);
      for (size_t j = 0; j < n; ++j)
        if (state.held[j] >= 0 && j != stop.mass)
          result.minima.push_back({.is_press = true,
                                   .after_event = true,
                                   .stop = state.held[j],
                                   .flight = at,
                                   .value = press(state.held[j])});
    }
    seen.after = state;
  }
  return result;
}

}  // namespace vibro_impact::branches
