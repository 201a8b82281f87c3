// The one list of the columns that the table of a sweep has for its records.
#include <string_view>
#include <utility>

#include "vibro_impact/analysis/sweep.hpp"

namespace vibro_impact {

namespace {

using Counts = std::vector<int> EventCounts::*;

// The mean of a count of one mass over the forcing periods that it was counted over.
auto per_period(Counts counts, int mass) {
  return [counts, mass](Table &table, const OrbitRecord &record) {
    const int count = (record.counts.*counts)[static_cast<std::size_t>(mass - 1)];
    table.cell(count / static_cast<double>(record.counts.periods));
  };
}

void add_dual_sticking(Table &table, const OrbitRecord &record) {
  table.cell(record.counts.dual_sticking ? 1 : 0);
}

void add_exponent(Table &table, const OrbitRecord &record) {
  if (record.lyapunov)
    table.cell(*record.lyapunov);
  else
    table.cell(std::string_view());
}

void add_pairs(Table &table, const OrbitRecord &record) {
  std::string text;
  for (const EventPair pair : record.pairs) {
    if (!text.empty()) text += ' ';
    text += abbreviation(pair);
  }
  table.cell(text.empty() ? "-" : text);
}

}  // namespace

std::vector<Column> record_columns(int masses, const RecordOptions &options) {
  std::vector<Column> columns{
      {"period", "in forcing periods; 0: none was found",
       [](Table &table, const OrbitRecord &record) { table.cell(record.period); }}};
  for (int mass = 1; mass <= masses; ++mass) {
    const std::string number = std::to_string(mass);
    columns.push_back({"sticks" + number,
                       "sticking phases of mass " + number + " per forcing period",
                       per_period(&EventCounts::sticks, mass)});
  }
  for (int mass = 1; mass <= masses; ++mass) {
    const std::string number = std::to_string(mass);
    columns.push_back({"impacts" + number,
                       "its impacts per forcing period, but for those of complete chatters, which "
                       "are infinitely many",
                       per_period(&EventCounts::impacts, mass)});
  }
  columns.push_back({"dual_sticking", "1: two masses stick at the same time", add_dual_sticking});
  if (options.lyapunov)
    columns.push_back({"lyapunov",
                       "greatest Lyapunov exponent, per unit of time; empty: its sign is not "
                       "certain",
                       add_exponent});
  if (options.pairs)
    columns.push_back(
        {"pairs", "pairs of events of Table I: DG, DS, DI, GS, GI, SI; -: none", add_pairs});
  return columns;
}

Table sweep_table(const Grid &grid, const RecordOptions &options) {
  std::string header;
  for (const Axis &axis : grid.axes) header += name(axis.parameter) + ",";
  for (const Column &column : record_columns(grid.scene.masses(), options))
    header += column.name + ",";
  header.pop_back();
  return Table(header);
}

void add_row(Table &table, const Grid &grid, const RecordOptions &options, std::size_t point,
             const std::optional<OrbitRecord> &record) {
  for (const double value : grid.values(point)) table.cell(value);
  for (const Column &column : record_columns(grid.scene.masses(), options))
    if (record)
      column.add_cell(table, *record);
    else
      table.cell(std::string_view());
  table.end_row();
}

}  // namespace vibro_impact
