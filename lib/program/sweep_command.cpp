#include <fmt/format.h>

#include <string>

#include "options.hpp"
#include "output.hpp"
#include "partial_table.hpp"
#include "progress.hpp"
#include "refuse.hpp"

namespace vibro_impact::runner {

namespace {

// A point at which the run is given up leaves the others alone: its row is empty.
std::vector<double> row_at(const SweepRequest &request, std::size_t point) {
  try {
    return row_of(record_of(request.grid.scene_at(point), request.records), request.records);
  } catch (const std::runtime_error &) {
    return {};
  }
}

// On rank 0, with a function that may leave a point to another process.
void run_with(const SweepRequest &request, int threads, const ComputeRow &row_of_point) {
  const Destination to(request.table);
  if (to.direct || Destination(to.path + ".partial").direct)
    refuse("--table {}: it and its .partial must be files, for which the rows are kept",
           request.table);
  remember_signals();
  Table text = sweep_table(request.grid, request.records);  // not yet handed on
  PartialTable partial(to.path + ".partial", request.definition, text.text, request.resume);
  const std::size_t points = request.grid.points(), first = partial.points();
  std::size_t given_up = 0;
  Progress progress("sweep", static_cast<double>(points), static_cast<double>(first));
  const auto take = [&](std::size_t point, const std::vector<double> &row) {
    if (row.empty()) ++given_up;
    text.text.clear();
    add_row(text, request.grid, request.records, point, row);
    partial.add(text.text);
    progress.advance();
    if (const int signal = signal_that_came())
      throw EndedBySignal{signal, fmt::format("interrupted; the rows so far stand in {}.partial: "
                                              "--resume goes on with them",
                                              to.path)};
  };
  sweep(points, row_of_point, take, {.threads = threads, .first = first});
  partial.finish(to.path);
  const std::string sum = fmt::format("{} points: {} computed, of which {} were given up\n", points,
                                      points - first, given_up);
  std::fputs(sum.c_str(), stderr);
}

}  // namespace

void run_sweep(const SweepRequest &request, const Processes &processes) {
  processes.share_out(
      available_threads(), [&request](std::size_t point) { return row_at(request, point); },
      [&request](int all, const ComputeRow &row) { run_with(request, all, row); });
}

}  // namespace vibro_impact::runner
