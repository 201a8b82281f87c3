#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <boost/crc.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>

#include "files.hpp"
#include "options.hpp"
#include "picture.hpp"
#include "progress.hpp"

namespace vibro_impact::runner {

namespace {

constexpr std::size_t points_per_thread = 32;  // of a block, so that the wait for the last is short

// A number for this very program: rows that another build of it has computed may differ.
std::string checksum_of_program() {
  std::ifstream program("/proc/self/exe", std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(program), {});
  boost::crc_32_type checksum;
  checksum.process_bytes(bytes.data(), bytes.size());
  return fmt::format("{:08x}", checksum.checksum());
}

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

// The rows of a chain in each table.
Texts rows_of_chain(const SweepRequest &request, std::size_t chain, Progress *progress,
                    int processes) {
  Table records(""), impacts(""), sections("");
  for (Table *table : {&records, &impacts, &sections}) table->text.clear();
  std::optional<OrbitRecord> record;
  const std::size_t length = chain_length(request);
  for (std::size_t row = chain * length; row < (chain + 1) * length; ++row) {
    const std::size_t point = point_of(request, row);
    record = record_at(request, point, record);
    add_row(records, request.grid, request.records, point, record);
    if (record) add_impacts(impacts, request.grid, point, *record);
    if (record) add_section(sections, request.grid, point, *record);
    if (progress != nullptr) progress->advance(processes);  // the others are as far as this one
  }
  return {records.text, impacts.text, sections.text};
}

// The journal of the rows stands beside the first table that is asked for.
std::string path_of_journal(const SweepRequest &request) {
  for (const std::string &file : request.files)
    if (!file.empty()) return file + ".partial";
  refuse("needs --table, --impacts or --section: the file that it writes");
}

void check_plot_of(const SweepRequest &request) {
  const Picture picture{"--plot", request.plot};
  const std::size_t ranges = request.grid.axes.size();
  if (ranges == 1) return check_picture(picture, "--impacts", request.files[1]);
  if (ranges > 2) refuse("--plot {}: draws one or two ranges, not {}", request.plot, ranges);
  check_picture(picture, "--table", request.files[0]);
  const auto columns = record_columns(request.grid.scene.masses(), request.records);
  if (std::none_of(columns.begin(), columns.end(),
                   [&](const Column &column) { return column.name == request.column; }))
    refuse("--column {}: is no column of the table", request.column);
}

Journal begin(const SweepRequest &request, const std::string &header) {
  const std::string path = path_of_journal(request);
  const std::vector<std::pair<std::string, std::string>> files = {{"--table", request.files[0]},
                                                                  {"--impacts", request.files[1]},
                                                                  {"--section", request.files[2]},
                                                                  {"--plot", request.plot},
                                                                  {"rows in", path}};
  for (const auto &[name, file] : files)
    if (file == "-") refuse("{} -: must be a file, beside which the rows are kept", name);
  check_files(files, request.scene_file);
  if (!request.plot.empty()) check_plot_of(request);
  const std::string head = fmt::format("vibro-impact sweep, program {},{}\n{}",
                                       checksum_of_program(), request.definition, header);
  const auto commas = std::count(header.begin(), header.end(), ',');
  const auto rule = [&](std::size_t row, const std::string &line) -> std::string {
    if (row >= number_of_rows(request)) return "the sweep has no such row";
    Table cells("");
    cells.text.clear();
    for (const double value : request.grid.values(point_of(request, row))) cells.cell(value);
    if (!line.starts_with(cells.text)) return "not the row of its point";
    return std::count(line.begin(), line.end(), ',') == commas ? "" : "not all columns";
  };
  Journal journal(path, head, request.resume, rule);
  if (isatty(STDERR_FILENO) != 0)
    fmt::print(stderr, "rows are kept in {}; --resume goes on with them\n", path);
  return journal;
}

// The number of points without a record: all cells behind their parameters are empty.
std::size_t empty_rows(const SweepRequest &request, const std::string &table) {
  const std::string empty(record_columns(request.grid.scene.masses(), request.records).size(), ',');
  std::size_t count = 0;
  for (std::size_t end = table.find('\n'); end != std::string::npos;
       end = table.find('\n', end + 1))
    count += std::string_view(table).substr(0, end).ends_with(empty) ? 1 : 0;
  return count;
}

void draw_plot(const SweepRequest &request) {
  const auto &axes = request.grid.axes;
  const std::string masses = std::to_string(request.grid.scene.masses());
  const auto absolute = [](const std::string &path) {
    return std::filesystem::absolute(path).string();
  };
  const auto text = [](double number) { return fmt::format("{:.17g}", number); };
  const auto width = [&text](const Axis &axis) {
    return text(axis.count > 1 ? std::abs(axis.value(1) - axis.from) : 1.0);
  };
  const char *direction = !request.follow             ? "none"
                          : axes[0].from < axes[0].to ? "rising"
                                                      : "falling";
  if (axes.size() == 1)
    draw({"--plot", request.plot}, "diagram",
         {absolute(request.files[1]), masses, axes[0].parameter, direction,
          text(std::min(axes[0].from, axes[0].to)), text(std::max(axes[0].from, axes[0].to))});
  else
    draw({"--plot", request.plot}, "map",
         {absolute(request.files[0]), axes[0].parameter, axes[1].parameter, request.column,
          width(axes[0]), width(axes[1])});
}

void finish(const SweepRequest &request, Journal &journal, std::size_t computed) {
  const std::size_t rows = number_of_rows(request);
  if (journal.size() != rows)
    throw std::runtime_error(fmt::format("{} rows of {} points", journal.size(), rows));
  const Grid &grid = request.grid;
  const std::array<Table, 3> headers{sweep_table(grid, request.records), impact_table(grid),
                                     section_table(grid)};
  for (std::size_t k = 0; k < headers.size(); ++k)
    if (!request.files[k].empty())
      write_text(request.head + headers[k].text + journal.rows()[k], request.files[k]);
  if (!journal.remove())
    fmt::print(stderr, "{} was changed by another program; the tables do not depend on it\n",
               path_of_journal(request));
  if (!request.plot.empty()) draw_plot(request);
  fmt::print(stderr,
             "{} points, {} computed now; {} were refused or given up, and have empty cells\n",
             rows, computed, empty_rows(request, journal.rows()[0]));
}

}  // namespace

// The chains are computed in blocks. Every process computes its share of a block, consecutive
// chains on its own threads; the rows of the shares, joined in the order of the processes, are
// those of the block.
void run_sweep(const SweepRequest &request, const Processes &processes) {
  const std::size_t length = chain_length(request), rows = number_of_rows(request);
  std::optional<Journal> journal;  // on rank 0
  if (processes.rank() == 0)
    journal.emplace(begin(request, sweep_table(request.grid, request.records).text));
  const std::size_t first =
      std::stoull(processes.joined(journal ? std::to_string(journal->size()) : ""));
  const int threads = processes.size() > 1 ? 1 : available_threads();
  const auto rank = static_cast<std::size_t>(processes.rank()),
             size = static_cast<std::size_t>(processes.size());
  const std::size_t share =
      std::max<std::size_t>(points_per_thread / length, 1) * static_cast<std::size_t>(threads);
  const std::size_t chains = rows / length;
  {
    Progress progress("sweep", static_cast<double>(rows), static_cast<double>(first));
    for (std::size_t begin = first / length; begin < chains; begin += share * size) {
      const std::size_t own = std::min(chains, begin + share * rank);
      const auto compute = [&](std::size_t k) {
        return rows_of_chain(request, own + k, journal ? &progress : nullptr, processes.size());
      };
      Texts block;
      for (const Texts &of_chain : sweep(std::min(chains - own, share), compute, threads))
        for (std::size_t k = 0; k < block.size(); ++k) block[k] += of_chain[k];
      for (std::string &text : block) text = processes.joined(text);
      if (journal) journal->add(block);
    }
  }
  if (journal) finish(request, *journal, rows - first);
}

}  // namespace vibro_impact::runner
