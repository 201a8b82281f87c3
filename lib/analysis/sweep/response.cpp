#include "vibro_impact/analysis/response.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/orbits/motion_state.hpp"
#include "vibro_impact/analysis/periodic_orbit.hpp"

namespace vibro_impact {

namespace {

constexpr double samples_of_a_period = 128.0, most_samples = 4096.0;  // of a forcing period

// A point of a curve x(t), and its slope.
struct Node {
  double time, x, v;
};

// The cubic between two nodes, x(u) = a.x + h a.v u + second u^2 + third u^3 with 0 <= u <= 1.
struct Cubic {
  Node a;
  double h, second, third;

  Cubic(const Node &from, const Node &to) : a(from), h(to.time - from.time) {
    const double rise = to.x - from.x;
    second = 3.0 * rise - h * (2.0 * from.v + to.v);
    third = h * (from.v + to.v) - 2.0 * rise;
  }
  double operator()(double u) const {
    return a.x + u * (h * a.v + u * (second + u * third));
  }
};

struct ResponseRecorder : Recorder {
  double interval, last_sample;
  std::vector<Response> responses;
  std::vector<Node> nodes;  // the latest of each mass

  ResponseRecorder(const Scene &scene, const MotionState &start) : responses(scene.mass.size()) {
    const double period = Clock(scene.omega).period,
                 local = 2.0 * std::numbers::pi / std::ranges::max(local_frequencies(scene));
    last_sample = time_of(start.instant, Clock(scene.omega));
    interval = std::max(std::min(period, local) / samples_of_a_period, period / most_samples);
    for (std::size_t i = 0; i < responses.size(); ++i) {
      nodes.push_back({last_sample, start.displacement[i], start.velocity[i]});
      responses[i] = {nodes[i].x, nodes[i].x, 0.0};
    }
  }
  double next_time() const override {
    return last_sample + interval;
  }
  void sample(const Moment &moment) override {
    last_sample = moment.time;
    for (int mass = 1; mass <= moment.masses(); ++mass)
      add(mass, {moment.time, moment.displacement(mass), moment.velocity(mass)});
  }
  void event(const Event &event, const Moment &moment) override {
    add(event.mass, {moment.time, moment.displacement(event.mass), event.velocity_before});
    nodes[static_cast<std::size_t>(event.mass) - 1].v = event.velocity_after;
  }

  // Adds the curve of a mass up to a node. `rms` is the integral of x^2 meanwhile, by Simpson's
  // rule.
  void add(int mass, const Node &node) {
    const auto i = static_cast<std::size_t>(mass) - 1;
    const Cubic x(nodes[i], node);
    Response &response = responses[i];
    const auto extend = [&](double value) {
      response.lowest = std::min(response.lowest, value);
      response.highest = std::max(response.highest, value);
    };
    extend(node.x);
    // The slope of the cubic is zero at u = h v / (-second +- root).
    const double root = std::sqrt(std::max(0.0, x.second * x.second - 3.0 * x.third * x.h * x.a.v));
    for (const double u : {x.h * x.a.v / (-x.second + root), x.h * x.a.v / (-x.second - root)})
      if (u > 0.0 && u < 1.0) extend(x(u));
    response.rms += x.h / 6.0 * (x.a.x * x.a.x + 4.0 * x(0.5) * x(0.5) + node.x * node.x);
    nodes[i] = node;
  }
};

}  // namespace

std::vector<Response> response_of(const Scene &scene, const MotionState &start, int periods,
                                  const RunOptions &options) {
  require_fits(scene, start);
  ResponseRecorder recorder(scene, start);
  const MotionState end = stroboscopic_map(scene, start, periods, options, recorder);
  const double time = time_after(scene, start, periods);
  for (std::size_t i = 0; i < end.displacement.size(); ++i) {
    recorder.add(static_cast<int>(i) + 1, {time, end.displacement[i], end.velocity[i]});
    recorder.responses[i].rms =
        std::sqrt(recorder.responses[i].rms / (time - time_of(start.instant, Clock(scene.omega))));
  }
  // A curve that ends at a stop may pass it by its rounding.
  for (const Stop &stop : scene.stops) {
    Response &response = recorder.responses[static_cast<std::size_t>(stop.mass) - 1];
    if (is_beyond(stop, response.lowest)) response.lowest = stop.position;
    if (is_beyond(stop, response.highest)) response.highest = stop.position;
  }
  return recorder.responses;
}

}  // namespace vibro_impact
