#include "vibro_impact/analysis/response.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/orbits/motion_state.hpp"
#include "vibro_impact/analysis/periodic_orbit.hpp"

namespace vibro_impact {

namespace {

constexpr double samples_of_a_period = 128.0, most_samples = 4096.0;  // of a forcing period

// The cubic x(u) = x + h v u + second u^2 + third u^3, 0 <= u <= 1, between two nodes at a distance
// of h in time.
struct Cubic {
  double x, v, h, second, third;

  Cubic(const auto &from, const auto &to) : x(from.x), v(from.v), h(to.time - from.time) {
    const double rise = to.x - from.x;
    second = 3.0 * rise - h * (2.0 * from.v + to.v);
    third = h * (from.v + to.v) - 2.0 * rise;
  }
  double operator()(double u) const {
    return x + u * (h * v + u * (second + u * third));
  }
};

}  // namespace

ResponseRecorder::ResponseRecorder(const Scene &scene, double from_time, double to_time)
    : from(from_time), to(to_time), scene_(scene), latest_sample_(from_time) {
  interval_ =
      2.0 * std::numbers::pi / std::ranges::max(local_frequencies(scene)) / samples_of_a_period;
  if (scene.omega == 0.0) return;
  const double period = Clock(scene.omega).period;
  interval_ = std::max(std::min(period / samples_of_a_period, interval_), period / most_samples);
}

double ResponseRecorder::next_time() const {
  if (latest_.empty()) return from;
  return latest_sample_ < to ? std::min(latest_sample_ + interval_, to) : infinity;
}

void ResponseRecorder::sample(const Moment &moment) {
  latest_sample_ = moment.time;
  for (int mass = 1; mass <= moment.masses(); ++mass) {
    const Node node{moment.time, moment.displacement(mass), moment.velocity(mass)};
    if (latest_.size() == scene_.mass.size()) {
      add(mass, node);
    } else {
      latest_.push_back(node);
      sums_.push_back({node.x, node.x, 0.0});
    }
  }
}

void ResponseRecorder::event(const Event &event, const Moment &moment) {
  if (latest_.empty() || latest_sample_ >= to) return;
  add(event.mass, {moment.time, moment.displacement(event.mass), event.velocity_before});
  latest_[index_of(event.mass)].v = event.velocity_after;
}

// Adds the curve of a mass up to a node. The integral of x^2 is that of Simpson's rule.
void ResponseRecorder::add(int mass, const Node &node) {
  const Cubic x(latest_[index_of(mass)], node);
  Response &sum = sums_[index_of(mass)];
  const auto extend = [&sum](double value) {
    sum.lowest = std::min(sum.lowest, value);
    sum.highest = std::max(sum.highest, value);
  };
  extend(node.x);
  // The slope of the cubic is zero at u = h v / (-second +- root).
  const double root = std::sqrt(std::max(0.0, x.second * x.second - 3.0 * x.third * x.h * x.v));
  for (const double u : {x.h * x.v / (-x.second + root), x.h * x.v / (-x.second - root)})
    if (u > 0.0 && u < 1.0) extend(x(u));
  sum.rms += x.h / 6.0 * (x.x * x.x + 4.0 * x(0.5) * x(0.5) + node.x * node.x);
  latest_[index_of(mass)] = node;
}

std::vector<Response> ResponseRecorder::responses() const {
  std::vector<Response> found = sums_;
  for (std::size_t i = 0; i < found.size(); ++i) {
    Response &response = found[i];
    response.rms = latest_sample_ > from ? std::sqrt(response.rms / (latest_sample_ - from))
                                         : std::abs(response.lowest);
    // A curve that ends at a stop may pass it by its rounding.
    for (const Stop &stop : scene_.stops) {
      if (index_of(stop.mass) != i) continue;
      if (is_beyond(stop, response.lowest)) response.lowest = stop.position;
      if (is_beyond(stop, response.highest)) response.highest = stop.position;
    }
  }
  return found;
}

std::vector<Response> response_of(const Scene &scene, const MotionState &start, int periods,
                                  const RunOptions &options) {
  require_fits(scene, start);
  ResponseRecorder recorder(scene, time_of(start.instant, Clock(scene.omega)),
                            time_after(scene, start, periods));
  stroboscopic_map(scene, start, periods, options, recorder);
  return recorder.responses();
}

}  // namespace vibro_impact
