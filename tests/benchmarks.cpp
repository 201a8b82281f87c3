// Benchmarks of whole runs, for chains of 2, 10, 50 and 200 masses with stops on the first and the
// last, and of a diagram: `make benchmarks`. Times are per forcing period, chatter, sample or map;
// the counters beside them say what that took.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

#include "reference/scenes/extreme_scenes.hpp"
#include "tests/events.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;

// The paper's chain of Figure 2 with n masses.
Scene chain_of(int n) {
  const auto masses = static_cast<std::size_t>(n);
  Scene scene = paper::figure2();
  scene.mass.assign(masses, 1.0);
  scene.stiffness.assign(masses, 1.0);
  scene.amplitude.assign(masses, 0.0);
  scene.amplitude[0] = 0.5;
  scene.stops[1].mass = n;
  return scene;
}

// Shows the time of a run divided by `parts`, and what a part of it took.
void show(benchmark::State &state, const Counters &counters, int parts) {
  state.counters["time"] = benchmark::Counter(
      parts, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["impacts"] = static_cast<double>(counters.impacts) / parts;
  state.counters["expansions"] = static_cast<double>(counters.expansions) / parts;
  state.counters["products"] = static_cast<double>(counters.products) / parts;
  state.counters["root steps"] = static_cast<double>(counters.root_iterations) / parts;
}

constexpr int settling = 20, periods = 20;

// Settled motion, per forcing period: the chatter of each carried to its limit, or every impact
// resolved down to rounding, which shows what an impact takes.
void forcing_period(benchmark::State &state, const RunOptions &options) {
  const Scene scene = chain_of(static_cast<int>(state.range(0)));
  const MotionState start = settled(scene, settling);
  const double until = time_after(scene, start, periods);
  Counters counters;
  for (auto _ : state) counters = simulate_from(scene, start, until, options).counters;
  show(state, counters, periods);
}

// One mass pressed onto its stop, from a start in flight to rest. The argument is the coefficient
// of restitution, in hundredths.
void chatter(benchmark::State &state) {
  const double r = static_cast<double>(state.range(0)) / 100.0;
  const Scene scene = extremes::one_mass(0.1, 0.0, 1.0, r, -0.5, -0.51);
  Counters counters;
  for (auto _ : state) counters = simulate(scene, 30.0).counters;
  show(state, counters, 1);
}

// Samples of all masses, a thousand to a forcing period: per sample, the flight included.
void sample(benchmark::State &state) {
  const Scene scene = chain_of(static_cast<int>(state.range(0)));
  const MotionState start = settled(scene, settling);
  const double from = time_of(start.instant, Clock(scene.omega)),
               until = time_after(scene, start, 1);
  constexpr int samples = 1000;
  Counters counters;
  for (auto _ : state) {
    SampleRecorder recorder{.from = from, .to = until, .every = (until - from) / samples};
    counters = simulate_from(scene, start, until, {}, recorder).counters;
    benchmark::DoNotOptimize(recorder.displacements.data());
  }
  show(state, counters, samples);
}

// The derivative of the stroboscopic map, of which Newton's method takes one per iteration.
void stroboscopic_derivative(benchmark::State &state) {
  const Scene scene = chain_of(static_cast<int>(state.range(0)));
  const MotionState start = at_quiet_phase(scene, settled(scene, settling));
  Counters counters;
  for (auto _ : state) {
    const StroboscopicImage image = stroboscopic_map_and_derivative(scene, start, 1);
    benchmark::DoNotOptimize(image.derivative.values.data());
    counters = image.counters;
  }
  show(state, counters, 1);
}

// A motion clear of its stops, to a million forcing periods: one step.
void undisturbed(benchmark::State &state) {
  Scene scene = chain_of(static_cast<int>(state.range(0)));
  for (Stop &stop : scene.stops) stop.position *= 1e3;
  const double until = 1e6 * Clock(scene.omega).period;
  Counters counters;
  for (auto _ : state) counters = simulate(scene, until).counters;
  show(state, counters, 1);
}

// What 100,000 forcing periods, impact by impact, do to the phase, in periods: that of the events
// of the settled motion of Figure 2, in the last period against the hundredth.
void long_run(benchmark::State &state) {
  const Scene scene = paper::figure2();
  const Clock clock(scene.omega);
  double apart = 0.0;
  for (auto _ : state) {
    const auto events_of_period = [&](long long cycle) {
      EventRecorder recorder{.from = time_of({cycle, 0.0}, clock)};
      simulate(scene, time_of({cycle + 1, 0.0}, clock), {}, recorder);
      return recorder.events;
    };
    const std::vector<Event> early = events_of_period(100), late = events_of_period(100'000);
    if (early.size() != late.size()) return state.SkipWithError("the motion has not settled");
    for (std::size_t i = 0; i < early.size(); ++i)
      apart = std::max(apart, std::abs(late[i].instant.phase - early[i].instant.phase));
  }
  state.counters["phase error"] = apart / clock.period;
}

// The same of the centre of mass of a forced free chain: x = f (1 - cos(Omega t)) / Omega^2, read
// once a period a quarter of it after its beginning, where x' = f / Omega.
void long_run_of_a_free_chain(benchmark::State &state) {
  Scene scene = paper::figure2();
  scene.stiffness[0] = 0.0;
  scene.stops = {{1, Side::upper, 1e3}};  // never reached, always looked at
  const double pull = 0.25, period = Clock(scene.omega).period;
  double apart = 0.0;
  for (auto _ : state) {
    SampleRecorder recorder{.from = 0.25 * period, .to = 1e5 * period, .every = period};
    simulate(scene, 1e5 * period, {}, recorder);
    for (std::size_t i = 0; i < recorder.times.size(); ++i) {
      const double x = (recorder.displacements[2 * i] + recorder.displacements[2 * i + 1]) / 2.0;
      const Instant at = instant_at(recorder.times[i], Clock(scene.omega));
      const double exact =
          pull * (1.0 - std::cos(scene.omega * at.phase)) / scene.omega / scene.omega;
      apart = std::max(apart, std::abs(x - exact) / (pull / scene.omega));
    }
  }
  state.counters["phase error"] = apart / period;
}

// A diagram like Figure 3, per frequency, on as many threads as the argument says: `periods` are
// the forcing periods integrated until a motion has settled, of 400.
void diagram(benchmark::State &state) {
  const Grid grid{paper::figure2(), {{parameter_named("omega"), 0.25, 0.7, 181}}};
  const SweepOptions sweeping{.threads = static_cast<int>(state.range(0)), .progress = {}};
  double all = 0.0;
  for (auto _ : state) {
    all = 0.0;
    for (const double taken : sweep(
             grid,
             [](const Scene &scene) { return static_cast<double>(record_of(scene).work.settling); },
             sweeping))
      all += taken;
  }
  state.counters["time"] = benchmark::Counter(
      181, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["periods"] = all / 181;
}

BENCHMARK_CAPTURE(forcing_period, limits, RunOptions{})->Arg(2)->Arg(10)->Arg(50)->Arg(200);
BENCHMARK_CAPTURE(forcing_period, all_impacts, testing::all_impacts)
    ->Arg(2)
    ->Arg(10)
    ->Arg(50)
    ->Arg(200);
BENCHMARK(chatter)->Arg(30)->Arg(70)->Arg(90)->Arg(99);
BENCHMARK(sample)->Arg(2)->Arg(10)->Arg(50)->Arg(200);
BENCHMARK(stroboscopic_derivative)->Arg(2)->Arg(10)->Arg(50)->Arg(200);
BENCHMARK(diagram)->Arg(1)->Arg(2)->UseRealTime();
BENCHMARK(undisturbed)->Arg(2)->Arg(10)->Arg(50)->Arg(200);
BENCHMARK(long_run)->Iterations(1);
BENCHMARK(long_run_of_a_free_chain)->Iterations(1);

}  // namespace

BENCHMARK_MAIN();
