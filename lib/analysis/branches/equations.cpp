#include <cmath>
#include <numbers>

#include "sequence.hpp"

namespace vibro_impact::branches {

namespace {

// The item at which the gap of a mass was zero, and the power of the time since then by which the
// gap is divided. So the next impact is no trivial root, and flights of 1e-7 keep their digits.
struct LastContact {
  int stop = -1, power = 0;
  size_t item = 0;
};

int zeros_of_gap(Happening what) {
  return what == Happening::impact ? 1 : what == Happening::release ? 3 : 2;
}

// A pass through the sequence, flight by flight.
struct Pass {
  const Problem &problem;
  const Sequence &s;
  const Vector &u;
  Model model;
  Eigen::Index columns;  // of all unknowns, or 1
  Flow flow;
  State state;
  std::vector<LastContact> last;

  Pass(const Problem &of, const Sequence &sequence, const Vector &at, bool derivatives)
      : problem(of),
        s(sequence),
        u(at),
        model(of.scene, of.parameter, at(0)),
        columns(derivatives ? at.size() + 1 : 1),
        flow(model, std::max(columns, index(3 + 2 * of.masses()))),
        state(start_of(of, model, sequence, at, columns)),
        last(of.masses()) {
    note_contact(0);
  }

  bool derived() const {
    return columns > 1;
  }
  void note_contact(size_t k) {
    const Item &item = s.items[k];
    if (hits(item.what) || releases(item.what))
      last[problem.mass_of(item)] = {item.stop, zeros_of_gap(item.what), k};
  }
  // The columns that the unknowns before the end of flight k can change.
  Eigen::Index columns_to(size_t k) const {
    return derived() ? problem.time_at(k) + 2 : 1;
  }
  void fly(size_t k) {
    if (derived())
      flow.fly(state, u(problem.time_at(k)), problem.time_at(k) + 1, columns_to(k));
    else
      flow.fly(state, u(problem.time_at(k)));
  }

  // The gap of a mass at a stop, which need not be the one that it touched last.
  Row gap_at(int number, Eigen::Index used) const {
    const ModelStop &stop = model.stop(number);
    const int touched = state.touched[stop.mass];
    Row gap = -stop.sigma * state.y.row(index(stop.mass)).head(used);
    if (touched == number) return gap;
    const Coefficient from = touched < 0 ? Coefficient{} : model.stop(touched).position;
    gap(0) += stop.sigma * (stop.position.value - from.value);
    if (used > 1) gap(1) += stop.sigma * (stop.position.slope - from.slope);
    return gap;
  }
  // The gap at the end of flight k by the power of the time since the last contact, if it was at
  // this stop. Times of a release count in forcing periods, so that the row stays of the order 1.
  Row quotient_of_gap(int number, size_t k) const {
    const Eigen::Index used = columns_to(k);
    Row row = gap_at(number, used);
    const size_t mass = model.stop(number).mass;
    const LastContact &before = last[mass];
    if (before.stop != number || before.power == 0 || state.touched[mass] != number) return row;
    double time = 0.0;
    for (size_t j = before.item; j <= k; ++j) time += u(problem.time_at(j));
    const double period = 2.0 * std::numbers::pi / model.omega.value;
    row /= time * std::pow(time / (before.power > 1 ? period : 1.0), before.power - 1);
    // The denominator depends on the flights. Where Omega changes it, too, the row is zero at the
    // solution.
    if (used > 1)
      for (size_t j = before.item; j <= k; ++j)
        row(problem.time_at(j) + 1) -= before.power * row(0) / time;
    return row;
  }
  // The force that presses a mass into its stop (order 0), or its slope (order 1).
  Row press_at(int number, Eigen::Index used, int order = 0) {
    flow.expand(state, used, 2 + order);
    const double unit = model.stop(number).sigma / (order == 0 ? 1.0 : flow.radian());
    return unit * flow.force(order, model.stop(number).mass).head(used);
  }
  Row gap_speed_at(int number, Eigen::Index used) const {
    const ModelStop &stop = model.stop(number);
    return stop.sigma * state.v.row(index(stop.mass)).head(used);
  }
  // The gap speed after an impact.
  Row rebound_at(int number, Eigen::Index used) const {
    const Row closing = gap_speed_at(number, used);
    const Rebound after = rebound(model.stop(number), closing(0));
    Row row = after.by_closing * closing;
    row(0) = after.speed;
    if (used > 1) row(1) += after.by_parameter;
    return row;
  }
  void apply_impact(const Item &item, Eigen::Index used) {
    const ModelStop &stop = model.stop(item.stop);
    const Eigen::Index i = index(stop.mass);
    const Row after = rebound_at(item.stop, used);
    state.touched[stop.mass] = item.stop;
    state.y.row(i).head(used).setZero();
    state.v.row(i).head(used).setZero();
    if (item.what == Happening::hold)
      state.held[stop.mass] = item.stop;
    else
      state.v.row(i).head(used) = -stop.sigma * after;
  }
};

// The condition that a chatter ends where the press does: w = c f s^2 with the speed w after the
// hold, the slope f of the acceleration at the release and the time s between them.
struct Border {
  size_t hold, release;
  Row w, f;

  Border(const Sequence &s, const Condition *condition, Eigen::Index columns)
      : hold(s.items.size()), release(hold), w(Row::Zero(columns)), f(Row::Zero(columns)) {
    if (!condition || condition->extra != Extra::border) return;
    hold = condition->item;
    for (size_t k = 1; k < s.items.size(); ++k) {
      const size_t at = (hold + k) % s.items.size();
      const Item &item = s.items[at];
      if (item.what != Happening::release || item.stop != s.items[hold].stop) continue;
      release = at;
      break;
    }
  }

  Row equation(const Pass &pass) const {
    const Sequence &s = pass.s;
    const Coefficient c = border_constant(pass.model.stop(s.items[hold].stop).ratio_at_rest());
    double left = 0.0;
    Row by_times = Row::Zero(w.size());
    for (size_t k = hold; k != release; k = (k + 1) % s.items.size()) {
      left += pass.u(pass.problem.time_at(k));
      if (pass.derived()) by_times(pass.problem.time_at(k) + 1) = 1.0;
    }
    const double unit = f(0) * left * left, part = w(0) / unit;
    Row row = w / unit - part * (f / f(0) + 2.0 * by_times / left);
    row(0) = part - c.value;
    if (pass.derived()) row(1) -= c.slope;
    return row;
  }
};

}  // namespace

Coefficient border_constant(const Coefficient &ratio) {
  // With e the part of s that the next flight takes, the gap c f s^2 tau - f s tau^2 / 2 + f tau^3
  // / 6 is zero at tau = e s, and r times the speed there is c f (s - e s)^2.
  const double r = ratio.value;
  double e = (1.0 - r) / 2.0, slope = 1.0;
  for (int k = 0; k < 60; ++k) {
    const double g = r * (0.5 - e / 3.0) - (0.5 - e / 6.0) * (1.0 - e) * (1.0 - e);
    slope = -r / 3.0 + (1.0 - e) * (1.0 - e) / 6.0 + 2.0 * (0.5 - e / 6.0) * (1.0 - e);
    const double step = g / slope;
    e -= step;
    if (std::abs(step) < 1e-15) break;
  }
  const double by_r = -(0.5 - e / 3.0) / slope;
  return {e / 2.0 - e * e / 6.0, (0.5 - e / 3.0) * by_r * ratio.slope};
}

State start_of(const Problem &problem, const Model &model, const Sequence &s, const Vector &u,
               Eigen::Index columns) {
  const size_t n = problem.masses();
  State state{Rows::Zero(index(n), columns), Rows::Zero(index(n), columns), Row::Zero(columns),
              s.always_held, s.always_held};
  state.angle(0) = u(1);
  if (columns > 1) state.angle(2) = 1.0;
  std::vector<bool> known(n, false);
  for (size_t back = 0; back < s.items.size(); ++back) {  // item 0, then from the last on
    const Item &item = s.items[(s.items.size() - back) % s.items.size()];
    if (!hits(item.what) && !releases(item.what)) continue;
    const size_t i = model.stop(item.stop).mass;
    if (known[i]) continue;
    known[i] = true;
    state.touched[i] = item.stop;
    if (item.what == Happening::hold) state.held[i] = item.stop;
  }
  for (size_t i = 0; i < n; ++i) {
    if (state.held[i] >= 0) continue;
    state.y(index(i), 0) = u(problem.y_at(i));
    state.v(index(i), 0) = u(problem.v_at(i));
    if (columns == 1) continue;
    state.y(index(i), problem.y_at(i) + 1) = 1.0;
    state.v(index(i), problem.v_at(i) + 1) = 1.0;
  }
  return state;
}

Equations evaluate(const Problem &problem, const Sequence &s, const Vector &u,
                   const Condition *condition, bool derivatives) {
  const size_t count = s.items.size(), n = problem.masses();
  const double turn = s.periods * 2.0 * std::numbers::pi;
  Pass pass(problem, s, u, derivatives);
  Rows rows = Rows::Zero(u.size() - 1 + (condition ? 1 : 0), pass.columns);
  Row extra = Row::Zero(pass.columns);
  Border border(s, condition, pass.columns);
  for (size_t k = 0; k < count; ++k) {
    pass.fly(k);
    const Eigen::Index used = pass.columns_to(k);
    const size_t at = (k + 1) % count;
    const Item &item = s.items[at];
    auto row = rows.row(index(k)).head(used);
    const auto condition_is = [&](Extra asked) {
      return condition && condition->item == at && condition->extra == asked;
    };
    switch (item.what) {
      case Happening::start:
        row = pass.state.angle.head(used);
        row(0) -= turn;
        break;
      case Happening::impact:
      case Happening::hold:
        row = pass.quotient_of_gap(item.stop, k);
        if (condition_is(Extra::speed)) extra.head(used) = pass.gap_speed_at(item.stop, used);
        if (at == border.hold) border.w.head(used) = pass.rebound_at(item.stop, used);
        pass.apply_impact(item, used);
        if (condition_is(Extra::press)) extra.head(used) = pass.press_at(item.stop, used);
        break;
      case Happening::release:
        row = pass.press_at(item.stop, used);
        if (at == border.release) {
          const Coefficient &inverse = pass.model.inverse_mass[problem.mass_of(item)];
          const Row slope = pass.press_at(item.stop, used, 1);
          border.f.head(used) = -inverse.value * slope;
          if (used > 1) border.f(1) -= inverse.slope * slope(0);
        }
        pass.state.held[problem.mass_of(item)] = -1;
        break;
      case Happening::dip:
        row = pass.press_at(item.stop, used, 1);
        if (condition_is(Extra::contact)) extra.head(used) = pass.press_at(item.stop, used);
        break;
      case Happening::jump:
      case Happening::pause:
        row(0) = u(problem.time_at(k));
        if (used > 1) row(problem.time_at(k) + 1) = 1.0;
        if (condition_is(Extra::contact)) extra.head(used) = pass.press_at(item.stop, used);
        if (item.what == Happening::jump) pass.state.held[problem.mass_of(item)] = -1;
        break;
      case Happening::touch:
        row = pass.gap_speed_at(item.stop, used);
        if (condition_is(Extra::contact)) extra.head(used) = pass.gap_at(item.stop, used);
        break;
    }
    pass.note_contact(at);
  }
  for (size_t i = 0; i < n; ++i) {
    auto y = rows.row(index(count + i)), v = rows.row(index(count + n + i));
    y = pass.state.y.row(index(i));
    v = pass.state.v.row(index(i));
    y(0) -= u(problem.y_at(i));
    v(0) -= u(problem.v_at(i));
    if (!derivatives) continue;
    y(problem.y_at(i) + 1) -= 1.0;
    v(problem.v_at(i) + 1) -= 1.0;
  }
  auto period = rows.row(index(count + 2 * n));
  const double time = u.tail(index(count)).sum(), omega = pass.model.omega.value;
  period(0) = omega * time - turn;
  if (derivatives) {
    period(1) = pass.model.omega.slope * time;
    period.tail(index(count)).setConstant(omega);
  }
  if (condition) {
    if (condition->extra == Extra::plane) {
      extra(0) = condition->normal.dot(u) - condition->offset;
      if (derivatives) extra.tail(u.size()) = condition->normal.transpose().array();
    } else if (condition->extra == Extra::no_time) {
      extra(0) = u(problem.time_at(condition->item));
      if (derivatives) extra(problem.time_at(condition->item) + 1) = 1.0;
    } else if (condition->extra == Extra::border) {
      extra = border.equation(pass);
    }
    rows.row(rows.rows() - 1) = extra;
  }
  Equations equations{rows.col(0).matrix(), {}};
  if (derivatives) equations.jacobian = rows.rightCols(u.size()).matrix();
  return equations;
}

}  // namespace vibro_impact::branches
