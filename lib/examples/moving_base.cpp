// Stops on a base that moves by a cos(Omega t), in coordinates relative to the base: every mass
// then feels m_i a Omega^2 cos(Omega t). The first link hangs on the base as well. A constant force
// presses the last mass towards its stop.
#include <cmath>
#include <cstdio>

#include "vibro_impact/vibro_impact.hpp"

int main() {
  using namespace vibro_impact;
  constexpr double a = 0.8, omega = 0.7;
  Scene scene{.mass = {1.0, 2.0},
              .stiffness = {1.0, 1.0},
              .beta = 0.1,
              .constant = {0.0, 0.05},
              .omega = omega,
              .restitution = 0.7,
              .stops = {{1, Side::lower, -0.3}, {2, Side::upper, 0.4}}};
  for (const double mass : scene.mass) scene.amplitude.push_back(mass * a * omega * omega);

  // The same base with stops and masses in a frame at rest, where only the first link moves: a base
  // u = a cos(Omega t) pulls mass 1 by k_1 u + beta k_1 u', a cosine and a sine.
  Scene shaken = scene;
  shaken.amplitude = {scene.stiffness[0] * a, 0.0};
  shaken.sine = {-scene.beta * scene.stiffness[0] * a * omega, 0.0};

  bool reached = true;
  for (const Scene &chain : {scene, shaken}) {
    EventRecorder recorder(90.0);
    const Outcome outcome = simulate(chain, 100.0, recorder);
    reached = reached && outcome.ending == Ending::reached;
    for (const Event &event : recorder.events)
      std::printf("t = %.9f  mass %d  %-7s  v = %+.6f\n", event.time, event.mass, name(event.kind),
                  event.velocity_before);
    std::printf("%lld impacts\n", outcome.counters.impacts);
  }

  // Without stops, the displacements in the two frames differ by that of the base.
  scene.stops.clear();
  shaken.stops.clear();
  shaken.displacement = {a, a};
  const double relative = simulate(scene, 100.0).state.displacement[1],
               absolute = simulate(shaken, 100.0).state.displacement[1];
  const bool agree = std::abs(absolute - relative - a * std::cos(omega * 100.0)) < 1e-12;
  return reached && agree ? 0 : 1;
}
