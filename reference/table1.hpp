// The scenes of Table I, solved for.
#pragma once

#include "completion.hpp"
#include "key_numbers.hpp"
#include "reference/scenes/pair_scenes.hpp"
#include "scenes.hpp"

#include <functional>
#include <optional>
#include <stdexcept>
#include <vector>

namespace vibro_impact_reference {

/// The zero of a function by plain bisection between two arguments of different sign of it.
inline Real zero_between(const std::function<Real(const Real &)> &f, const Real &a, const Real &b,
                         const Real &width) {
  const bool positive = f(a) > 0;
  if (positive == (f(b) > 0)) throw std::logic_error("zero_between: no change of sign");
  return bisect([&](const Real &x) { return (f(x) > 0) == positive; }, a, b, width);
}

struct PairNumber {
  const char *symbol;
  Real value;
  const char *meaning;
};

/// The two-mass chain of the paper from rest, without stops, as one flow.
inline Flow free_flow(const Real &frequency) {
  Chain chain = in_digits("without stops", vibro_impact::pairs::without_stops(1.0), 0.0).chain;
  chain.frequency = frequency;
  Eigensystems known;
  return flow_from(chain, Real(0), Vector(2), Vector(2), {false, false}, known);
}

/// The scenes of Table I that are solved for, on the closed form of the motion before the event.
inline std::vector<PairNumber> table1_numbers(const Resolution &resolution) {
  using namespace vibro_impact::pairs;
  std::vector<PairNumber> rows;
  const auto add = [&](const char *symbol, const Real &value, const char *meaning) {
    rows.push_back({symbol, value, meaning});
  };
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
    add("DG_Omega", frequency, "dual grazing: frequency at which both first minima coincide");
    add("DG_time", time, "dual grazing: time of the minima");
    add("DG_s1", motion.x[0], "dual grazing: lowest x1, where its stop stands");
    add("DG_s2", motion.x[1], "dual grazing: lowest x2, where its stop stands");
  }
  {
    const vibro_impact::Scene scene = double_impact();
    const Flow flow = free_flow(Real(scene.omega));
    const Real place = Real(scene.stops[0].position);
    const Real time =
        zero_between([&](const Real &t) { return motion_at(flow, t).x[0] - place; },
                     Real(double_impact_time.from), Real(double_impact_time.to), width);
    add("DI_time", time, "double impact: x1 = 0.5 for the first time");
    add("DI_s2", motion_at(flow, time).x[1], "double impact: x2 then, where its stop stands");
  }
  {
    const Flow flow = free_flow(Real(grazing_impact().omega));
    const Real time = turning(flow, 0, grazing_impact_maximum);
    add("GI_time", time, "grazing-impact: first maximum of x1");
    add("GI_s1", motion_at(flow, time).x[0], "grazing-impact: x1 then, where its stop stands");
    add("GI_s2", motion_at(flow, time).x[1], "grazing-impact: x2 then, where its stop stands");
  }
  {
    const auto [from, to] = grazing_sticking_maximum;
    Scene scene = in_digits("grazing-sticking", grazing_sticking(), to);
    scene.stops.pop_back();
    std::optional<Real> time, place;
    const auto observe = [&](const Flow &flow, const Real &duration) {
      if (flow.start_time + duration < Real(to - 0.5)) return;  // not the last flow
      const double start = static_cast<double>(flow.start_time);
      time = flow.start_time + turning(flow, 1, {from - start, to - start});
      place = motion_at(flow, *time - flow.start_time).x[1];
    };
    simulate(scene, observe, resolution);
    add("GS_time", *time, "grazing-sticking: maximum of x2 while mass 1 sticks");
    add("GS_s2", *place, "grazing-sticking: x2 then, where its stop stands");
  }
  {
    const auto [from, to] = dual_sticking_window;
    const Scene scene = in_digits("dual sticking", dual_sticking(), to);
    Completion completion{scene, 1, Real(from)};
    const auto events = simulate(
        scene, [&](const Flow &flow, const Real &) { completion.observe(flow); }, resolution);
    const Event &stick = first(events, Event::Kind::stick, 1, Real(from), Real(to));
    add("DS_from", completion.of(stick), "dual sticking: mass 2 sticks while mass 1 does");
    add("DS_to", first(events, Event::Kind::release, 0, stick.time, Real(to)).time,
        "dual sticking: mass 1 is let go");
  }
  {
    const auto events = simulate(scene_named("figure5a"), {}, resolution);
    const Real stick = first(events, Event::Kind::stick, 0, Real(950), Real(964)).time;
    const Event &hit = first(events, Event::Kind::impact, 1, stick, Real(964));
    add("SI_time", hit.time, "sticking-impact: first impact of mass 2 after mass 1 has stuck");
    add("SI_speed", hit.velocity_before, "sticking-impact: speed of that impact");
  }
  return rows;
}

}  // namespace vibro_impact_reference
