// The library against orbits of one impact in closed form: the sum of the modes, in extended
// precision (Shaw and Shaw 1989; Natsiavas 1993; Pun et al. 1998).
#include <gtest/gtest.h>

#include <numeric>

#include "figures/check/published_results.hpp"
#include "reference/numbers/checked_number.hpp"
#include "reference/scenes/extreme_scenes.hpp"
#include "tests/support/events.hpp"
#include "tests/support/mode_motion.hpp"

namespace {

using namespace vibro_impact;

struct KnownOrbit {
  std::string name;
  Scene scene;
  int periods, branch;
  std::size_t stop = 0;  // the stop that is hit, which a fold puts where it belongs
  // The time and the velocity of the impact, the sum of the multipliers, the state after it.
  double time = 0.0, velocity_before = 0.0, trace = 0.0;
  MotionState after = {};
};

// An orbit with one impact, in so many forcing periods. The branch is +1 for the faster orbit, -1
// for the slower one, and 0 for the fold where they meet. All modes are underdamped.
//
// A unit impulse at every impact alone would give the mass that hits the displacement g and the
// velocity b just after it. Let the forcing alone move that mass by Re X exp(i Omega t), let
// Z = X exp(i Omega t) at the impact and d be the stop. The impulse p = -m (1 + r) v then has
// Re Z = d - p g and Im Z = p h, where Omega h = b - r / (m (1 + r)). So |X|^2 = (d - p g)^2 +
// (p h)^2. The two roots meet at the fold, d^2 = |X|^2 (1 + (g / h)^2).
KnownOrbit solved(KnownOrbit orbit) {
  using vibro_impact::testing::Real, vibro_impact::testing::RealVector;
  using Modal = Eigen::Array<Real, Eigen::Dynamic, 1>;  // a number for each mode
  Scene &scene = orbit.scene;
  Stop &stop = scene.stops[orbit.stop];
  orbit.after = start_of(scene);
  const auto modes = vibro_impact::testing::free_modes(scene, Held(scene.mass.size(), 0));
  const Eigen::Index hit = stop.mass - 1;
  const Real omega = scene.omega;
  const Real two_pi = 2 * std::acos(Real(-1));
  const Real period = two_pi * orbit.periods / omega;
  const Real r = law_of(scene, stop).restitution;
  const Real m = scene.mass[static_cast<std::size_t>(hit)];
  const Modal lambda = modes.lambda.array();
  const Modal cosine = modes.cosine.array();
  const Modal w = modes.shape.row(hit).transpose().array();

  // A free motion over the period, and what an impulse at every impact gives just after it.
  const Modal decay = scene.beta / 2 * lambda;
  const Modal nu = (lambda - decay.square()).sqrt();
  const Modal envelope = (-decay * period).exp();
  const Modal c = envelope * (nu * period).cos();
  const Modal s = envelope * (nu * period).sin() / nu;
  const Modal periodic = 1 - 2 * c + envelope.square();
  const Modal kick = w * s / periodic;
  const Modal kick_rate = w * (1 - c - decay * s) / periodic;
  const Real g = (w * kick).sum();
  const Real h = ((w * kick_rate).sum() - r / (m * (1 + r))) / omega;

  // The forced motion, X = x_cos - i x_sin.
  const Modal detuning = lambda - omega * omega;
  const Modal drag = 2 * omega * decay;
  const Modal size = detuning.square() + drag.square();
  const Modal forced_cos = cosine * detuning / size;
  const Modal forced_sin = cosine * drag / size;
  const Real x_cos = (w * forced_cos).sum();
  const Real x_sin = (w * forced_sin).sum();
  const Real forced = x_cos * x_cos + x_sin * x_sin;  // |X|^2

  if (orbit.branch == 0 && forced > 0)
    stop.position = static_cast<double>(std::sqrt(forced * (1 + g * g / (h * h))));
  const Real d = stop.position;
  Real root = 0;
  if (orbit.branch != 0) root = orbit.branch * std::sqrt(forced * (g * g + h * h) - h * h * d * d);
  const Real p = (d * g - root) / (g * g + h * h);
  const Real velocity = -p / (m * (1 + r));
  Real angle = 0;  // Omega t; any without forcing
  if (forced > 0) angle = std::atan2(p * h, d - p * g) + std::atan2(x_sin, x_cos);
  if (angle < 0) angle += two_pi;
  const Modal q = p * kick + forced_cos * std::cos(angle) + forced_sin * std::sin(angle);
  const Modal dq =
      p * kick_rate + omega * (forced_sin * std::cos(angle) - forced_cos * std::sin(angle));

  // A displacement xi before the impact delays it by -xi / v. The derivative of the return map is
  // the transition of the modes, then the impact law and this delay.
  const Modal jump = (1 + r) * m * w.square();
  const Modal modal_acceleration = cosine * std::cos(angle) - 2 * decay * (dq - p * w) - lambda * q;
  const Real acceleration = (w * modal_acceleration).sum();  // of the mass before the impact
  const Real by_delay = (jump * s).sum() * acceleration / velocity;
  orbit.trace = static_cast<double>((2 * (c * (1 - jump) + decay * jump * s)).sum() + by_delay);
  orbit.velocity_before = static_cast<double>(velocity);
  orbit.time = static_cast<double>(angle / omega);

  const RealVector x = modes.shape * q.matrix();
  const RealVector v = modes.shape * dq.matrix();
  orbit.after.instant.phase = orbit.time;
  for (std::size_t i = 0; i < scene.mass.size(); ++i) {
    orbit.after.displacement[i] = static_cast<double>(x(static_cast<Eigen::Index>(i)));
    orbit.after.velocity[i] = static_cast<double>(v(static_cast<Eigen::Index>(i)));
  }
  return orbit;
}

Scene chain(int masses, double beta, double amplitude, double omega, double r, double stop) {
  Scene scene = extremes::chain(masses, beta);
  scene.amplitude.assign(scene.mass.size(), 0.0);
  scene.amplitude.front() = amplitude;
  scene.omega = omega;
  scene.restitution = r;
  scene.stops = {{masses, Side::upper, stop}};
  return scene;
}

// Figure 3 at Omega = 2.4, and chains of two equal, three unequal and five equal masses before one
// stop. Chains without forcing, damping and loss have nonsmooth modes (Gendelman and Manevitch
// 2008; Thorin, Delezoide and Legrand 2017), here those with the period of Omega.
std::vector<KnownOrbit> known_orbits() {
  Scene three = chain(3, 0.1, 0.5, 1.1, 0.7, 0.6);
  three.mass = {1.0, 2.0, 0.5};
  three.stiffness = {1.0, 3.0, 2.0};
  three.stops[0].mass = 2;
  std::vector<KnownOrbit> known;
  for (const int branch : {1, -1, 0}) {
    known.push_back(solved({"figure3", paper::figure3(2.4), 3, branch, 1}));
    known.push_back(solved({"two", chain(2, 0.1, 0.5, 0.9, 0.7, 1.1), 1, branch}));
    known.push_back(solved({"three", three, 2, branch}));
    known.push_back(solved({"five", chain(5, 0.1, 0.5, 0.7, 0.7, 1.27), 2, branch}));
  }
  for (const auto &[masses, omega] : {std::pair{2, 0.95}, {3, 0.7}, {5, 0.51}})
    known.push_back(solved({"free", chain(masses, 0, 0, omega, 1, 1), 1, 0}));
  return known;
}

// Rounding is 1e-12 a return, which the largest multiplier amplifies. A fold has the multiplier 1.
// A nonsmooth mode has it twice, because it belongs to a family in the energy, and rounding moves a
// double eigenvalue by its root.
TEST(OneImpact, MultipliersAndFortyPeriodsAreThoseOfTheClosedForm) {
  for (const KnownOrbit &given : known_orbits()) {
    SCOPED_TRACE(given.name);
    const MotionState &after = given.after;
    const MotionState start = at_quiet_phase(given.scene, after);
    const auto map = stroboscopic_map_and_derivative(given.scene, start, given.periods);
    const auto multipliers = floquet_multipliers(given.scene, *map.derivative, start.held);
    const auto trace = std::reduce(multipliers.begin(), multipliers.end());
    EXPECT_NEAR(trace.real(), given.trace, 1e-12);
    if (given.branch == 0) {
      EXPECT_NEAR(published::multiplier_near(1.0, multipliers), 1.0,
                  given.scene.forced() ? 1e-12 : 1e-6);
    }
    const double period = Clock(given.scene.omega).period;
    const auto events =
        vibro_impact::testing::events_from(given.scene, after, given.time + 40.5 * period);
    ASSERT_EQ(events.size(), 40u / static_cast<unsigned>(given.periods));
    const double growth = std::max(1.0, std::abs(multipliers.front()));
    double tolerance = 1e-12, time = given.time;
    for (const Event &event : events) {
      time += given.periods * period;
      tolerance = tolerance * growth + 1e-12;
      if (tolerance > 1e-6) break;
      EXPECT_NEAR(event.time, time, tolerance);
      EXPECT_NEAR(event.velocity_before, given.velocity_before, tolerance);
    }
  }
}

// From rest the stop is not reached. Newton's method finds both orbits from 1e-4 away, and
// none when the stop is 1e-4 beyond their fold.
TEST(OneImpact, TwoOrbitsCoexistWithRestUpToTheirFold) {
  for (KnownOrbit &given : known_orbits()) {
    if (!given.scene.forced()) continue;
    SCOPED_TRACE(given.name);
    for (const int impacts : record_of(given.scene).counts.impacts) EXPECT_EQ(impacts, 0);
    MotionState guess = at_quiet_phase(given.scene, given.after);
    (given.branch == 0 ? given.scene.stops[given.stop].position : guess.displacement[0]) *= 1.0001;
    const PeriodicOrbit orbit = find_periodic_orbit(given.scene, guess, given.periods);
    EXPECT_EQ(orbit.converged, given.branch != 0);
    EXPECT_TRUE(given.branch == 0 || orbit.stable() == (given.branch == 1));
  }
}

// The printed speed is good to 5e-6. The amplitude is stationary at a fold, and so good to 1e-10. A
// fold at the stop d for an amplitude A is one at the stop 1 for A / d.
TEST(OneImpact, FoldsOfVividAreThoseOfTheClosedForm) {
  for (const auto &printed : numbers::checked_numbers(REFERENCE_DIR)) {
    if (printed.source != "vivid" || printed.quantity != "fold_multiplier") continue;
    const Scene scene = published::after_impact(printed.arguments).first;
    const double amplitude = scene.amplitude[0],
                 stop = solved({printed.id, scene, 2, 0}).scene.stops[0].position;
    EXPECT_NEAR(amplitude / stop, amplitude, 1e-10) << printed.id;
  }
}

}  // namespace
