// The scenes of Table I, solved for.
#pragma once

#include "key_numbers.hpp"
#include "reference/scenes/pair_scenes.hpp"
#include "scenes.hpp"

#include <functional>
#include <map>
#include <stdexcept>
#include <string>

namespace vibro_impact_reference {

/// The zero of a function by plain bisection between two arguments of different sign of it.
inline Real zero_between(const std::function<Real(const Real &)> &f, const Real &a, const Real &b,
                         const Real &width) {
  const bool positive = f(a) > 0;
  if (positive == (f(b) > 0)) throw std::logic_error("zero_between: no change of sign");
  return bisect([&](const Real &x) { return (f(x) > 0) == positive; }, a, b, width);
}

/// The two-mass chain of the paper from rest, without stops, as one flow.
inline Flow free_flow(const Real &frequency) {
  Chain chain = in_digits(vibro_impact::pairs::without_stops(1.0), 0.0).chain;
  chain.frequency = frequency;
  Eigensystems known;
  return flow_from(chain, Real(0), Vector(2), Vector(2), {false, false}, known);
}

/// The scenes of Table I that are solved for, on the closed form of the motion before the event.
inline std::map<std::string, Real> table1_numbers(const Resolution &resolution) {
  using namespace vibro_impact::pairs;
  std::map<std::string, Real> numbers;
  const Real &width = resolution.roots.width;
  const auto turning = [&](const Flow &flow, std::size_t mass, const Bracket &bracket) {
    return zero_between([&](const Real &t) { return motion_at(flow, t).v[mass]; },
                        Real(bracket.from), Real(bracket.to), width);
  };
  {
    const auto other_speed = [&](const Real &frequency) {
      const Flow flow = free_flow(frequency);
      return motion_at(flow, turning(flow, 0, dual_grazing_minimum)).v[1];
    };
    const Real frequency = zero_between(other_speed, Real(dual_grazing_omega.from),
                                        Real(dual_grazing_omega.to), width);
    const Flow flow = free_flow(frequency);
    const Real time = turning(flow, 0, dual_grazing_minimum);
    const Motion motion = motion_at(flow, time);
    numbers["DG_Omega"] = frequency;
    numbers["DG_time"] = time;
    numbers["DG_s1"] = motion.x[0];
    numbers["DG_s2"] = motion.x[1];
  }
  {
    const vibro_impact::Scene scene = double_impact();
    const Flow flow = free_flow(Real(scene.omega));
    const Real place = Real(scene.stops[0].position);
    const Real time =
        zero_between([&](const Real &t) { return motion_at(flow, t).x[0] - place; },
                     Real(double_impact_time.from), Real(double_impact_time.to), width);
    numbers["DI_time"] = time;
    numbers["DI_s2"] = motion_at(flow, time).x[1];
  }
  {
    const Flow flow = free_flow(Real(grazing_impact().omega));
    const Real time = turning(flow, 0, grazing_impact_maximum);
    numbers["GI_time"] = time;
    numbers["GI_s1"] = motion_at(flow, time).x[0];
    numbers["GI_s2"] = motion_at(flow, time).x[1];
  }
  {
    const auto [from, to] = grazing_sticking_maximum;
    Scene scene = in_digits(grazing_sticking(), to);
    scene.stops.pop_back();
    const Flow last = simulate(scene, resolution).pieces.back().flow;
    const double start = static_cast<double>(last.start_time);
    const Real time = turning(last, 1, {from - start, to - start});
    numbers["GS_time"] = last.start_time + time;
    numbers["GS_s2"] = motion_at(last, time).x[1];
  }
  {
    const auto [from, to] = dual_sticking_window;
    const Scene scene = in_digits(dual_sticking(), to);
    const Run run = simulate(scene, resolution);
    const Event &stick = first(run, Event::Kind::stick, 1, Real(from), Real(to));
    numbers["DS_from"] = completion(scene, stick);
    numbers["DS_to"] = first(run, Event::Kind::release, 0, stick.time, Real(to)).time;
  }
  {
    const Run run = simulate(scene_named("figure5a"), resolution);
    const Real stick = first(run, Event::Kind::stick, 0, Real(950), Real(964)).time;
    const Event &hit = first(run, Event::Kind::impact, 1, stick, Real(964));
    numbers["SI_time"] = hit.time;
    numbers["SI_speed"] = hit.velocity_before;
  }
  return numbers;
}

}  // namespace vibro_impact_reference
