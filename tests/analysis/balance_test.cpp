// The impulses and energies of all events balance momentum and energy over random windows, which
// begin and end anywhere, also inside chatters.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <tuple>
#include <vector>

#include "tests/support/windows.hpp"
#include "vibro_impact/analysis/totals.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

// Records the states at both ends of a window, and how many of them have unreported impacts.
struct Ends : Recorder {
  double from, to;
  std::vector<MotionState> states = {};
  int inside = 0;

  Ends(double from_time, double to_time) : from(from_time), to(to_time) {
  }
  double next_time() const override {
    if (states.empty()) return from;
    return states.size() == 1 ? to : infinity;
  }
  void sample(const Moment &moment) override {
    states.push_back(state_at(moment, Held(static_cast<std::size_t>(moment.masses()), 0)));
    inside += moment.unreported(1).impulse > 0.0;
  }
};

// A ball that falls on a floor, which a force may shake.
Scene ball(Draw &draw) {
  return {.mass = {draw.spread(0.1, 10.0)},
          .stiffness = {0.0},
          .amplitude = {draw.one_in(2) ? 0.0 : draw.uniform(0.0, 0.5)},
          .constant = {-draw.uniform(0.6, 2.0)},
          .omega = draw.uniform(0.2, 2.0),
          .stops = {{1, Side::lower, draw.uniform(-1.0, 0.0)}},
          .displacement = {draw.uniform(0.0, 2.0)}};
}

// A mass that a constant force presses onto its stop against a spring.
Scene preloaded(Draw &draw) {
  return {.mass = {draw.spread(0.1, 10.0)},
          .stiffness = {draw.spread(0.1, 10.0)},
          .constant = {draw.uniform(0.5, 2.0)},
          .omega = 0.0,
          .stops = {{1, Side::upper, draw.uniform(-1.0, 0.0)}},
          .displacement = {draw.uniform(-3.0, -1.0)}};
}

// Two to four masses that are not tied to the ground, pushed by constant forces towards the stops
// that some of them have. The first and the last have one.
Scene free_chain(Draw &draw) {
  Scene scene{.omega = draw.uniform(0.2, 2.0)};
  const int masses = draw.between(2, 4);
  for (int i = 1; i <= masses; ++i) {
    scene.mass.push_back(draw.spread(0.3, 3.0));
    scene.stiffness.push_back(i == 1 ? 0.0 : draw.spread(0.3, 3.0));
    scene.constant.push_back(draw.uniform(0.2, 1.0));
    scene.displacement.push_back(draw.uniform(-1.0, 0.0));
    if (i == 1 || i == masses || draw.one_in(2))
      scene.stops.push_back({i, Side::upper, draw.uniform(0.0, 0.3)});
  }
  return scene;
}

double any_restitution(Draw &draw) {
  return draw.one_of({0.0, 1e-6, 0.05, 0.3, 0.5, 0.7, 0.8, 0.9, 0.97, 1.0});
}

struct Window {
  TotalsRecorder totals;
  Ends ends;
};

// A random window of a run of this scene. Empty if the run does not come to its end: masses that
// are pressed onto a stop with r = 1 bounce for ever, faster and faster.
std::optional<Window> window_of(const Scene &scene, Draw &draw) {
  const double until = 30.0;
  EventRecorder events;
  const RunOptions options{.max_steps = 20'000};
  if (simulate(scene, until, options, events).ending != Ending::reached) return {};
  const double a = edge(events.events, until, draw), b = edge(events.events, until, draw);
  const double from = std::min(a, b), to = std::max(a, b);
  if (!(from < to)) return {};
  Window window{TotalsRecorder(scene, from, to), Ends(from, to)};
  require_complete(simulate(scene, until, options, window.totals, window.ends));
  return window;
}

// The integral of all external forces over a window.
double forcing_impulse(const Scene &scene, double from, double to) {
  double sum = 0.0;
  for (std::size_t i = 0; i < scene.mass.size(); ++i) {
    sum += scene.constant[i] * (to - from);
    if (!scene.amplitude.empty())
      sum += scene.amplitude[i] * (std::sin(scene.omega * to) - std::sin(scene.omega * from)) /
             scene.omega;
  }
  return sum;
}

double momentum(const Scene &scene, const MotionState &state) {
  double sum = 0.0;
  for (std::size_t i = 0; i < scene.mass.size(); ++i) sum += scene.mass[i] * state.velocity[i];
  return sum;
}

// Kinetic energy, and that of springs and constant forces.
double energy(const Scene &scene, const MotionState &state) {
  double sum = 0.0;
  for (std::size_t i = 0; i < scene.mass.size(); ++i) {
    const double stretch = state.displacement[i] - (i > 0 ? state.displacement[i - 1] : 0.0);
    sum += 0.5 * scene.mass[i] * state.velocity[i] * state.velocity[i] +
           0.5 * scene.stiffness[i] * stretch * stretch - scene.constant[i] * state.displacement[i];
  }
  return sum;
}

// The balances of 100 scenes, each with its window. A limit has an error of 1e-13 of its chatter,
// and the largest error over 20,000 scenes of each kind was 1.7e-13.
constexpr double balance_error = 1e-12;

// The difference that a balance leaves, and the size of its terms.
struct Balance {
  double left, scale = 1.0;
};

Balance momentum_of(const Scene &scene, const Window &window) {
  const auto &[states, from, to] = std::tie(window.ends.states, window.ends.from, window.ends.to);
  Balance balance{forcing_impulse(scene, from, to) + momentum(scene, states.at(0)) -
                  momentum(scene, states.at(1))};
  for (std::size_t k = 0; k < scene.stops.size(); ++k) {
    const StopTotals &stop = window.totals.stops[k];
    balance.left -= sign(scene.stops[k].side) * (stop.taken.impulse + stop.pressing);
    balance.scale += stop.taken.impulse + std::abs(stop.pressing);
  }
  return balance;
}

Balance energy_of(const Scene &scene, const Window &window) {
  const auto &states = window.ends.states;
  Balance balance{energy(scene, states.at(0)) - energy(scene, states.at(1))};
  for (const StopTotals &stop : window.totals.stops) {
    balance.left -= stop.taken.energy;
    balance.scale += stop.taken.energy;
  }
  return balance;
}

template <class Draws>
void expect_balance(Balance (*balance_of)(const Scene &, const Window &), const Draws &scene_of) {
  int tried = 0, inside = 0;
  for (unsigned seed = 1; seed <= 100; ++seed) {
    Draw draw{std::mt19937(seed)};
    Scene scene = scene_of(draw);
    scene.restitution = any_restitution(draw);
    const std::optional<Window> window = window_of(scene, draw);
    if (!window) continue;
    ++tried;
    inside += window->ends.inside;
    const Balance balance = balance_of(scene, *window);
    EXPECT_NEAR(balance.left, 0.0, balance_error * balance.scale)
        << "seed " << seed << ", r = " << scene.restitution;
  }
  EXPECT_GE(tried, 80);
  EXPECT_GE(inside, 10);
}

TEST(Totals, BalanceTheMomentumOfBalls) {
  expect_balance(momentum_of, ball);
}

// Dampers between the masses keep the momentum of the chain.
TEST(Totals, BalanceTheMomentumOfFreeChains) {
  expect_balance(momentum_of, [](Draw &draw) {
    Scene scene = free_chain(draw);
    for (std::size_t i = 0; i < scene.mass.size(); ++i)
      scene.amplitude.push_back(draw.uniform(0.0, 0.1));
    scene.beta = draw.one_in(2) ? 0.0 : draw.spread(1e-3, 1.0);
    return scene;
  });
}

TEST(Totals, BalanceTheEnergyOfBalls) {
  expect_balance(energy_of, [](Draw &draw) {
    Scene scene = ball(draw);
    scene.amplitude.clear();
    return scene;
  });
}

TEST(Totals, BalanceTheEnergyOfPreloadedMasses) {
  expect_balance(energy_of, preloaded);
}

TEST(Totals, BalanceTheEnergyOfChains) {
  expect_balance(energy_of, [](Draw &draw) {
    Scene scene = free_chain(draw);
    if (draw.one_in(2)) scene.stiffness[0] = draw.spread(0.3, 3.0);
    return scene;
  });
}

}  // namespace
