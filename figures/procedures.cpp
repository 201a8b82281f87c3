// Could the author's procedure explain the statements of the paper that differ from ours? By
// procedure: the windows of Figure 3, sticking above 0.5, Figures 4 and 5(c). Then the settled
// motions from random starts, dual sticking against the position of the second stop, and the last
// impacts of Figure 5(c).
#include "measures/procedures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <random>
#include <string>

#include "driver.hpp"
#include "measures/runs.hpp"

namespace {

using namespace vibro_impact;
using figures::Procedure;

// --- The windows of Figure 3 in which no chatter of mass 1 is complete ------------------------

// A row for each run of frequencies of a grid that `wanted` is true for, under a name and a number.
// They have three decimals.
void add_runs(Table &table, const std::string &name, int number, const Grid &grid,
              const std::function<bool(std::size_t)> &wanted) {
  const auto shown = [&](std::size_t i) { return fmt::format("{:.3f}", grid.values(i).front()); };
  for (const auto &[first, last] : figures::runs_where(wanted, grid.points()))
    table.row(name, number, shown(first), shown(last));
}

// A procedure at a forcing period, and the periods after which and in which its sticking phases are
// counted.
struct Row {
  std::string name;
  std::function<Procedure(double period)> procedure;
  int settling, counted;
};

std::vector<Row> rows() {
  const auto always = [](const Procedure &procedure) { return [=](double) { return procedure; }; };
  const auto parts = [](double count, int cut_off = 10) {
    return [=](double period) { return figures::in_steps(period / count, cut_off); };
  };
  return {{"exact motion", always({}), 60, 40},
          {"period 1 alone", always({}), 0, 1},
          {"held after flight < 0.1", always({.shortest_flight = 0.1}), 60, 10},
          {"held after impact < 0.001", always({.slowest_impact = 0.001}), 60, 10},
          {"held after impact < 1e-9 (F ≥ 0)",
           always({.slowest_impact = 1e-9, .holds_without_force = true}), 60, 10},
          {"Eq. 24 as printed", always({.printed_equation24 = true}), 60, 20},
          {"steps of T/1000", parts(1000.0), 30, 10},
          {"steps of T/1914 (cut-off 5)", parts(1914.0, 5), 30, 10},
          {"steps of 0.025", always(figures::in_steps(0.025)), 30, 10},
          {"steps of T/50000", parts(50000.0), 30, 10}};
}

// How often mass 1 comes to stick in the counted periods of the motion from rest.
std::ptrdiff_t sticks(const Scene &scene, const Row &row, int settling) {
  const double period = Clock(scene.omega).period, from = settling * period;
  const auto events =
      figures::follow(scene, start_of(scene), from + row.counted * period, row.procedure(period))
          .events;
  return std::ranges::count_if(events, [from](const Event &event) {
    return event.kind == EventKind::stick && event.mass == 1 && event.time > from;
  });
}

// The runs without sticking of mass 1, by procedure.
Table windows() {
  const Grid frequencies{paper::figure3(0.28), {{"omega", 0.28, 0.42, 141}}};
  Table table("procedure,number,from,to");
  int number = 0;
  for (const Row &row : rows()) {
    const auto complete =
        sweep(frequencies, [&](const Scene &scene) { return sticks(scene, row, row.settling); });
    const auto none = [&](std::size_t i) { return complete[i] == 0; };
    add_runs(table, row.name, ++number, frequencies, none);
  }
  return table;
}

// The frequencies at which mass 1 sticks after 100 periods, among so many from 0.5 to 0.7, as runs.
Table sticking_above_one_half(const std::vector<Row> &procedures, std::size_t values) {
  const Grid above{paper::figure3(0.5), {{"omega", 0.5, 0.7, values}}};
  Table table("procedure,number,from,to");
  int number = 0;
  for (const Row &row : procedures) {
    const int settling = row.settling == 0 ? 0 : 100;
    const auto sticking =
        sweep(above, [&](const Scene &scene) { return sticks(scene, row, settling); });
    add_runs(table, row.name, ++number, above, [&](std::size_t i) { return sticking[i] > 0; });
  }
  return table;
}

// --- Figures 4 and 5(c) -----------------------------------------------------------------------

// Whether mass 2 comes to stick before mass 1 is released in the fourth forcing period, the window
// of Figure 5(c), at this frequency and restitution.
bool mass_2_sticks(double omega, double restitution, const Row &row) {
  Scene scene = paper::figure5c();
  scene.omega = omega;
  scene.restitution = restitution;
  const double period = Clock(omega).period;
  bool sticks = false;
  for (const Event &event :
       figures::follow(scene, start_of(scene), 3.5 * period, row.procedure(period)).events) {
    if (event.time < 2.5 * period) continue;
    if (event.mass == 1 && event.kind == EventKind::release) break;
    if (event.mass == 2 && event.kind == EventKind::stick) sticks = true;
  }
  return sticks;
}

// Sticking phases of mass 1 a period at the frequencies of Figures 4(a) and 4(b), and whether mass
// 2 sticks in Figure 5(c), at a lower frequency and at a lower restitution.
Table other_figures() {
  const std::vector<Row> all = rows();
  Table table("procedure,figure4a,figure4b,figure5c,lower_omega,lower_r");
  for (const Row &row : all) {
    const auto a_period = [&](const Scene &scene) {
      return static_cast<double>(sticks(scene, row, row.settling)) / row.counted;
    };
    table.row(row.name, a_period(paper::figure4a()), a_period(paper::figure4b()),
              int{mass_2_sticks(0.02, 0.7, row)}, int{mass_2_sticks(0.01, 0.7, row)},
              int{mass_2_sticks(0.02, 0.3, row)});
  }
  return table;
}

// --- Random starts ----------------------------------------------------------------------------

// Displacements within 1 of the stop, speeds up to 0.5, the phase zero.
std::vector<MotionState> random_starts(const Scene &scene, std::size_t count) {
  std::mt19937_64 generator(0);
  const auto number = [&generator] { return static_cast<double>(generator() >> 11) * 0x1p-53; };
  std::vector<MotionState> starts(count, start_of(scene));
  for (MotionState &start : starts)
    for (std::size_t i = 0; i < 2; ++i) {
      start.displacement[i] = scene.stops[i].position - sign(scene.stops[i].side) * number();
      start.velocity[i] = number() - 0.5;
    }
  return starts;
}

// A row: of so many random starts, how many different motions settle, how many starts do not settle
// in 400 periods, and in how many motions mass 1 sticks.
void add_starts(Table &table, double omega, std::size_t count) {
  const Scene scene = paper::figure3(omega);
  const auto starts = random_starts(scene, count);
  const auto records =
      sweep(count, [&](std::size_t k) { return record_of(scene, starts[k], {.attractor = true}); });
  std::vector<OrbitRecord> attractors;
  std::size_t sticking = 0, unsettled = 0;
  for (const OrbitRecord &record : records) {
    sticking += record.counts.sticks[0] > 0;
    unsettled += record.period == 0;
    if (record.period > 0 && std::ranges::none_of(attractors, [&](const OrbitRecord &attractor) {
          return same_attractor(scene, attractor, record);
        }))
      attractors.push_back(record);
  }
  table.row(omega, count, attractors.size(), unsettled, sticking);
}

Table starts() {
  Table table("omega,starts,settled_motions,unsettled_starts,starts_with_sticking_of_mass_1");
  for (int hundredth = 25; hundredth <= 46; ++hundredth) add_starts(table, 0.01 * hundredth, 20);
  for (const double omega : {0.62, 0.645, 0.65, 0.655, 0.66, 0.665, 0.67})
    add_starts(table, omega, 60);
  return table;
}

// --- Figure 5 ---------------------------------------------------------------------------------

// Dual sticks per forcing period in the scenes of Figure 5, with the second stop at places from 0
// to 0.5. They are counted up to t = 1000, without the first third of the forcing periods.
Table dual_sticking() {
  const auto rows = sweep(101, [](std::size_t i) {
    std::vector<double> row{0.005 * static_cast<double>(i)};
    for (Scene scene : {paper::figure5a(), paper::figure5b(), paper::figure5c()}) {
      scene.stops[1].position = row.front();
      const double period = Clock(scene.omega).period, last = std::floor(1000.0 / period),
                   first = std::floor(last / 3.0);
      row.push_back(figures::dual_sticks(scene, first * period, last * period) / (last - first));
    }
    return row;
  });
  Table table("s2,a,b,c");
  for (const auto &row : rows) table.row(row[0], row[1], row[2], row[3]);
  return table;
}

// Figure 5(c), and its motion with a lower Omega or r: when mass 1 is released, and the speed of
// the last impact of mass 2 before that.
Table last_impacts() {
  Table table("omega,r,release,speed");
  const auto add = [&table](double omega, double restitution) {
    Scene scene = paper::figure5c();
    scene.omega = omega;
    scene.restitution = restitution;
    const double period = Clock(omega).period;
    double speed = NAN;
    for (const Event &event : figures::events_of(scene, 2.5 * period, 3.5 * period)) {
      if (event.mass == 2 && event.kind == EventKind::impact) speed = event.velocity_before;
      if (event.mass != 1 || event.kind != EventKind::release) continue;
      table.row(omega, restitution, event.time, speed);
      break;
    }
  };
  add(0.02, 0.7);
  add(0.01, 0.7);
  add(0.02, 0.3);
  return table;
}

void draw(const std::filesystem::path &output) {
  write(windows(), output / "procedures_windows.csv");
  write(sticking_above_one_half(rows(), 21), output / "procedures_sticking.csv");
  write(sticking_above_one_half({rows().front()}, 201), output / "procedures_sticking_exact.csv");
  write(other_figures(), output / "procedures_figures.csv");
  write(starts(), output / "procedures_starts.csv");
  write(dual_sticking(), output / "procedures_dual.csv");
  write(last_impacts(), output / "procedures_figure5c.csv");
}

}  // namespace

int main(int argc, char **argv) {
  return figures::main_of_driver(argc, argv,
                                 "What the author's procedure may have made of the motion", draw);
}
