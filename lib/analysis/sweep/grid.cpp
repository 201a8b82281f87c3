#include <cmath>
#include <string_view>

#include "simulation/for_analysis.hpp"
#include "vibro_impact/analysis/sweep.hpp"

namespace vibro_impact {

double Axis::value(std::size_t k) const {
  if (count < 2) return from;
  return std::lerp(from, to, static_cast<double>(k) / static_cast<double>(count - 1));
}

std::size_t Grid::points() const {
  std::size_t product = 1;
  for (const Axis &axis : axes) product *= axis.count;
  return product;
}

std::vector<double> Grid::values(std::size_t point) const {
  std::vector<double> found(axes.size());
  for (std::size_t k = axes.size(); k-- > 0; point /= axes[k].count)
    found[k] = axes[k].value(point % axes[k].count);
  return found;
}

Scene Grid::scene_at(std::size_t point) const {
  Scene at = scene;
  const std::vector<double> there = values(point);
  for (std::size_t k = 0; k < axes.size(); ++k) value_of(at, axes[k].parameter) = there[k];
  return at;
}

void check(const Grid &grid) {
  std::size_t points = 1;
  for (std::size_t k = 0; k < grid.axes.size(); ++k) {
    const Axis &axis = grid.axes[k];
    const std::string what = name(axis.parameter);
    get(grid.scene, axis.parameter);
    require(axis.count >= 1, what, ": ", axis.count, " values; there must be at least 1");
    require(std::isfinite(axis.from) && std::isfinite(axis.to), what, " from ", axis.from, " to ",
            axis.to, ": must be finite");
    require(points <= (std::size_t{1} << 53) / axis.count, what, ": ", axis.count,
            " values: more points than can be counted");
    points *= axis.count;
    for (std::size_t j = 0; j < k; ++j)
      require(!(grid.axes[j].parameter == axis.parameter), what, ": given twice");
  }
  // What a scene must fulfil are bounds that are linear in its scalars: if they hold in the corners
  // of the grid, they hold everywhere.
  require(grid.axes.size() < 20, grid.axes.size(), " axes: at most 19");
  for (std::size_t corner = 0; corner < std::size_t{1} << grid.axes.size(); ++corner) {
    Scene scene = grid.scene;
    for (std::size_t k = 0; k < grid.axes.size(); ++k) {
      const Axis &axis = grid.axes[k];
      value_of(scene, axis.parameter) = axis.value((corner >> k) % 2 == 0 ? 0 : axis.count - 1);
    }
    check(scene);
    require(scene.omega > 0.0, "omega = ", scene.omega, ": a sweep needs a forcing period");
  }
}

namespace {

// "DS SI", "-" for none.
std::string listed(const std::vector<EventPair> &pairs) {
  if (pairs.empty()) return "-";
  std::string text;
  for (const EventPair pair : pairs) {
    if (!text.empty()) text += ' ';
    text += abbreviation(pair);
  }
  return text;
}

}  // namespace

Table sweep_table(const Grid &grid, const RecordOptions &records) {
  std::string header;
  for (const Axis &axis : grid.axes) header += name(axis.parameter) + ",";
  header += "period";
  for (const char *what : {",sticks", ",impacts"})
    for (int i = 1; i <= grid.scene.masses(); ++i) header += what + std::to_string(i);
  header += ",dual_sticking";
  if (records.lyapunov) header += ",lyapunov";
  return Table(records.pairs ? header + ",pairs" : header);
}

void add_row(Table &table, const Grid &grid, const RecordOptions &records, std::size_t point,
             const OrbitRecord &record) {
  for (const double value : grid.values(point)) table.cell(value);
  const EventCounts &counts = record.counts;
  if (counts.periods == 0) {
    const int empty = 2 * grid.scene.masses() + 2 + records.lyapunov + records.pairs;
    for (int k = 0; k < empty; ++k) table.cell(std::string_view());
    return table.end_row();
  }
  table.cell(record.period);
  for (const auto *what : {&counts.sticks, &counts.impacts})
    for (const int count : *what) table.cell(count / static_cast<double>(counts.periods));
  table.cell(counts.dual_sticking ? 1 : 0);
  if (records.lyapunov) table.cell(record.lyapunov.value_or(NAN));
  if (records.pairs) table.cell(listed(record.pairs));
  table.end_row();
}

}  // namespace vibro_impact
