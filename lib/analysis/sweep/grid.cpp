#include <cmath>
#include <string_view>
#include <utility>

#include "simulation/for_analysis.hpp"
#include "vibro_impact/analysis/sweep.hpp"

namespace vibro_impact {

namespace {

constexpr std::size_t most_points = std::size_t{1} << 53;  // exact as a double, too

}  // namespace

double Axis::value(std::size_t k) const {
  require(k < count, "value ", k, " of ", name(parameter), ": there are ", count);
  if (count < 2) return from;
  return std::lerp(from, to, static_cast<double>(k) / static_cast<double>(count - 1));
}

std::size_t Grid::points() const {
  std::size_t product = 1;
  for (const Axis &axis : axes) {
    require(axis.count >= 1, name(axis.parameter), ": ", axis.count,
            " values; there must be at least 1");
    require(product <= most_points / axis.count, name(axis.parameter), ": ", axis.count,
            " values: more points than can be counted");
    product *= axis.count;
  }
  return product;
}

std::vector<double> Grid::values(std::size_t point) const {
  require(point < points(), "point ", point, ": the grid has ", points());
  std::vector<double> found(axes.size());
  for (std::size_t k = axes.size(); k-- > 0; point /= axes[k].count)
    found[k] = axes[k].value(point % axes[k].count);
  return found;
}

Scene Grid::scene_at(std::size_t point) const {
  Scene at = scene;
  const std::vector<double> there = values(point);
  for (std::size_t k = 0; k < axes.size(); ++k)
    at = with(std::move(at), axes[k].parameter, there[k]);
  return at;
}

void check(const Grid &grid) {
  grid.points();
  for (std::size_t k = 0; k < grid.axes.size(); ++k) {
    const Axis &axis = grid.axes[k];
    const std::string what = name(axis.parameter);
    get(grid.scene, axis.parameter);
    require(std::isfinite(axis.from) && std::isfinite(axis.to), what, " from ", axis.from, " to ",
            axis.to, ": must be finite");
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
      const std::size_t end = (corner >> k) % 2 == 0 ? 0 : axis.count - 1;
      scene = with(std::move(scene), axis.parameter, axis.value(end));
    }
    check(scene);
    require(scene.omega > 0.0, "omega = ", scene.omega, ": a sweep needs a forcing period");
  }
}

namespace {

// "DS SI", "-" for none, of the sum of row_of.
std::string listed(double sum) {
  require(sum >= 0.0 && sum < std::exp2(all_event_pairs.size()), "pairs = ", sum,
          ": must be a sum of 2^k for pairs of events");
  std::string text;
  for (std::size_t k = 0; k < all_event_pairs.size(); ++k)
    if (static_cast<unsigned>(sum) >> k & 1) {
      if (!text.empty()) text += ' ';
      text += abbreviation(all_event_pairs[k]);
    }
  return text.empty() ? "-" : text;
}

}  // namespace

std::vector<double> row_of(const OrbitRecord &record, const RecordOptions &records) {
  const EventCounts &counts = record.counts;
  std::vector<double> row{static_cast<double>(record.period)};
  for (const auto *what : {&counts.sticks, &counts.impacts})
    for (const int count : *what) row.push_back(count / static_cast<double>(counts.periods));
  row.push_back(counts.dual_sticking ? 1.0 : 0.0);
  if (records.lyapunov) row.push_back(record.lyapunov.value_or(NAN));
  double pairs = 0.0;
  for (const EventPair pair : record.pairs) pairs += std::exp2(static_cast<int>(pair));
  if (records.pairs) row.push_back(pairs);
  return row;
}

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
             std::span<const double> row) {
  const std::size_t wanted = 2 * grid.scene.mass.size() + 2 + records.lyapunov + records.pairs;
  require(row.empty() || row.size() == wanted, "a row of ", row.size(), " numbers: the table has ",
          wanted, " columns beside the parameters");
  for (const double value : grid.values(point)) table.cell(value);
  for (std::size_t k = 0; k < wanted; ++k)
    if (row.empty() || std::isnan(row[k]))
      table.cell(std::string_view());
    else if (records.pairs && k + 1 == wanted)
      table.cell(listed(row[k]));
    else
      table.cell(row[k]);
  table.end_row();
}

}  // namespace vibro_impact
