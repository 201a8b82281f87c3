#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>

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

// The record of a point, or nullopt where its scene is refused or its run given up: the sweep goes
// on with the others. What makes no sense at any point has been refused before the sweep began.
std::optional<OrbitRecord> record_at(const SweepRequest &request, std::size_t point,
                                     const std::optional<OrbitRecord> &before) {
  try {
    const Scene scene = request.grid.scene_at(point);
    if (!before) return record_of(scene, request.records);
    return record_of(scene, start_near(scene, before->state), request.records);
  } catch (const std::invalid_argument &) {
    return std::nullopt;
  } catch (const std::runtime_error &) {
    return std::nullopt;
  }
}

// Sends the records of the rows of a chain.
void compute_chain(const SweepRequest &request, std::size_t chain, const Processes::Take &send) {
  std::optional<OrbitRecord> record;
  const std::size_t length = chain_length(request);
  for (std::size_t row = chain * length; row < (chain + 1) * length; ++row) {
    Table records, impacts, sections;
    const std::size_t point = point_of(request, row);
    record = record_at(request, point, record);
    add_row(records, request.grid, request.records, point, record);
    if (record) add_impacts(impacts, request.grid, point, *record);
    if (record) add_section(sections, request.grid, point, *record);
    send(journal_record(row, {records.text, impacts.text, sections.text}));
  }
}

// The rows are kept beside the first table that is asked for.
Output journal_of(const SweepRequest &request) {
  const auto first = std::ranges::find_if(request.tables, &Output::wanted);
  if (first == request.tables.end())
    refuse("needs --table, --impacts or --section: the file that it writes");
  return {"rows in", first->path + ".partial"};
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
  check_picture(request.plot, request.tables[ranges == 1 ? 1 : 0]);
  if (ranges == 1 && request.panels.empty())
    refuse("{}: no mass has a stop that it could hit", request.plot.given());
  const auto columns = record_columns(request.grid.scene.masses(), request.records);
  if (ranges == 2 && std::ranges::find(columns, request.column, &Column::name) == columns.end())
    refuse("--column {}: is no column of the table", request.column);
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

// An axis in words for gnuplot. A range of one value gets a width, too.
std::string words_of(const Axis &axis) {
  const double width = axis.count > 1 ? axis.value(1) - axis.from : axis.from;
  return fmt::format("{} {} {} {}", axis.parameter, axis.from, axis.to,
                     width != 0.0 ? std::abs(width) / 2.0 : 0.5);
}

void draw_plot(const SweepRequest &request) {
  const auto &axes = request.grid.axes;
  if (axes.size() == 2)
    return draw(request.plot, "map", request.column, {request.tables[0]},
                {words_of(axes[0]), words_of(axes[1])});
  draw(request.plot, "diagram", fmt::format("{}", fmt::join(request.panels, " ")),
       {request.tables[1]}, {request.follow ? "branches" : "points", words_of(axes[0])});
}

void finish(const SweepRequest &request, Journal &journal, std::size_t computed) {
  const Table headers[] = {sweep_table(request.grid, request.records), impact_table(request.grid),
                           section_table(request.grid)};
  // All cells of a point without a record are empty behind its parameters.
  const std::string empty(record_columns(request.grid.scene.masses(), request.records).size(), ',');
  std::size_t without_record = 0;
  for (std::size_t k = 0; k < request.tables.size(); ++k) {
    if (!request.tables[k].wanted()) continue;
    without_record = 0;
    const auto give = [&](const Add &add) {
      add(request.head + headers[k].text);
      journal.read([&](const Texts &texts) {
        add(texts[k]);
        without_record += texts[0].ends_with(empty + '\n');
      });
    };
    write_pieces(give, request.tables[k].path);
  }
  if (!journal.remove())
    fmt::print(stderr, "{} was changed by another program; the tables do not depend on it\n",
               journal_of(request).path);
  if (request.plot.wanted()) draw_plot(request);
  fmt::print(stderr,
             "{} points, {} computed now; {} were refused or given up, and have empty cells\n",
             number_of_rows(request), computed, without_record);
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
    const auto keep = [&](const std::string &record) {
      journal->add(record);
      progress.advance();
    };
    processes.share_out(chains.size(), compute, keep);
  }
  if (journal) finish(request, *journal, computed);
}

}  // namespace vibro_impact::runner
