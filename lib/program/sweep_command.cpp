#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <mutex>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "map.hpp"
#include "options.hpp"
#include "picture.hpp"
#include "progress.hpp"
#include "scene_text.hpp"

namespace vibro_impact::runner {

namespace {

// The rows of a sweep form chains. A point of a chain starts where the motion of the latest point
// with a record has settled, and before there is one at the start of the scene. A sweep that
// follows no branch has chains of one point.
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

// The table that the picture is drawn from.
std::size_t table_of_plot(const SweepRequest &request) {
  if (request.grid.axes.size() > 1 || !request.column.empty()) return 0;
  return request.tables[2].wanted() && !request.tables[1].wanted() ? 2 : 1;
}

// The column of the table that the picture shows.
Column column_of_plot(const SweepRequest &request) {
  const std::string name = request.column.empty() ? "period" : request.column;
  const auto columns = record_columns(request.grid.scene.masses(), request.records);
  const auto found = std::ranges::find(columns, name, &Column::name);
  if (found == columns.end()) refuse("--column {}: is no column of the table", name);
  if (name == "pairs") refuse("--column pairs: has words, which cannot be drawn");
  return *found;
}

// The rows of a point in each table, and what they were written of.
struct Rows {
  SweepTables tables = {};
  PointRecord point = {};
};

// The attractors of each scene as they appear, by its parameters but for those of the start.
using Attractors = std::map<std::vector<double>, std::vector<OrbitRecord>>;

// The number of the attractor on which the motion of a point has settled.
int number_of(Attractors &attractors, const Grid &grid, std::size_t point,
              const OrbitRecord &record) {
  std::vector<double> values = grid.values(point);
  for (std::size_t k = 0; k < values.size(); ++k)
    if (const std::string &what = grid.axes[k].parameter;
        what.starts_with("displacement") || what.starts_with("velocity"))
      values[k] = 0.0;
  std::vector<OrbitRecord> &known = attractors[values];
  const Scene scene = grid.scene_at(point);
  const auto found = std::ranges::find_if(known, [&](const OrbitRecord &attractor) {
    return same_attractor(scene, attractor, record);
  });
  const auto number = static_cast<int>(found - known.begin()) + 1;
  if (found == known.end())
    known.push_back({.period = record.period, .section = record.section, .size = record.size});
  return number;
}

// The tables of a part of a sweep, to which threads add the rows in any order. Each is written as
// soon as the rows before it are.
class SweepOutput {
 public:
  SweepOutput(const SweepRequest &request, std::size_t first, std::size_t count)
      : request_(request),
        count_(count),
        next_(first),
        progress_("sweep", static_cast<double>(count)) {
    if (request.plot.wanted() && request.grid.axes.size() == 2)
      map_column_ = column_of_plot(request);
    constexpr Table SweepTables::*members[] = {&SweepTables::records, &SweepTables::impacts,
                                               &SweepTables::section};
    const SweepTables headers = sweep_tables(request.grid, request.records);
    for (std::size_t k = 0; k < request.tables.size(); ++k) {
      if (!request.tables[k].wanted()) continue;
      outputs_.emplace_back(members[k], OpenOutput(request.tables[k].path));
      if (request.part == 1)
        outputs_.back().second.append(request.head + (headers.*members[k]).text);
    }
  }

  void add(std::size_t row, Rows rows) {
    const std::lock_guard lock(mutex_);
    progress_.advance();
    waiting_.emplace(row, std::move(rows));
    for (; !waiting_.empty() && waiting_.begin()->first == next_; ++next_)
      write(next_, waiting_.extract(waiting_.begin()).mapped());
  }

  void finish() {
    for (auto &[table, output] : outputs_) output.finish();
  }

  const Map &map() const {
    return map_;
  }

  // Says how many points have no record, and why. Throws std::runtime_error if no point of the
  // whole sweep has one.
  void print_summary() const;

 private:
  struct Missing {  // rows, whose reasons differ in numbers only
    std::size_t count = 0, first = 0;
    std::string reason_of_first = {};
  };

  const SweepRequest &request_;
  std::size_t count_, next_;
  Progress progress_;
  Map map_ = {};
  std::optional<Column> map_column_ = {};  // where a map is drawn
  std::vector<std::pair<Table SweepTables::*, OpenOutput>> outputs_ = {};
  std::map<std::string, Missing> missing_ = {};  // by the kind of the reason
  bool is_missing_ = false;                      // the latest row
  std::size_t after_missing_ = 0;                // rows behind it in the same chain
  std::mutex mutex_ = {};
  std::map<std::size_t, Rows> waiting_ = {};
  Attractors attractors_ = {};

  void write(std::size_t row, Rows rows) {
    const Grid &grid = request_.grid;
    const std::size_t point = point_of(request_, row);
    std::optional<OrbitRecord> &record = rows.point.record;
    if (request_.records.attractor) {
      if (record && record->period > 0)
        record->attractor = number_of(attractors_, grid, point, *record);
      add_rows(rows.tables, grid, request_.records, point, record);
    }
    for (auto &[table, output] : outputs_) output.append((rows.tables.*table).text);
    if (map_column_) map_.add(grid.values(point), map_word(*map_column_, rows.point));
    if (record && is_missing_ && row % chain_length(request_) > 0) ++after_missing_;
    is_missing_ = !record;
    if (record) return;
    Missing &missing = missing_[kind_of_reason(rows.point.reason)];
    if (missing.count++ == 0)
      std::tie(missing.first, missing.reason_of_first) = std::tie(row, rows.point.reason);
  }
};

// Adds the rows of a chain.
void compute_chain(const SweepRequest &request, std::size_t chain, SweepOutput &output) {
  std::optional<OrbitRecord> before;
  const std::size_t length = chain_length(request);
  for (std::size_t row = chain * length; row < (chain + 1) * length; ++row) {
    const std::size_t point = point_of(request, row);
    Rows rows{.point = point_record(request.grid.scene_at(point), request.records, before)};
    const std::optional<OrbitRecord> &record = rows.point.record;
    if (length > 1 && record) before = record;
    // An attractor has its number only where the rows are written in order.
    if (!request.records.attractor)
      add_rows(rows.tables, request.grid, request.records, point, record);
    output.add(row, std::move(rows));
  }
}

void check_outputs_of(const SweepRequest &request) {
  std::vector<Output> outputs(request.tables.begin(), request.tables.end());
  if (std::ranges::none_of(outputs, &Output::wanted))
    refuse("needs --table, --impacts or --section: the file that it writes");
  outputs.push_back(request.plot);
  check_outputs(outputs, request.scene_file);
  if (!request.plot.wanted()) return;
  const std::size_t ranges = request.grid.axes.size();
  if (ranges > 2) refuse("{}: draws one or two ranges, not {}", request.plot.given(), ranges);
  check_picture(request.plot, request.tables[table_of_plot(request)]);
  column_of_plot(request);
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

void draw_plot(const SweepRequest &request, const Map &map) {
  const auto &axes = request.grid.axes;
  const std::size_t table = table_of_plot(request);
  if (axes.size() == 2)
    return draw(request.plot, "map", column_of_plot(request).name, {map.table()},
                {words_of(axes[0]), words_of(axes[1]), map.classes()});
  std::string content = request.column;
  if (table > 0)
    content = fmt::format("{}{}", table == 2 ? "x" : "",
                          fmt::join(request.panels, table == 2 ? " x" : " "));
  draw(request.plot, table == 1 ? "diagram" : "columns", content, {request.tables[table]},
       {request.follow ? "branches" : "points", words_of(axes[0])});
}

// The values of the point of a row, "omega = 0.3, beta = 0.1".
std::string values_of(const SweepRequest &request, std::size_t row) {
  std::string words;
  const std::vector<double> values = request.grid.values(point_of(request, row));
  for (std::size_t axis = 0; axis < values.size(); ++axis)
    words += fmt::format("{}{} = {}", axis == 0 ? "" : ", ", request.grid.axes[axis].parameter,
                         values[axis]);
  return words;
}

void SweepOutput::print_summary() const {
  std::size_t missing = 0;
  for (const auto &[kind, rows] : missing_) missing += rows.count;
  fmt::print(stderr, "{} points; {} were refused or given up, and have {}\n", count_, missing,
             request_.tables[0].wanted() ? "empty cells" : "no rows");
  for (const auto &[kind, rows] : missing_)
    fmt::print(stderr, "{} of {} points: {}; first at {}\n", rows.count, count_,
               rows.reason_of_first, values_of(request_, rows.first));
  if (after_missing_ > 0)
    fmt::print(stderr,
               "{} of {} points start at the latest point with a record, or at the start of the "
               "scene, because the point before has none\n",
               after_missing_, count_);
  if (missing == count_ && request_.parts == 1)
    throw std::runtime_error("every point of the sweep was refused or given up");
}

// The first chain of a part, of which the earlier ones have one chain more where the number of
// chains is no multiple of the number of parts.
std::size_t first_chain(std::size_t chains, std::size_t part, std::size_t parts) {
  return chains / parts * (part - 1) + std::min(part - 1, chains % parts);
}

}  // namespace

// Chains are computed in blocks, so that a chain that takes long cannot let the rows behind it pile
// up: a block has 256 rows, or one chain, for each thread. At the end of a block threads wait for
// the last chain; that costs less than a hundredth of the time of sweeps of the paper.
void run_sweep(const SweepRequest &request) {
  check_outputs_of(request);
  const std::size_t length = chain_length(request), chains = number_of_rows(request) / length,
                    first = first_chain(chains, request.part, request.parts),
                    end = first_chain(chains, request.part + 1, request.parts),
                    block = std::max<std::size_t>(256 / length, 1) *
                            static_cast<std::size_t>(available_threads());
  SweepOutput output(request, first * length, (end - first) * length);
  for (std::size_t chain = first; chain < end; chain += block)
    compute_points(std::min(block, end - chain), 0,
                   [&](std::size_t k) { compute_chain(request, chain + k, output); });
  output.finish();
  try {
    if (request.plot.wanted()) draw_plot(request, output.map());
  } catch (const std::runtime_error &failure) {
    throw std::runtime_error(fmt::format("{}; the tables are complete", failure.what()));
  }
  output.print_summary();
}

}  // namespace vibro_impact::runner
