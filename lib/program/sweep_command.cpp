#include <fmt/format.h>

#include <algorithm>
#include <boost/crc.hpp>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>

#include "files.hpp"
#include "options.hpp"
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

PartialTable begin(const SweepRequest &request, const std::string &header) {
  if (request.table == "-") refuse("--table -: must be a file, beside which the rows are kept");
  check_files({{"--table", request.table}});
  const std::string definition =
      fmt::format("vibro-impact sweep, program {},{}", checksum_of_program(), request.definition);
  return PartialTable(request.table + ".partial", definition, header, request.resume);
}

// The record of a point, or nullopt where its scene is refused or its run given up: the sweep goes
// on with the others. What makes no sense at any point has been refused before the sweep began.
std::optional<OrbitRecord> record_at(const SweepRequest &request, std::size_t point) {
  try {
    return record_of(request.grid.scene_at(point), request.records);
  } catch (const std::invalid_argument &) {
    return std::nullopt;
  } catch (const std::runtime_error &) {
    return std::nullopt;
  }
}

// The number of points without a record: all cells behind their parameters are empty.
std::size_t empty_rows(const SweepRequest &request, const std::string &table) {
  const std::string empty(record_columns(request.grid.scene.masses(), request.records).size(), ',');
  std::istringstream rows(table);
  std::size_t count = 0;
  for (std::string row; std::getline(rows, row);) count += row.ends_with(empty) ? 1 : 0;
  return count;
}

void finish(const SweepRequest &request, PartialTable &partial, std::size_t computed) {
  Table table = sweep_table(request.grid, request.records);
  table.text = partial.text();
  write_table(table, request.table);
  partial.remove();
  const std::string summary =
      fmt::format("{} points, {} computed now; {} were refused or given up, and have empty cells\n",
                  partial.rows(), computed, empty_rows(request, table.text));
  std::fputs(summary.c_str(), stderr);
}

}  // namespace

// The points are computed in blocks. Every process computes its share of a block, consecutive
// points on its own threads; the rows of the shares, joined in the order of the processes, are
// those of the block.
void run_sweep(const SweepRequest &request, const Processes &processes) {
  const std::size_t points = request.grid.points();
  Table rows = sweep_table(request.grid, request.records);
  std::optional<PartialTable> partial;  // on rank 0
  if (processes.rank() == 0) partial.emplace(begin(request, rows.text));
  const std::size_t first =
      std::stoull(processes.joined(partial ? std::to_string(partial->rows()) : ""));
  const int threads = processes.size() > 1 ? 1 : available_threads();
  const auto rank = static_cast<std::size_t>(processes.rank()),
             size = static_cast<std::size_t>(processes.size());
  const std::size_t share = points_per_thread * static_cast<std::size_t>(threads);
  Progress progress("sweep", static_cast<double>(points), static_cast<double>(first));
  for (std::size_t begin = first; begin < points; begin += share * size) {
    const std::size_t own = std::min(points, begin + share * rank);
    const auto compute = [&](std::size_t k) { return record_at(request, own + k); };
    const auto records = sweep(std::min(points - own, share), compute, threads);
    rows.text.clear();
    for (std::size_t k = 0; k < records.size(); ++k)
      add_row(rows, request.grid, request.records, own + k, records[k]);
    const std::string all = processes.joined(rows.text);
    if (!partial) continue;
    partial->add(all);
    progress.advance(static_cast<double>(std::min(points - begin, share * size)));
  }
  if (partial) finish(request, *partial, points - first);
}

}  // namespace vibro_impact::runner
