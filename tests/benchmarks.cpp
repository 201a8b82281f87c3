// Micro-benchmarks of the steps of the pipeline, for chains of 2, 10, 50 and 200 masses with stops
// on the first and the last: `make benchmarks`. Times are per call; the counters beside them say
// what one call does.
#include <benchmark/benchmark.h>

#include "paper_scenes.hpp"
#include "vibro_impact/chatter_tail.hpp"
#include "vibro_impact/first_event.hpp"
#include "vibro_impact/impact.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;

// The paper's chain with n masses, stops on the first and the last; or with other than two stops,
// on the first masses.
Scene chain_of(int n, int stops = 2) {
  const auto masses = static_cast<std::size_t>(n);
  Scene scene = paper::figure2();
  scene.mass.assign(masses, 1.0);
  scene.stiffness.assign(masses, 1.0);
  scene.amplitude.assign(masses, 0.0);
  scene.amplitude[0] = 0.5;
  scene.stops[1].mass = n;
  if (stops == 2) return scene;
  scene.stops.resize(1);
  for (int mass = 2; mass <= stops; ++mass) scene.stops.push_back({mass, Side::upper, 0.1});
  return scene;
}

// A state in flight, with the contact mode it belongs to.
template <int D>
struct InFlight {
  Scene scene;
  Clock clock;
  ContactMode<D> mode;
  State<D> state;
  Counters counters;

  explicit InFlight(int n, int stops = 2)
      : scene(chain_of(n, stops)),
        clock(scene.omega),
        mode(build_contact_mode<D>(scene, Held(static_cast<std::size_t>(n), 0))) {
    MotionState motion = start_of(scene);
    motion.instant.phase = 1.0;
    motion.velocity(0) = -0.1;
    motion.displacement(0) = -0.2;
    set_lanes(state, scene, mode, motion);
    state.now = motion.instant;
    state.stops.assign(scene.stops.size(), {0.1, 0.0, 0, 0.0});
    state.stops[0].speed = -0.1;
  }
};

// What a span of flight without an event costs: the gaps of all stops, and moving on. The stops
// stand as in `chain_of`, each within reach.
template <int D>
void span(benchmark::State &run) {
  const int n = static_cast<int>(run.range(0)), stops = static_cast<int>(run.range(1));
  InFlight<D> at(n, stops);
  Flight<D> flight;
  const State<D> start = at.state;
  for (auto _ : run) {
    at.state = start;
    expand(at.mode, at.state.value, at.state.slope, 1.0, flight.expansion, at.counters);
    look_ahead(at.state, flight, at.counters);
    move_to(at.state, flight, 1.0, at.scene, at.clock, at.counters);
    benchmark::DoNotOptimize(at.state.value.data());
  }
  run.counters["order"] = flight.expansion.order;
  run.counters["products"] = benchmark::Counter(static_cast<double>(at.counters.products),
                                                benchmark::Counter::kAvgIterations);
}

template <int D>
void first_event(benchmark::State &run) {
  InFlight<D> at(static_cast<int>(run.range(0)));
  Flight<D> flight;
  expand(at.mode, at.state.value, at.state.slope, 1.0, flight.expansion, at.counters);
  for (auto _ : run) {
    find_first_event(at.state, at.scene, at.clock, flight, at.counters);
    benchmark::DoNotOptimize(flight.event.u);
  }
  run.counters["root steps"] = benchmark::Counter(static_cast<double>(at.counters.root_iterations),
                                                  benchmark::Counter::kAvgIterations);
}

template <int D>
void impact(benchmark::State &run) {
  InFlight<D> at(static_cast<int>(run.range(0)));
  State<D> state = at.state;
  for (auto _ : run) {
    apply_impact(state, at.scene, at.mode.open[0], -0.1);
    benchmark::DoNotOptimize(state.value.data());
  }
}

// Mass 1 of the paper's scene, pressed into its lower stop by the forcing and chattering there.
struct Chattering : InFlight<4> {
  Bounces<4> bounces;
  ChatterTable table;

  Chattering() : InFlight<4>(2) {
    state.now.phase = 3.0 / scene.omega;
    set_forcing(state, scene);
    apply_impact(state, scene, mode.open[0], -0.05);
    const double press = mode.open[0].press(state.value, state.slope);
    const double flight = 2.0 * state.stops[0].speed / press;
    follow(bounces, state, scene, {0}, flight, counters);
  }
  bool predict_and_bounce(std::vector<double> &closing) {
    extend(table, predict_limit(bounces));
    if (!find_next(bounces, state, counters)) return false;
    fly(bounces, state, scene, later(state.now, bounces.flight, clock));
    if (!bounce(bounces, state, scene, closing)) return false;
    look_on(bounces, state, counters);
    return true;
  }
};

// A chatter of eleven impacts, per impact: its flight, the impact and what it predicts.
void chatter_impact(benchmark::State &run) {
  const Chattering start;
  std::vector<double> closing;
  for (auto _ : run) {
    Chattering at = start;
    for (int i = 0; i < 11; ++i) benchmark::DoNotOptimize(at.predict_and_bounce(closing));
  }
  run.counters["per impact"] = benchmark::Counter(
      11, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

// The limit of this chatter: its time, the moments of the impacts to come, the state there.
void chatter_limit(benchmark::State &run) {
  Chattering at;
  std::vector<double> closing;
  for (int i = 0; i < 11 && at.predict_and_bounce(closing); ++i) continue;
  Tail<4> tail;
  State<4> there, before;
  for (auto _ : run) {
    there = at.state;
    const auto limit = extrapolate(at.table, at.mode.fastest, 1.0);
    find_tail(at.bounces, at.state, at.table, *limit, tail, at.counters);
    move_to_limit(at.bounces, tail, at.scene, at.state.now, there, before, at.counters);
    benchmark::DoNotOptimize(there.value.data());
  }
}

// Settled motion, per forcing period.
void forcing_period(benchmark::State &run) {
  const Scene scene = chain_of(static_cast<int>(run.range(0)));
  constexpr int periods = 20;
  const double period = Clock(scene.omega).period;
  const MotionState start = simulate(scene, 20 * period, {}).state;
  Counters counters;
  for (auto _ : run) counters = simulate_from(scene, start, (20 + periods) * period, {}).counters;
  run.counters["impacts"] = static_cast<double>(counters.impacts) / periods;
  run.counters["expansions"] = static_cast<double>(counters.expansions) / periods;
  run.counters["per period"] = benchmark::Counter(
      periods, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

BENCHMARK(span<4>)->Args({2, 1})->Args({2, 2});
BENCHMARK(span<Eigen::Dynamic>)->ArgsProduct({{10, 50, 200}, {1, 2, 4, 8}});
BENCHMARK(first_event<4>)->Arg(2);
BENCHMARK(first_event<Eigen::Dynamic>)->Arg(2)->Arg(10)->Arg(50)->Arg(200);
BENCHMARK(impact<4>)->Arg(2);
BENCHMARK(impact<Eigen::Dynamic>)->Arg(2)->Arg(10)->Arg(50)->Arg(200);
BENCHMARK(chatter_impact);
BENCHMARK(chatter_limit);
BENCHMARK(forcing_period)->Arg(2)->Arg(10)->Arg(50)->Arg(200);

}  // namespace

BENCHMARK_MAIN();
