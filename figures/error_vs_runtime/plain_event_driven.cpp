// The plain event-driven scheme: closed-form solution of each contact mode, sampled for gaps that
// have closed and hold forces that have turned, bisection between two samples, sticking below a
// speed threshold. What is swept is the threshold; the sampling is fine enough not to matter.
//
// The closed form is the library's (flow.hpp), so that only the scheme differs. Gaps are read off
// it as s - x, where nothing smaller than the rounding of x can be seen: with a threshold near 1e-8
// or below a chatter is lost in it.
#include <algorithm>
#include <cmath>

#include "two_masses.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::comparison {

namespace {

// A hundredth of a cycle of the fastest mode (w = 1.618); the samples behind an impact begin with
// an eighth of the flight ahead and grow by two.
constexpr double longest_sample = 0.04;
constexpr double samples_per_flight = 8.0;

// Displacement, velocity and the guards of both masses at one time, read off the closed form.
struct Sample {
  std::array<double, 2> x, v;
  std::array<bool, 2> due;  // the gap has closed or the hold force turned
};

using Lanes = Eigen::Array<double, 4, 1>;

// The free motion from one event to the next.
struct Stretch {
  const Scene &scene;
  const TwoMasses &chain;
  State<4> from;
  long long *evaluations;

  Sample at(double tau) const {
    ++*evaluations;
    const ContactMode<4> &mode = *from.mode;
    Lanes value, slope;
    flow(mode, scene, from.value, from.slope, tau, value, slope);
    Sample sample{};
    for (std::size_t i = 0; i < 2; ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      sample.x[i] = mode.equilibrium(row) + mode.shape.row(row).dot(value.matrix());
      sample.v[i] = mode.shape.row(row).dot(slope.matrix());
      sample.due[i] = mode.held[i] == 0 && chain.side[i] * (chain.stop[i] - sample.x[i]) <= 0.0 &&
                      chain.side[i] * sample.v[i] > 0.0;
    }
    for (const ClosedStop<4> &closed : mode.closed)
      sample.due[closed.mass] = closed.press(value, slope) <= 0.0;
    return sample;
  }
};

State<4> lanes_of(const Scene &scene, const TwoMasses &chain, const GapState &now, Modes<4> &modes,
                  Counters &counters) {
  const TwoMassState physical = physical_state(chain, now);
  MotionState motion{instant_at(now.time, Clock(scene.omega)), Eigen::VectorXd(2),
                     Eigen::VectorXd(2), Held(2, 0)};
  for (std::size_t i = 0; i < 2; ++i) {
    motion.displacement(static_cast<Eigen::Index>(i)) = physical.displacement[i];
    motion.velocity(static_cast<Eigen::Index>(i)) = physical.velocity[i];
    if (now.held[i]) motion.held[i] = static_cast<signed char>(scene.stops[i].side);
  }
  State<4> state;
  state.now = motion.instant;
  set_lanes(state, scene, modes.enter(scene, motion.held, counters), motion);
  return state;
}

Result plain(const Problem &problem, double threshold) {
  const TwoMasses chain = two_masses(problem.scene);
  GapState now = gap_state(chain, problem.start);
  Modes<4> modes;
  Counters counters;
  Result result;
  while (result.failure.empty()) {
    const Stretch stretch{problem.scene, chain,
                          lanes_of(problem.scene, chain, now, modes, counters), &result.work};
    const double horizon = problem.until - now.time;
    double before = 0.0, after = 0.0;
    double step = std::min(longest_sample, flight_ahead(chain, now) / samples_per_flight);
    Sample sample{};
    std::size_t who = 2;
    while (who == 2 && after < horizon) {
      before = after;
      after = std::min(after + step, horizon);
      step = std::min(2.0 * step, longest_sample);
      sample = stretch.at(after);
      for (std::size_t i = 2; i-- > 0;)
        if (sample.due[i]) who = i;
    }
    if (who != 2) {  // bisect for the first instant at which anything is due
      while (true) {
        const double middle = 0.5 * (before + after);
        if (middle <= before || middle >= after || now.time + middle == now.time) break;
        const Sample at_middle = stretch.at(middle);
        const bool due = at_middle.due[0] || at_middle.due[1];
        (due ? after : before) = middle;
        if (due) sample = at_middle;
      }
      who = sample.due[0] ? 0 : 1;
    }
    now.time = who == 2 ? problem.until : now.time + after;
    for (std::size_t i = 0; i < 2; ++i) {
      if (now.held[i]) continue;
      now.y[2 * i] = chain.side[i] * (chain.stop[i] - sample.x[i]);
      now.y[2 * i + 1] = -chain.side[i] * sample.v[i];
    }
    if (who == 2) break;
    happen(chain, now, who, threshold, result);
  }
  result.end = physical_state(chain, now);
  return result;
}

}  // namespace

std::vector<Method> plain_event_driven() {
  return {{"plain event-driven",
           "speed threshold",
           "closed-form evaluations",
           {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9},
           plain}};
}

}  // namespace vibro_impact::comparison
