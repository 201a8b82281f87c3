// What the figure `comparison` shows, as assertions: where a stiff spring in place of the stops and
// the plain event-driven scheme are right, and where they fail.
#include "figures/methods/comparison.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "figures/event_tables.hpp"

namespace {

using namespace vibro_impact;
using stiff_spring::Stepper;

const Scene scene = paper::figure2();
const double period = Clock(scene.omega).period;

std::vector<figures::TrueEvent> fifty_digit_table() {
  return figures::read_event_table(REFERENCE_DIR "/figure2_events.csv");
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// --- The plain event-driven scheme ---------------------------------------------------------------

TEST(PlainScheme, AgreesWithTheLibraryAndTheTableBeforeTheFirstChatterIsSlow) {
  // Bisection to the rounding of t, 2e-15; a time error grows by 1 / r and more per impact. Ten
  // impacts down to a speed of 0.025 leave 1e-12; 1e-9 is what a user of the scheme may expect.
  constexpr std::size_t impacts = 10;
  EventRecorder library;
  require_complete(simulate(scene, period, {}, library));
  const auto table = fifty_digit_table();
  const auto plain = plain::run(scene, 12.3, {}).events;
  ASSERT_EQ(plain.size(), impacts);
  for (std::size_t i = 0; i < impacts; ++i) {
    EXPECT_EQ(plain[i].mass, library.events[i].mass) << i;
    EXPECT_NEAR(plain[i].time, library.events[i].time, 1e-9) << i;
    EXPECT_NEAR(plain[i].velocity_before, library.events[i].velocity_before, 1e-9) << i;
    EXPECT_NEAR(plain[i].time, table[i].time, 1e-9) << i;
    EXPECT_NEAR(plain[i].velocity_before, table[i].velocity_before, 1e-9) << i;
  }
}

TEST(PlainScheme, StallsWhereTheLibraryFallsGeometricallyToRounding) {
  const auto library = figures::resolved_chatter(scene);
  ASSERT_GT(library.size(), 60u);
  EXPECT_LT(std::abs(library.back().velocity_before), 1e-13);
  // The impact map is smooth: v_{n+1} = r v_n (1 - c v_n + ...), c = 16.161 here. Taken as a bound
  // down to rounding, and as a constant where neither the next order nor rounding (1e-15 / v, with
  // some ten operations 1e-14 / v) disturbs its first three digits.
  constexpr double c = 16.161;
  for (std::size_t i = 1; i < library.size(); ++i) {
    const double before = std::abs(library[i - 1].velocity_before);
    if (before > 1e-2) continue;
    const double loss = 1.0 - std::abs(library[i].velocity_before) / (before * scene.restitution);
    EXPECT_NEAR(loss, 0.0, 1.01 * c * before + 1e-13) << i;
    if (before > 1e-11 && before < 1e-5) {
      EXPECT_NEAR(loss / before / c, 1.0, 5e-3) << i;
    }
  }

  // The gap is known to the rounding of x, 5e-17, and the mass, pressed by a = 0.055, falls through
  // that at sqrt(2 a 5e-17) = 2.3e-9: the speeds scatter about a few times that and stay there.
  constexpr std::size_t impacts = 20'000;
  std::vector<double> early, late;
  const auto plain = plain::run(scene, period, {.max_impacts = impacts}).events;
  ASSERT_EQ(plain.size(), impacts);
  for (std::size_t i = 0; i < impacts; ++i) {
    const double speed = std::abs(plain[i].velocity_before);
    if (i >= 100 && i < 5100) early.push_back(speed);
    if (i >= impacts - 5000) late.push_back(speed);
  }
  for (const auto &speeds : {early, late}) {
    EXPECT_GT(median(speeds), 1e-10);
    EXPECT_LT(median(speeds), 1e-8);
  }
  fmt::print("library to {:.2g} in {} impacts; plain scheme: median {:.2g}, later {:.2g}\n",
             std::abs(library.back().velocity_before), library.size(), median(early), median(late));
}

TEST(PlainScheme, WithoutAThresholdMakesSpuriousImpactsThatTheTableDoesNotHave) {
  const auto table = fifty_digit_table();
  const auto of_first_period = std::count_if(
      table.begin(), table.end(),
      [](const figures::TrueEvent &row) { return row.time < period && row.event == "impact"; });
  EXPECT_LT(of_first_period, 100);
  // Seven impacts of mass 2, and those of mass 1 from 0.3 down to 1e-16, by a factor of 0.7 each.
  RunOptions options;
  options.resolve_chatter = 0.0;
  EXPECT_LT(simulate(scene, period, options).counters.impacts, 110);
  const double release = 13.7832653224407;  // computed: the first release of mass 1
  constexpr long long cap = 20'000;
  const plain::Result plain = plain::run(scene, period, {.max_impacts = cap});
  EXPECT_TRUE(plain.capped);
  EXPECT_EQ(plain.impacts, cap);
  EXPECT_LT(plain.time, release) << "it does not get past the first sticking phase";
}

TEST(PlainScheme, WithAThresholdFindsTheReleasesButNotTheTimesOfSticking) {
  EventRecorder library;
  const Outcome outcome = simulate(scene, 750.0, {}, library);
  for (double threshold : {1e-3, 1e-5, 1e-7}) {
    const auto run =
        figures::with_threshold(scene, 750.0, library.events, {.threshold = threshold});
    EXPECT_EQ(run.sticks, outcome.counters.sticks) << threshold;
    EXPECT_EQ(run.releases, outcome.counters.releases) << threshold;
    // A mass that leaves its last impact at r v, pressed by a >= 0.055, would rise (r v)^2 / (2 a)
    // and bounce for 2 r v / (a (1 - r)): the force on the other mass misses an impulse of that
    // order times that, 7e2 v^3. The times of release carry the rounding of t = 750 besides.
    EXPECT_LT(run.release_error, 1e3 * std::pow(threshold, 3) + 1e-11) << threshold;
    // The stick comes early by that duration, 85 v at most; in one of 66 chatters v is not much
    // below the threshold.
    EXPECT_GT(run.stick_error, threshold) << threshold;
    EXPECT_LT(run.stick_error, 85 * threshold) << threshold;
  }
}

TEST(PlainScheme, ALargeThresholdInventsDualStickingInFigure5c) {
  // Both masses cannot stick there: the force on mass 2 is zero exactly when mass 1 sticks.
  const Scene close = paper::figure5c();
  EventRecorder library;
  require_complete(simulate(close, 1000.0, {}, library));
  for (const Event &event : library.events) EXPECT_NE(contact_mode_name(event.held), "1+2");
  const auto stuck_together = [&close](double threshold) {
    bool held[2] = {false, false}, together = false;
    for (const auto &event : plain::run(close, 1000.0, {.threshold = threshold}).events) {
      if (event.kind != EventKind::impact) held[event.mass - 1] = event.kind == EventKind::stick;
      together = together || (held[0] && held[1]);
    }
    return together;
  };
  EXPECT_TRUE(stuck_together(1e-2));
  EXPECT_FALSE(stuck_together(1e-4));
}

// --- The stiff spring ----------------------------------------------------------------------------

TEST(StiffSpring, GivesTheCoefficientOfRestitution) {
  // A mass on next to no spring thrown against the stop: what it leaves with is r times what it
  // came with, to the tolerance of the integration over three contacts' worth of steps.
  for (auto stepper : {Stepper::dopri5, Stepper::rosenbrock4})
    for (double r : {0.3, 0.7, 0.95, 1.0}) {
      Scene thrown;
      thrown.mass = {2.0};
      thrown.stiffness = {1e-12};
      thrown.omega = 0.0;
      thrown.restitution = r;
      thrown.stops = {{1, Side::lower, 0.0}};
      thrown.displacement = {0.5};
      thrown.velocity = {-1.0};
      const auto result = stiff_spring::integrate(
          thrown, 1.0, {.kappa = 1e8, .tolerance = 1e-10, .stepper = stepper});
      EXPECT_EQ(result.broke, "");
      ASSERT_EQ(result.contacts.size(), 1u);
      EXPECT_NEAR(result.contacts[0].time, 0.5, 1e-7);
      EXPECT_NEAR(result.state[1], r, 2e-5) << name(stepper);
    }
}

TEST(StiffSpring, ErrorFallsWithTheRootOfTheStiffness) {
  const figures::Rigid rigid = figures::rigid_motion(scene);
  for (std::size_t i = 0; i < figures::first_impacts; ++i)
    EXPECT_NEAR(rigid.impacts[i], fifty_digit_table()[i].time, 1e-12);
  // Up to the stiffness where the tolerance takes over: for Rosenbrock's method that is earlier in
  // the impact times, which are read off an interpolant of third order.
  for (auto [stepper, stiffest] :
       {std::pair{Stepper::dopri5, 11}, std::pair{Stepper::rosenbrock4, 9}}) {
    figures::SpringError last;
    for (int decade = 7; decade <= stiffest; ++decade) {
      const auto error = figures::spring_error(
          scene, rigid, {.kappa = std::pow(10.0, decade), .tolerance = 1e-10, .stepper = stepper});
      if (decade > 7) {
        // sqrt(10) per decade but for the next order, kappa^-1, and the tolerance.
        EXPECT_NEAR(last.state / error.state, std::sqrt(10.0), 0.2) << name(stepper) << decade;
        EXPECT_NEAR(last.time / error.time, std::sqrt(10.0), 0.2) << name(stepper) << decade;
      }
      last = error;
    }
    EXPECT_GT(last.state, 1e-6) << "the library's own error is below 1e-12";
  }
}

TEST(StiffSpring, ALooseToleranceLimitsTheError) {
  const figures::Rigid rigid = figures::rigid_motion(scene);
  // Where the law of the stiff spring would give less; Rosenbrock's method makes better use of the
  // same tolerance.
  for (auto [stepper, kappa] :
       {std::pair{Stepper::dopri5, 1e12}, std::pair{Stepper::rosenbrock4, 1e14}}) {
    const auto error = [&, method = stepper](double stiffness, double tolerance) {
      return figures::spring_error(scene, rigid,
                                   {.kappa = stiffness, .tolerance = tolerance, .stepper = method})
          .state;
    };
    const double law = error(1e12, 1e-10) * std::sqrt(1e12 / kappa);
    EXPECT_GT(error(kappa, 1e-6), 20.0 * law) << name(stepper);
  }
}

TEST(StiffSpring, CostsMoreTheMoreAccurateItIsAndTheLibraryDoesNot) {
  const Counters library = simulate(scene, period).counters;
  EXPECT_LT(library.expansions, 100);
  EXPECT_LT(library.coefficients, 1500);
  const auto cost = [](double kappa, Stepper stepper, double tolerance) {
    return stiff_spring::integrate(scene, period,
                                   {.kappa = kappa, .tolerance = tolerance, .stepper = stepper})
        .evaluations;
  };
  // Explicit steps follow the period of the spring for as long as a mass rests on it.
  const auto soft = cost(1e8, Stepper::dopri5, 1e-10), stiff = cost(1e12, Stepper::dopri5, 1e-10);
  EXPECT_GT(soft, 20 * library.coefficients);
  EXPECT_GT(stiff, 10 * soft);
  // Implicit steps do not, as long as their Jacobian is right; they are many all the same.
  const auto implicit = cost(1e11, Stepper::rosenbrock4, 1e-6);
  EXPECT_GT(implicit, 5 * library.coefficients);
  EXPECT_LT(implicit, 2 * cost(1e7, Stepper::rosenbrock4, 1e-6));
}

TEST(StiffSpring, SaysWhereItBreaks) {
  const auto underflow =
      stiff_spring::integrate(scene, figures::before_chatter,
                              {.kappa = 1e16, .tolerance = 1e-10, .stepper = Stepper::rosenbrock4});
  EXPECT_EQ(underflow.broke, "step underflow");
  EXPECT_LT(underflow.time, figures::before_chatter);
  const auto capped = stiff_spring::integrate(
      scene, period, {.kappa = 1e14, .tolerance = 1e-10, .max_evaluations = 200'000});
  EXPECT_EQ(capped.broke, "too many evaluations");
  EXPECT_LT(capped.time, period);
  EXPECT_LT(capped.evaluations, 210'000);
  Scene dead = scene;
  dead.restitution = 0.0;
  EXPECT_THROW(stiff_spring::integrate(dead, 1.0, {}), std::invalid_argument);
}

}  // namespace
