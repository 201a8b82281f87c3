#include "sweep_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
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

// The files of rank 0.
class SweepOutput {
 public:
  explicit SweepOutput(const SweepRequest &request)
      : request_(request), rows_(sweep_table(request.grid, request.records)) {
    const Destination to(table_);
    if (to.standard || to.direct) {
      direct_.emplace(table_).write(rows_.text);
    } else {
      table_.path = to.path;
      const std::string partial = to.path + ".partial";
      say_when_interrupted(fmt::format(
          "vibro-impact: interrupted; the rows so far stand in {}: --resume goes on with them\n",
          partial));
      partial_.emplace(partial, definition_of(request), rows_.text, request.resume);
    }
    rows_.text.clear();
  }
  std::size_t first() const {
    return partial_ ? partial_->points() : 0;
  }
  void add(std::size_t point, std::span<const double> row) {
    add_row(rows_, request_.grid, request_.records, point, row.first(row.size() - counts_of_work));
    if (partial_)
      partial_->add(rows_.text);
    else
      direct_->write(rows_.text);
    rows_.text.clear();
    if (direct_ && direct_->failed()) direct_->complete();  // which throws
  }
  void finish() {
    if (partial_)
      partial_->finish(table_);
    else
      direct_->complete();
  }

 private:
  const SweepRequest &request_;
  Named table_{"--table", request_.table};
  Table rows_;                    // not yet handed on
  std::optional<Output> direct_;  // where the rows go straight to their place
  std::optional<PartialTable> partial_;
};

}  // namespace

void run_sweep(const SweepRequest &request, const Processes &processes) {
  const int threads = request.threads > 0 ? request.threads : available_threads();
  const auto compute = [&request](std::size_t point) { return row_at(request, point); };
  processes.share_out(
      threads, compute, [&request](int all_threads, const ComputeRow &row_of_point) {
        SweepOutput output(request);
        const std::size_t points = request.grid.points();
        Progress progress("sweep", static_cast<double>(points), request.progress,
                          static_cast<double>(output.first()));
        Sums sums;
        sweep(points, row_of_point,
              [&](std::size_t point, const Row &row) {
                sums.add(row);
                output.add(point, row);
                progress.reach(static_cast<double>(point + 1));
              },
              {.threads = all_threads, .first = output.first()});
        output.finish();
        fmt::print(stderr,
                   "{} points: {} computed, of which {} settled and {} were given up\n"
                   "work: {:.0f} forcing periods until settled or to the end, {:.0f} recorded "
                   "after that, {:.0f} "
                   "with tangents\n",
                   points, sums.points, sums.settled, sums.given_up, sums.work[0], sums.work[1],
                   sums.work[2]);
      });
}

}  // namespace vibro_impact::runner
