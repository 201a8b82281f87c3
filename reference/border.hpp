// Border orbits: a chatter that ends just as the hold force falls to zero.
#pragma once

#include "orbit.hpp"

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace vibro_impact_reference {

/// A chatter that ends just as the hold force falls to zero: beside the stop the mass then obeys
/// gap'' = -j (t* - t), with j the rate of fall over the mass, and every flight is the one before,
/// shorter by `shrink`. With a = j (t* - t) and v the speed after an impact, a / sqrt(v j) is
/// `number` at all impacts. A chatter beside it leaves this number by a factor `growth` from impact
/// to impact.
struct BorderChatter {
  Real shrink, number, growth;
};

inline BorderChatter border_chatter_of(const Real &r) {
  // A flight from a = j = 1, for a time t: v = t/2 - t^2/6, then v' = r (t/2 - t^2/3), a' = 1 - t,
  // and v'/v = a'^2.
  const auto speed = [](const Real &t) -> Real { return t / 2 - t * t / 6; };
  const auto after = [&](const Real &t) -> Real { return r * (t / 2 - t * t / 3); };
  const Real t = bisect(
      [&](const Real &trial) { return after(trial) < (1 - trial) * (1 - trial) * speed(trial); },
      small(60), Real(1), small(48));
  const Real shrink = 1 - t, number = 1 / sqrt(speed(t));
  // The next number, a' / sqrt(v'), and the present one, by the duration of the flight.
  const Real dv = Real(1) / 2 - t / 3, dafter = r * (Real(1) / 2 - 2 * t / 3);
  const Real dnumber = -dv / (2 * speed(t));
  const Real dnext = -1 / shrink - dafter / (2 * after(t));
  return {shrink, number, dnext / dnumber};
}

/// By how much the chatter at stop `stop` that is nearest to the border one leaves it: the number
/// above at the impact at which the mass is taken to stick, without what falls with the flights
/// (from the impact before), brought back to the start of the chatter by the growth. Throws
/// std::runtime_error if no chatter of the run ends in a stick.
inline Real border_distance(const Scene &scene, const Run &run, std::size_t stop,
                            const BorderChatter &border) {
  const std::size_t mass = scene.stops[stop].mass;
  std::optional<Real> before, nearest, distance;
  for (const Piece &piece : run.pieces) {
    if (piece.events_before == 0) continue;
    const Event &event = run.events[piece.events_before - 1];
    if (event.mass != mass || event.kind == Event::Kind::release) continue;
    const bool sticks = event.kind == Event::Kind::stick;
    const Real speed = abs(sticks ? event.velocity_before : event.velocity_after);
    const Signal pressing =
        pressing_signal(scene.chain, scene.stops[stop], motion_at(piece.flow, Real(0)));
    const Real a = pressing.value / scene.chain.masses[mass];
    const Real j = -pressing.rate / scene.chain.masses[mass];
    if (a <= 0 || j <= 0 || speed <= 0) {
      before.reset();
      continue;
    }
    const Real number = a / sqrt(speed * j);
    if (sticks && before && (!nearest || abs(number - border.number) < *nearest)) {
      nearest = abs(number - border.number);
      const Real power = log(border.growth) / -log(border.shrink);
      const Real limit = (number - border.shrink * *before) / (1 - border.shrink);
      distance = (limit - border.number) * pow(a / j, power);
    }
    before = number;
  }
  if (!distance) throw std::runtime_error("border orbit: no chatter ends in a stick");
  return *distance;
}

/// The frequency near that of the scene at which a chatter at stop `stop` ends on the border: the
/// orbit and the frequency are solved for with the chatter followed down to ever lower speeds v,
/// where the mass is then held until the hold force falls to zero. That leaves out a displacement
/// of the order v^3/2, which is the error.
inline Located border_frequency(Scene scene, std::size_t stop, int periods, int settling,
                                const std::vector<Real> &floors) {
  const BorderChatter border = border_chatter_of(scene.restitution);
  SoughtOrbit orbit =
      orbit_from_rest(std::move(scene), periods, settling, resolution_down_to(floors.front()));
  const auto distance = [&](const Scene &at, const Run &run) {
    return border_distance(at, run, stop, border);
  };
  SquareMatrix inverse;
  Located located{0, 1};
  for (std::size_t k = 0; k < floors.size(); ++k) {
    if (k == 1) inverse.resize(0, 0);  // the derivatives at the first floor are coarse
    const Real left_out = pow(floors[k], Real("1.5"));
    const Real step = solve_orbit(orbit, inverse, resolution_down_to(floors[k]), distance, Real(0),
                                  left_out / 100);
    if (k > 0)
      located.error =
          abs(orbit.unknowns.back() - located.value) * pow(floors[k] / floors[k - 1], Real("1.5")) +
          step;
    located.value = orbit.unknowns.back();
  }
  return located;
}

}  // namespace vibro_impact_reference
