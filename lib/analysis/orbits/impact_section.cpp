#include "impact_section.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "motion_state.hpp"
#include "parameter_flow.hpp"
#include "vibro_impact/analysis/tangent.hpp"

namespace vibro_impact {

namespace {

using Eigen::Index;
using Kind = Parameter::Kind;

// True when the parameter belongs to the stop of the impact itself.
bool of_the_stop(const ImpactFamily &family, Kind kind) {
  return is_of_stop(family.scene, family.parameter, kind, family.stop);
}

// The scene without the stop, and what the parameter is called there: nothing where it is gone.
Scene without_stop(const ImpactFamily &family, Scene scene) {
  scene.stops.erase(scene.stops.begin() + static_cast<std::ptrdiff_t>(family.stop));
  return scene;
}
std::vector<Parameter> named_without_stop(const ImpactFamily &family) {
  Parameter parameter = family.parameter;
  if (parameter.kind != Kind::stop && parameter.kind != Kind::restitution) return {parameter};
  const int number = static_cast<int>(family.stop) + 1;
  if (parameter.index == number) return {};
  if (parameter.index > number) --parameter.index;
  return {parameter};
}

// The stop is in place between `from` and `to`, in fractions of the orbit, only.
ImpactReturn flight(const ImpactSection &section, double from, double to) {
  const ImpactFamily &family = section.family;
  const Scene absent = without_stop(family, section.scene);
  const std::vector<std::size_t> free = free_coordinates(section.state.held);
  const std::size_t n = section.state.held.size();
  Matrix columns(2 * n, free.size() + 1);
  for (std::size_t k = 0; k < free.size(); ++k) columns(free[k], k) = 1.0;
  if (of_the_stop(family, Kind::stop)) columns(section.mass, free.size()) = 1.0;
  if (of_the_stop(family, Kind::restitution))
    columns(n + section.mass, free.size()) =
        -section.sigma * section.law.after_by_restitution(section.speed);
  const double begin = section.state.instant.phase,
               whole = time_after(section.scene, section.state, family.periods) - begin;
  ImpactReturn back{section.state, {}, {}, {family.stop, begin, whole}};
  const auto fly = [&](bool present, double until) {
    const Scene &scene = present ? section.scene : absent;
    TangentRecorder tangents(
        scene, back.state, columns,
        {.by = present ? std::vector{family.parameter} : named_without_stop(family)});
    OtherEvents others = back.others;
    back.state = require_complete(
                     simulate_from(scene, back.state, begin + whole * until, {}, tangents, others))
                     .state;
    if (present) back.others = others;  // without the stop its number is another's
    tangents.finish(back.state.instant);
    columns = tangents.tangent();
  };
  if (from < to) {
    fly(false, from);
    fly(true, to);
  }
  fly(false, 1.0);
  const Eigen::MatrixXd all = view(columns);
  back.tangent = all.leftCols(static_cast<Index>(free.size()));
  back.by_parameter = all.col(static_cast<Index>(free.size()));
  return back;
}

}  // namespace

ImpactSection::ImpactSection(const ImpactFamily &of, const ImpactUnknowns &at, double closing)
    : family(of),
      scene(with(of.scene, of.parameter, at.values(at.values.size() - 1))),
      mass(static_cast<std::size_t>(scene.stops[of.stop].mass - 1)),
      sigma(sign(scene.stops[of.stop].side)),
      speed(closing),
      law(law_of(scene, scene.stops[of.stop])) {
  check(scene);
  const double turn = 2.0 * std::numbers::pi, angle = at.values(0);
  const Clock clock(scene.omega);
  state.instant = later({}, (angle - turn * std::floor(angle / turn)) / scene.omega, clock);
  state.instant.cycle = 0;
  state.held = at.held;
  const std::size_t n = at.held.size();
  state.displacement.assign(n, 0.0);
  state.velocity.assign(n, 0.0);
  hold_at_stops(scene, state);
  Index k = 1;
  for (const std::size_t row : at.others(mass)) coordinate(state, row) = at.values(k++);
  state.displacement[mass] = scene.stops[of.stop].position;
  state.velocity[mass] = -sigma * law.after(speed);
}

bool is_real(const ImpactSection &section, double from, double to) {
  if (section.speed < 0.0) return false;
  const Scene &scene = section.scene, absent = without_stop(section.family, scene);
  const double begin = section.state.instant.phase,
               whole = time_after(scene, section.state, section.family.periods) - begin;
  if (!(from < to)) from = to = 0.5;
  const auto contacts = [&](const MotionState &start, double until) {
    EventRecorder told;
    told.from = begin;
    simulate_from(scene, start, begin + whole * until, {}, told);
    return std::count_if(told.events.begin(), told.events.end(), [&](const Event &event) {
      // The impact itself may come early by the square root of rounding where it grazes.
      return event.stop == section.family.stop && event.time < begin + whole * (1.0 - 1e-6);
    });
  };
  if (contacts(section.state, from) > 0) return false;
  MotionState last = simulate_from(absent, section.state, begin + whole * from).state;
  const auto clear = [&] {
    return section.sigma *
               (scene.stops[section.family.stop].position - last.displacement[section.mass]) >
           0.0;
  };
  if (!clear()) return false;
  if (from < to) last = simulate_from(scene, last, begin + whole * to).state;
  return clear() && contacts(last, 1.0) == 0;
}

std::optional<ImpactEquations> equations(const ImpactSection &section, const ImpactUnknowns &at,
                                         double from, double to) {
  ImpactEquations eq{flight(section, from, to), {}, {}, {}, {}, {}};
  const ImpactReturn &back = eq.back;
  if (back.state.held != at.held) return std::nullopt;
  const std::vector<std::size_t> free = free_coordinates(at.held), others = at.others(section.mass);
  const auto n = static_cast<Index>(at.held.size()), size = static_cast<Index>(free.size());
  const Index x_row = static_cast<Index>(section.mass), v_row = n + x_row;
  // Just before the impact: the start, but for the velocity of the mass.
  MotionState before = section.state;
  before.velocity[section.mass] = section.sigma * section.speed;
  Eigen::VectorXd target(2 * n), slope = Eigen::VectorXd::Zero(2 * n);
  target << view(before.displacement), view(before.velocity);
  const Eigen::VectorXd end = view(coordinates(back.state));
  eq.residual = (end - target)(free);
  const Eigen::VectorXd f_after = vector_field(section.scene, section.state),
                        f_end = vector_field(section.scene, back.state);
  const auto column_of = [&](Index row) {
    return std::find(free.begin(), free.end(), static_cast<std::size_t>(row)) - free.begin();
  };
  eq.by_unknowns.resize(size, size);
  eq.by_unknowns.col(0) = (f_end - back.tangent * f_after(free))(free) / section.scene.omega;
  Index k = 1;
  for (const std::size_t row : others) {
    Eigen::VectorXd change = back.tangent.col(column_of(static_cast<Index>(row)));
    change(static_cast<Index>(row)) -= 1.0;
    eq.by_unknowns.col(k++) = change(free);
  }
  Eigen::VectorXd by_parameter = back.by_parameter;
  if (of_the_stop(section.family, Kind::stop)) by_parameter(x_row) -= 1.0;
  eq.by_unknowns.col(k) = by_parameter(free);
  slope = -section.sigma * section.law.slope(section.speed) * back.tangent.col(column_of(v_row));
  slope(v_row) -= section.sigma;
  eq.by_speed = slope(free);
  // Saltation: R + sigma / v (f+ - R f-) e_x', R = 1 but for 0 at x and -r at x' of the mass.
  Eigen::VectorXd law = Eigen::VectorXd::Ones(2 * n);
  law(x_row) = 0.0;
  law(v_row) = -section.law.slope(section.speed);
  const Eigen::VectorXd jump =
      section.sigma * (f_after - law.cwiseProduct(vector_field(section.scene, before)));
  eq.regular = law(free).asDiagonal() * back.tangent(free, Eigen::all);
  eq.singular = jump(free) * back.tangent.row(x_row);
  return eq;
}

}  // namespace vibro_impact
