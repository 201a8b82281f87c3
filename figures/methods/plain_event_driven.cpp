#include "plain_event_driven.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "plain_closed_form.hpp"

namespace vibro_impact::plain {

Result run(const Scene &scene, double until, const Options &options) {
  check(scene);
  const auto n = static_cast<Eigen::Index>(scene.mass.size());
  const double r = scene.restitution;
  Result result;
  Vector x = Vector::Zero(n), v = x;
  for (Eigen::Index i = 0; i < n; ++i) {
    if (!scene.displacement.empty()) x(i) = scene.displacement[static_cast<std::size_t>(i)];
    if (!scene.velocity.empty()) v(i) = scene.velocity[static_cast<std::size_t>(i)];
  }
  std::vector<int> held(scene.mass.size(), 0);
  double now = 0.0;

  while (now < until && !result.capped) {
    const Motion motion = motion_from(scene, held, now, x, v);
    const auto evaluate = [&](double tau) {
      motion.evaluate(tau, x, v);
      ++result.evaluations;
    };
    // A free mass is at its stop or beyond and still closing in; a hold force presses no more.
    const auto happens = [&](const Stop &stop, double tau) {
      const auto p = static_cast<std::size_t>(stop.mass - 1);
      const auto i = static_cast<Eigen::Index>(p);
      const double sigma = sign(stop.side);
      if (held[p] != 0)
        return held[p] == static_cast<int>(stop.side) && press(scene, stop, now + tau, x, v) <= 0.0;
      return sigma * (stop.position - x(i)) <= 0.0 && sigma * v(i) > 0.0;
    };
    const Stop *first = nullptr;
    double tau = 0.0;
    evaluate(0.0);  // a neighbour's impact may release a held mass at once
    for (const Stop &stop : scene.stops)
      if (held[static_cast<std::size_t>(stop.mass - 1)] != 0 && happens(stop, 0.0)) first = &stop;
    for (long long k = 1; first == nullptr && tau < until - now; ++k) {
      const double before = tau,
                   after = std::min(static_cast<double>(k) * options.step, until - now);
      tau = after;
      evaluate(after);
      const Vector x_after = x, v_after = v;
      for (const Stop &stop : scene.stops) {
        x = x_after, v = v_after;
        if (!happens(stop, after)) continue;
        double left = before, right = after;
        while (right - left > std::numeric_limits<double>::epsilon() * (now + right)) {
          const double middle = left + (right - left) / 2;
          evaluate(middle);
          (happens(stop, middle) ? right : left) = middle;
        }
        if (first == nullptr || right < tau) first = &stop, tau = right;
      }
    }
    evaluate(tau);
    now = first == nullptr ? until : now + tau;
    if (first == nullptr) break;

    const auto p = static_cast<std::size_t>(first->mass - 1);
    const auto i = static_cast<Eigen::Index>(p);
    const double velocity = v(i);
    EventKind kind = EventKind::impact;
    if (held[p] != 0) {
      kind = EventKind::release;
      held[p] = 0;
    } else if (std::abs(velocity) < options.threshold && press(scene, *first, now, x, v) > 0.0) {
      kind = EventKind::stick;
      held[p] = static_cast<int>(first->side);
      x(i) = first->position;
      v(i) = 0.0;
    } else {
      v(i) = -r * velocity;
    }
    result.events.push_back({now, first->mass, kind, velocity});
    if (kind != EventKind::release) ++result.impacts;
    result.capped = result.impacts >= options.max_impacts;
  }
  result.time = now;
  result.displacement = x;
  result.velocity = v;
  return result;
}

}  // namespace vibro_impact::plain
