#include "sweep_command.hpp"

#include <fmt/format.h>

#include <optional>
#include <stdexcept>
#include <string>

#include "interrupt.hpp"
#include "partial_table.hpp"
#include "progress.hpp"
#include "vibro_impact/table.hpp"

namespace vibro_impact::runner {

namespace {

using Row = std::vector<double>;

// Behind what stands in the table of a point: the forcing periods integrated for it.
constexpr std::size_t counts_of_work = 3;

// A point at which the run is given up leaves the others alone: its row has no numbers but the
// work.
Row row_at(const SweepRequest &request, std::size_t point) {
  Row row;
  RecordWork work;
  try {
    const OrbitRecord record = record_of(request.grid.scene_at(point), request.records);
    row = row_of(record, request.records);
    work = record.work;
  } catch (const std::runtime_error &) {
  }
  for (const long long periods : {work.settling, work.recorded, work.with_tangents})
    row.push_back(static_cast<double>(periods));
  return row;
}

struct Sums {
  std::size_t points = 0, settled = 0, given_up = 0;
  double work[counts_of_work] = {};

  void add(std::span<const double> row) {
    ++points;
    if (row.size() == counts_of_work) ++given_up;
    if (row.size() > counts_of_work && row[0] > 0.0) ++settled;
    for (std::size_t k = 0; k < counts_of_work; ++k)
      work[k] += row[row.size() - counts_of_work + k];
  }
};

// Where the rows go: beside the table until it is complete, or straight to a device or a pipe.
struct Rows {
  Named table;
  std::optional<PartialTable> partial = {};
  std::optional<Output> direct = {};

  Rows(const SweepRequest &request, const std::string &header) : table{"--table", request.table} {
    const Destination to(table);
    if (to.direct) {
      direct.emplace(table).write(header);
      return;
    }
    table.path = to.path;
    remember_signals();
    partial.emplace(to.path + ".partial", request.definition, header, request.resume);
  }
  void add(std::string_view row) {
    if (partial) {
      partial->add(row);
      if (const int signal = signal_that_came())
        throw EndedBySignal{signal, fmt::format("interrupted; the rows so far stand in {}.partial: "
                                                "--resume goes on with them",
                                                table.path)};
      return;
    }
    direct->write(row);
    if (direct->failed()) direct->complete();  // which throws
  }
};

// On rank 0, with a function that may leave a point to another process.
void run_with(const SweepRequest &request, int threads, const ComputeRow &row_of_point) {
  Table text = sweep_table(request.grid, request.records);  // not yet handed on
  Rows rows(request, text.text);
  const std::size_t points = request.grid.points(),
                    first = rows.partial ? rows.partial->points() : 0;
  Progress progress("sweep", static_cast<double>(points), request.progress,
                    static_cast<double>(first));
  Sums sums;
  const auto take = [&](std::size_t point, const Row &row) {
    sums.add(row);
    text.text.clear();
    add_row(text, request.grid, request.records, point,
            std::span(row).first(row.size() - counts_of_work));
    rows.add(text.text);
    progress.reach(static_cast<double>(point + 1));
  };
  sweep(points, row_of_point, take, {.threads = threads, .first = first});
  if (rows.partial)
    rows.partial->finish(rows.table);
  else
    rows.direct->complete();
  fmt::print(
      stderr,
      "{} points: {} computed, of which {} settled and {} were given up\n"
      "work: {:.0f} forcing periods until settled or to the end, {:.0f} recorded after that, "
      "{:.0f} with tangents\n",
      points, sums.points, sums.settled, sums.given_up, sums.work[0], sums.work[1], sums.work[2]);
}

}  // namespace

void run_sweep(const SweepRequest &request, const Processes &processes) {
  const int threads = request.threads > 0 ? request.threads : available_threads();
  processes.share_out(
      threads, [&request](std::size_t point) { return row_at(request, point); },
      [&request](int all, const ComputeRow &row) { run_with(request, all, row); });
}

}  // namespace vibro_impact::runner
