#include "sweep_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>
#include <stdexcept>
#include <string>

#include "destination.hpp"
#include "partial_table.hpp"
#include "progress.hpp"
#include "vibro_impact/table.hpp"

namespace vibro_impact::runner {

namespace {

// Everything that the table depends on, in one line.
std::string definition_of(const SweepRequest &request) {
  const Scene &scene = request.grid.scene;
  const SettleOptions &settle = request.records.settle;
  const auto list = [](const std::vector<double> &values) {
    return fmt::format("[{:.17g}]", fmt::join(values, " "));
  };
  std::string text = fmt::format(
      "mass {} stiffness {} beta {:.17g} amplitude {} omega {:.17g} restitution {:.17g} "
      "displacement {} velocity {}",
      list(scene.mass), list(scene.stiffness), scene.beta, list(scene.amplitude), scene.omega,
      scene.restitution, list(scene.displacement), list(scene.velocity));
  for (const Stop &stop : scene.stops)
    text += fmt::format(" stop {}:{}:{:.17g}:{:.17g}", stop.mass, name(stop.side), stop.position,
                        stop.restitution.value_or(-1.0));
  for (const Axis &axis : request.grid.axes)
    text +=
        fmt::format(" {}={:.17g}:{:.17g}:{}", name(axis.parameter), axis.from, axis.to, axis.count);
  return text + fmt::format(" longest {} counted {} most {} tolerance {:.17g} impacts {}",
                            settle.longest, request.records.counted, settle.most, settle.tolerance,
                            settle.run.max_impacts_per_period);
}

// A point at which the run is given up leaves the others alone.
OrbitRecord record_or_nothing(const SweepRequest &request, std::size_t point) {
  try {
    return record_of(request.grid.scene_at(point), request.records);
  } catch (const std::runtime_error &) {
    return {};
  }
}

struct Sums {
  std::size_t points = 0, settled = 0, given_up = 0;
  RecordWork work = {};

  void add(const OrbitRecord &record) {
    ++points;
    settled += record.period > 0 ? 1 : 0;
    given_up += record.counts.periods == 0 ? 1 : 0;
    work.settling += record.work.settling;
    work.recorded += record.work.recorded;
    work.with_tangents += record.work.with_tangents;
  }
};

// The files of rank 0.
struct Output {
  const SweepRequest &request;
  Table rows;  // not yet handed on
  StreamedFile table;
  std::optional<PartialTable> partial;  // none where the rows go straight to their place

  explicit Output(const SweepRequest &of)
      : request(of),
        rows(sweep_table(of.grid, of.records)),
        table(destination("--table", of.table)) {
    const Destination to = destination("--table", request.table);
    if (to.path != "-" && !to.direct)
      partial.emplace(to.path + ".partial", definition_of(request), rows.text, request.resume);
    else
      table.write(rows.text);
    rows.text.clear();
  }
  std::size_t first() const {
    return partial ? partial->points() : 0;
  }
  void add(std::size_t point, const OrbitRecord &record) {
    add_row(rows, request.grid, request.records, point, record);
    if (partial)
      partial->add(rows.text);
    else
      table.write(rows.text);
    rows.text.clear();
    if (table.failed()) table.complete();  // which throws
  }
  void finish() {
    if (partial) return partial->finish(table);
    table.complete();
    table.put_in_place();
  }
};

void run_as_rank_0(const SweepRequest &request, const Processes &processes) {
  std::optional<Output> output;
  try {
    output.emplace(request);
  } catch (...) {
    processes.said_by_rank_0(-1);
    throw;
  }
  SweepOptions options;
  options.threads = request.threads;
  options.ranks = processes.ranks();
  options.first = output->first();
  const std::size_t points = request.grid.points();
  processes.said_by_rank_0(static_cast<long long>(options.first));
  Progress progress("sweep", static_cast<double>(points), request.progress,
                    static_cast<double>(options.first));
  options.progress = [&](std::size_t done) { progress.reach(static_cast<double>(done)); };
  Sums sums;
  sweep(
      points, [&](std::size_t point) { return record_or_nothing(request, point); },
      [&](std::size_t point, const OrbitRecord &record) {
        sums.add(record);
        output->add(point, record);
      },
      options);
  output->finish();
  fmt::print(
      stderr,
      "{} points: {} computed, of which {} settled and {} were given up\n"
      "work: {} forcing periods until settled or to the end, {} recorded after that, {} with "
      "tangents\n",
      points, sums.points, sums.settled, sums.given_up, sums.work.settling, sums.work.recorded,
      sums.work.with_tangents);
}

}  // namespace

void run_sweep(const SweepRequest &request, const Processes &processes) {
  if (processes.rank() == 0) return run_as_rank_0(request, processes);
  const long long first = processes.said_by_rank_0(0);
  if (first < 0) return;
  SweepOptions options;
  options.threads = request.threads;
  options.ranks = processes.ranks();
  options.first = static_cast<std::size_t>(first);
  sweep(
      request.grid.points(), [&](std::size_t point) { return record_or_nothing(request, point); },
      [](std::size_t, const OrbitRecord &) {}, options);
}

}  // namespace vibro_impact::runner
