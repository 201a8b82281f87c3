// The one list of the columns that the table of a sweep has for its records.
#include <string_view>

#include "vibro_impact/analysis/sweep.hpp"

namespace vibro_impact {

namespace {

// Adds a column for each mass: the mean of a count over the forcing periods that it was taken over.
void add_per_mass(std::vector<Column> &columns, int masses, const char *name, const char *meaning,
                  std::vector<int> EventCounts::*counts) {
  for (std::size_t k = 0; k < static_cast<std::size_t>(masses); ++k)
    columns.push_back(
        {name + std::to_string(k + 1), meaning, [counts, k](Table &row, const OrbitRecord &record) {
           const EventCounts &of = record.counts;
           row.cell((of.*counts)[k] / static_cast<double>(of.periods));
         }});
}

void add_exponent(Table &row, const OrbitRecord &record) {
  if (record.lyapunov)
    row.cell(*record.lyapunov);
  else
    row.cell(std::string_view());
}

void add_pairs(Table &row, const OrbitRecord &record) {
  std::string text;
  for (const EventPair pair : record.pairs) {
    if (!text.empty()) text += ' ';
    text += abbreviation(pair);
  }
  row.cell(text.empty() ? "-" : text);
}

}  // namespace

std::vector<Column> record_columns(int masses, const RecordOptions &options) {
  std::vector<Column> columns;
  columns.push_back({"period", "in forcing periods; 0: none was found",
                     [](Table &row, const OrbitRecord &record) { row.cell(record.period); }});
  add_per_mass(columns, masses, "sticks", "sticking phases of a mass per forcing period",
               &EventCounts::sticks);
  add_per_mass(columns, masses, "impacts", "likewise, without those of complete chatters",
               &EventCounts::impacts);
  columns.push_back({"dual_sticking", "1: two masses stick at the same time",
                     [](Table &row, const OrbitRecord &record) {
                       row.cell(record.counts.dual_sticking ? 1 : 0);
                     }});
  if (options.lyapunov)
    columns.push_back(
        {"lyapunov", "greatest exponent, per time; empty: its sign is not certain", add_exponent});
  if (options.pairs)
    columns.push_back(
        {"pairs", "of events of Table I: DG, DS, DI, GS, GI, SI; -: none", add_pairs});
  return columns;
}

Table sweep_table(const Grid &grid, const RecordOptions &options) {
  std::string header;
  for (const Axis &axis : grid.axes) header += axis.parameter + ",";
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
