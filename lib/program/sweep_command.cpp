#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "journal.hpp"
#include "options.hpp"
#include "picture.hpp"
#include "progress.hpp"
#include "scene_text.hpp"

namespace vibro_impact::runner {

namespace {

// The rows of a sweep form chains. Each point of a chain but the first starts where the motion of
// the point before has settled. A sweep that follows no branch has chains of one point.
std::size_t chain_length(const SweepRequest &request) {
  if (!request.follow) return 1;
  return request.grid.axes.back().count * (request.back ? 2 : 1);
}

std::size_t number_of_rows(const SweepRequest &request) {
  return request.grid.points() * (request.back ? 2 : 1);
}

// The point of a row. A chain that goes back has the points of its range once more, from the last.
std::size_t point_of(const SweepRequest &request, std::size_t row) {
  if (!request.back) return row;
  const std::size_t count = request.grid.axes.back().count, k = row % (2 * count);
  return row / (2 * count) * count + (k < count ? k : 2 * count - 1 - k);
}

// Sends the records of the rows of a chain.
void compute_chain(const SweepRequest &request, std::size_t chain, const Processes::Take &send) {
  PointRecord result;
  const std::size_t length = chain_length(request);
  for (std::size_t row = chain * length; row < (chain + 1) * length; ++row) {
    const std::size_t point = point_of(request, row);
    result = point_record(request.grid.scene_at(point), request.records, result.record);
    SweepTables rows;
    add_rows(rows, request.grid, request.records, point, result.record);
    send(journal_line(row,
                      {rows.records.text, rows.impacts.text, rows.section.text, result.reason}));
  }
}

// The rows are kept beside the first table that is asked for.
Output journal_of(const SweepRequest &request) {
  const auto first = std::ranges::find_if(request.tables, &Output::wanted);
  if (first == request.tables.end())
    refuse("needs --table, --impacts or --section: the file that it writes");
  return {"rows in", first->path + ".partial"};
}

// The table that the picture is drawn from.
std::size_t table_of_plot(const SweepRequest &request) {
  if (request.grid.axes.size() > 1 || !request.column.empty()) return 0;
  return request.tables[2].wanted() && !request.tables[1].wanted() ? 2 : 1;
}

void check_outputs_of(const SweepRequest &request) {
  std::vector<Output> outputs(request.tables.begin(), request.tables.end());
  outputs.insert(outputs.end(), {request.plot, journal_of(request)});
  for (const Output &output : outputs)
    if (output.path == "-")
      refuse("{}: must be a file, beside which the rows are kept", output.given());
  check_outputs(outputs, request.scene_file);
  if (!request.plot.wanted()) return;
  const std::size_t ranges = request.grid.axes.size();
  if (ranges > 2) refuse("{}: draws one or two ranges, not {}", request.plot.given(), ranges);
  check_picture(request.plot, request.tables[table_of_plot(request)]);
  const auto columns = record_columns(request.grid.scene.masses(), request.records);
  if (request.column.empty()) return;
  if (std::ranges::find(columns, request.column, &Column::name) == columns.end())
    refuse("--column {}: is no column of the table", request.column);
  if (request.column == "pairs") refuse("--column pairs: has words, which cannot be drawn");
}

// The journal names this very program: rows that another build of it has computed may differ.
Journal begin(const SweepRequest &request) {
  check_outputs_of(request);
  const std::string path = journal_of(request).path;
  std::string head = fmt::format("vibro-impact sweep, program {:08x}, with",
                                 checksum_of(contents("/proc/self/exe")));
  for (const Output &table : request.tables)
    if (table.wanted()) head += " " + table.option;
  Journal journal(path, head + "\n" + request.definition, number_of_rows(request), request.resume);
  if (isatty(STDERR_FILENO) != 0)
    fmt::print(stderr, "rows are kept in {}; --resume goes on with them\n", path);
  return journal;
}

// An axis in words for gnuplot. A range of one value gets a width, too. The boxes of a map overlap
// by a fiftieth.
std::string words_of(const Axis &axis) {
  const bool logarithmic = axis.logarithmic && axis.from > 0.0 && axis.count > 1;
  double half = axis.from != 0.0 ? std::abs(axis.from) / 2.0 : 0.5;
  if (axis.count > 1) half = 0.51 * std::abs(axis.value(1) - axis.from);
  if (logarithmic) half = std::exp(0.51 * std::abs(std::log(axis.value(1) / axis.from)));
  return fmt::format("{} {} {} {} {}", axis.parameter, axis.from, axis.to, half,
                     logarithmic ? "logarithmic" : "linear");
}

void draw_plot(const SweepRequest &request) {
  const auto &axes = request.grid.axes;
  const std::size_t table = table_of_plot(request);
  if (axes.size() == 2)
    return draw(request.plot, "map", request.column.empty() ? "period" : request.column,
                {request.tables[0]}, {words_of(axes[0]), words_of(axes[1])});
  std::string content = request.column;
  if (table > 0)
    content = fmt::format("{}{}", table == 2 ? "x" : "",
                          fmt::join(request.panels, table == 2 ? " x" : " "));
  draw(request.plot, table == 1 ? "diagram" : "columns", content, {request.tables[table]},
       {request.follow ? "branches" : "points", words_of(axes[0])});
}

// The rows of the points without a record, by the kind of the reason: those of one kind differ in
// numbers only.
using MissingRows = std::map<std::string, std::vector<std::size_t>>;

// The values of the point of a row, "omega = 0.3, beta = 0.1".
std::string values_of(const SweepRequest &request, std::size_t row) {
  std::string words;
  const std::vector<double> values = request.grid.values(point_of(request, row));
  for (std::size_t axis = 0; axis < values.size(); ++axis)
    words += fmt::format("{}{} = {}", axis == 0 ? "" : ", ", request.grid.axes[axis].parameter,
                         values[axis]);
  return words;
}

// Writes the tables, and returns the points without a record.
MissingRows write_tables(const SweepRequest &request, const Journal &journal) {
  const auto [records, impacts, section] = sweep_tables(request.grid, request.records);
  const std::string headers[] = {records.text, impacts.text, section.text};
  const std::size_t rows = number_of_rows(request);
  std::array<Table, 3> tables;
  for (std::size_t k = 0; k < tables.size(); ++k) tables[k].text = request.head + headers[k];
  MissingRows missing;
  for (std::size_t row = 0; row < rows; ++row) {
    const Texts texts = journal.texts_of(row);
    for (std::size_t k = 0; k < tables.size(); ++k)
      if (request.tables[k].wanted()) tables[k].text += texts[k];
    if (!texts[3].empty()) missing[kind_of_reason(texts[3])].push_back(row);
  }
  for (std::size_t k = 0; k < tables.size(); ++k)
    if (request.tables[k].wanted()) write(tables[k], request.tables[k].path);
  return missing;
}

void finish(const SweepRequest &request, const Journal &journal, std::size_t computed) {
  const MissingRows missing = write_tables(request, journal);
  journal.remove();
  try {
    if (request.plot.wanted()) draw_plot(request);
  } catch (const std::runtime_error &failure) {
    throw std::runtime_error(fmt::format("{}; the tables are complete", failure.what()));
  }
  std::size_t without_record = 0;
  for (const auto &[kind, of_kind] : missing) without_record += of_kind.size();
  fmt::print(stderr, "{} points, {} computed now; {} were refused or given up, and have {}\n",
             number_of_rows(request), computed, without_record,
             request.tables[0].wanted() ? "empty cells" : "no rows");
  for (const auto &[kind, of_kind] : missing)
    fmt::print(stderr, "{} of {} points: {}; first at {}\n", of_kind.size(),
               number_of_rows(request), journal.texts_of(of_kind.front())[3],
               values_of(request, of_kind.front()));
  if (without_record == number_of_rows(request))
    throw std::runtime_error("every point of the sweep was refused or given up");
}

// The chains of which the journal does not have all rows.
std::vector<std::size_t> chains_to_do(const SweepRequest &request, const Journal &journal) {
  const std::size_t length = chain_length(request);
  std::vector<std::size_t> chains;
  for (std::size_t row = 0; row < number_of_rows(request); ++row)
    if (!journal.has(row) && (chains.empty() || chains.back() != row / length))
      chains.push_back(row / length);
  return chains;
}

}  // namespace

// Rank 0 keeps the rows of all processes in the journal, in any order, and makes the tables of it.
void run_sweep(const SweepRequest &request, const Processes &processes) {
  std::optional<Journal> journal;  // on rank 0
  if (processes.rank() == 0) journal.emplace(begin(request));
  const std::vector<std::size_t> chains =
      processes.from_rank_0(journal ? chains_to_do(request, *journal) : std::vector<std::size_t>());
  const std::size_t rows = number_of_rows(request),
                    computed = chains.size() * chain_length(request);
  {
    Progress progress("sweep", static_cast<double>(rows), static_cast<double>(rows - computed));
    const auto compute = [&](std::size_t k, const Processes::Take &send) {
      compute_chain(request, chains[k], send);
    };
    const auto keep = [&](const std::string &line) {
      journal->add(line);
      progress.advance();
    };
    processes.share_out(chains.size(), compute, keep);
  }
  if (journal) finish(request, *journal, computed);
}

}  // namespace vibro_impact::runner
