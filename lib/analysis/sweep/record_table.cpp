// The one list of the columns that the table of a sweep has for its records.
#include <algorithm>
#include <cmath>
#include <string_view>
#include <tuple>

#include "simulation/for_analysis.hpp"
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
  require(masses >= 1, "masses = ", masses, ": a chain has at least one mass");
  std::vector<Column> columns;
  columns.push_back({"period", "in forcing periods; 0: none was found up to the largest",
                     [](Table &row, const OrbitRecord &record) { row.cell(record.period); }});
  columns.push_back(
      {"approached",
       "where the period is 0, that of the orbit that is still approached; 0: of none,"
       " as of an irregular motion",
       [](Table &row, const OrbitRecord &record) { row.cell(record.approached); }});
  add_per_mass(columns, masses, "sticks", "sticking phases of a mass per forcing period",
               &EventCounts::sticks);
  add_per_mass(columns, masses, "impacts", "likewise, without those of complete chatters",
               &EventCounts::impacts);
  columns.push_back({"dual_sticking", "1: two masses stick at the same time",
                     [](Table &row, const OrbitRecord &record) {
                       row.cell(record.counts.dual_sticking ? 1 : 0);
                     }});
  if (options.lyapunov) {
    columns.push_back(
        {"lyapunov",
         "greatest exponent, per time; its sign is certain above 4 errors; empty: none exists",
         [](Table &row, const OrbitRecord &record) {
           if (!record.lyapunov.exists()) return row.cell(std::string_view());
           row.cell(record.lyapunov->exponent, record.lyapunov->error);
         },
         true});
    columns.push_back({"lyapunov_error", "its standard error; inf: not known",
                       [](Table &row, const OrbitRecord &record) {
                         if (!record.lyapunov.exists()) return row.cell(std::string_view());
                         row.cell(record.lyapunov->error, record.lyapunov->error);
                       },
                       true});
  }
  if (options.attractor)
    columns.push_back({"attractor",
                       "number of the attractor among those of its scene; empty: not settled",
                       [](Table &row, const OrbitRecord &record) {
                         if (record.attractor == 0) return row.cell(std::string_view());
                         row.cell(record.attractor);
                       }});
  if (options.response)
    for (const auto &[name, meaning, member] :
         {std::tuple{"lowest", "smallest displacement of a mass", &Response::lowest},
          {"highest", "largest displacement of a mass", &Response::highest},
          {"rms", "root mean square of the displacement of a mass", &Response::rms}})
      for (std::size_t k = 0; k < static_cast<std::size_t>(masses); ++k)
        columns.push_back({name + std::to_string(k + 1), meaning,
                           [k, of = member](Table &row, const OrbitRecord &record) {
                             const Response &response = record.response[k];
                             row.cell(response.*of,
                                      3e-8 * std::max(-response.lowest, response.highest));
                           },
                           true});
  if (options.pairs)
    columns.push_back(
        {"pairs", "of events of Table I: DG, DS, DI, GS, GI, SI; -: none", add_pairs});
  return columns;
}

namespace {

// The cells of the parameters of a point.
void begin_row(Table &table, const Grid &grid, std::size_t point) {
  for (const double value : grid.values(point)) table.cell(value);
}

}  // namespace

SweepTables sweep_tables(const Grid &grid, const RecordOptions &options) {
  std::string axes, records, states;
  for (const Axis &axis : grid.axes) axes += axis.parameter + ",";
  for (const Column &column : record_columns(grid.scene.masses(), options))
    records += column.name + ",";
  for (const char *column : {"x", "v"})
    for (int mass = 1; mass <= grid.scene.masses(); ++mass)
      states += column + std::to_string(mass) + ",";
  records.pop_back();
  states.pop_back();
  return {Table(axes + records), Table(axes + "mass,velocity,stop,side,phase,impulse"),
          Table(axes + states)};
}

void add_rows(SweepTables &tables, const Grid &grid, const RecordOptions &options,
              std::size_t point, const std::optional<OrbitRecord> &record) {
  const std::vector<double> &mass = grid.scene.mass;
  if (record)
    require(
        record->counts.impacts.size() == mass.size() && record->counts.sticks.size() == mass.size(),
        "record: counts of ", record->counts.impacts.size(), " masses, the chain has ",
        mass.size());
  begin_row(tables.records, grid, point);
  for (const Column &column : record_columns(grid.scene.masses(), options))
    if (record)
      column.add_cell(tables.records, *record);
    else
      tables.records.cell(std::string_view());
  tables.records.end_row();
  if (!record) return;
  const Scene scene = grid.scene_at(point);
  for (const std::vector<Event> &of_mass : record->impacts)
    for (const Event &impact : of_mass) {
      begin_row(tables.impacts, grid, point);
      tables.impacts.row(impact.mass, impact.velocity_before, impact.stop, name(impact.side),
                         impact.instant.phase,
                         scene.mass[static_cast<std::size_t>(impact.mass - 1)] *
                             std::abs(impact.velocity_before - impact.velocity_after));
    }
  for (const std::vector<double> &state : record->section) {
    begin_row(tables.section, grid, point);
    for (const double coordinate : state) tables.section.cell(coordinate);
    tables.section.end_row();
  }
}

}  // namespace vibro_impact
