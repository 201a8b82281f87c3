#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "options.hpp"
#include "picture.hpp"
#include "progress.hpp"
#include "summary.hpp"
#include "vibro_impact/analysis/response.hpp"

namespace vibro_impact::runner {

namespace {

Table table_of(const EventRecorder &recorder) {
  Table table(
      "time,mass,event,velocity_before,velocity_after,contact_mode,stop,side,phase,impulse");
  for (const Event &event : recorder.events) {
    table.row(event.time, event.mass, name(event.kind), event.velocity_before, event.velocity_after,
              contact_mode_name(event.held), event.stop, name(event.side), event.instant.phase,
              event.taken.impulse);
  }
  return table;
}

double with_15_digits(double time) {
  return std::stod(fmt::format("{:.15g}", time));
}

// Takes samples. On a grid of decimals, their times are the numbers nearest to the decimals, which
// are less than two roundings from the sums that SampleRecorder takes.
struct GridRecorder : SampleRecorder {
  bool is_decimal;

  explicit GridRecorder(const RunRequest &request)
      : SampleRecorder(request.from, request.until, request.every),
        is_decimal(from == with_15_digits(from) && every == with_15_digits(every) &&
                   every > 1e-9 * to) {
  }
  double next_time() const override {
    const double sum = SampleRecorder::next_time();
    if (!is_decimal || !(sum < to)) return sum;
    const double decimal = with_15_digits(sum);
    return std::abs(decimal - sum) <= 4e-16 * sum ? decimal : sum;
  }
};

// The table of samples, row by row.
struct SampleTable : GridRecorder {
  bool velocities;
  Table table;

  explicit SampleTable(const RunRequest &request)
      : GridRecorder(request),
        velocities(request.velocities),
        table("time" + numbered_columns("x", request.scene.mass.size()) +
              (velocities ? numbered_columns("v", request.scene.mass.size()) : "")) {
  }
  void sample(const Moment &moment) override {
    times.push_back(moment.time);
    // The shortest decimal that is read back as the time.
    table.cell(std::string_view(fmt::format("{}", moment.time)));
    for (int mass = 1; mass <= moment.masses(); ++mass) table.cell(moment.displacement(mass));
    for (int mass = 1; mass <= moment.masses() && velocities; ++mass)
      table.cell(moment.velocity(mass));
    table.end_row();
  }
};

// The curve of each mass in the phase plane: its samples and, unless these are the points of a
// section, the two ends of each jump of its velocity.
struct PortraitRecorder : GridRecorder {
  bool is_section;
  std::vector<Table> curves;

  explicit PortraitRecorder(const RunRequest &request)
      : GridRecorder(request),
        is_section(request.scene.omega > 0.0 &&
                   request.every > 0.4 * Clock(request.scene.omega).period),
        curves(request.scene.mass.size()) {
  }
  void sample(const Moment &moment) override {
    times.push_back(moment.time);
    for (std::size_t i = 0; i < curves.size(); ++i) {
      const int mass = static_cast<int>(i) + 1;
      curves[i].row(moment.displacement(mass), moment.velocity(mass));
    }
  }
  void event(const Event &event, const Moment &moment) override {
    if (is_section || event.time < from) return;
    for (const double velocity : {event.velocity_before, event.velocity_after})
      curves[static_cast<std::size_t>(event.mass) - 1].row(moment.displacement(event.mass),
                                                           velocity);
  }
};

// Shows a thousand times how far a run is.
struct ProgressRecorder : Recorder {
  static constexpr double shown_times = 1000.0;

  Progress progress;
  double until, taken = 0.0;

  explicit ProgressRecorder(double end) : progress("time", end), until(end) {
  }
  double next_time() const override {
    const double next = until * ((taken + 1.0) / shown_times);
    return taken + 1.0 < shown_times && next > 0.0 ? next : infinity;
  }
  void sample(const Moment &) override {
    ++taken;
    progress.advance(until / shown_times);
  }
};

// The positions of the stops of each mass on one side, in words for gnuplot.
std::string positions_of(const Scene &scene, Side side) {
  std::vector<std::string> positions(static_cast<std::size_t>(scene.masses()), "NaN");
  for (const Stop &stop : scene.stops)
    if (stop.side == side)
      positions[static_cast<std::size_t>(stop.mass) - 1] = fmt::format("{}", stop.position);
  return fmt::format("{}", fmt::join(positions, " "));
}

void draw_pictures(const RunRequest &request, const PortraitRecorder &portrait) {
  const std::string panels = fmt::format("{}", fmt::join(request.panels, " ")),
                    lower = positions_of(request.scene, Side::lower),
                    upper = positions_of(request.scene, Side::upper);
  if (request.plot.wanted())
    draw(request.plot, "motion", panels, {request.samples, request.events}, {lower, upper});
  if (!request.portrait.wanted()) return;
  const TemporaryFile file;
  for (const Table &curve : portrait.curves) file.append(curve.text + "\n\n");
  draw(request.portrait, "portrait", panels, {file.output()},
       {portrait.is_section ? "points" : "lines", lower, upper});
}

// Prints a line for each mass.
void print(const std::vector<Response> &responses) {
  for (std::size_t i = 0; i < responses.size(); ++i)
    fmt::print(stderr, "mass {}: displacement from {:.7g} to {:.7g}, root mean square {:.7g}\n",
               i + 1, responses[i].lowest, responses[i].highest, responses[i].rms);
}

// The coefficients of restitution of the stops, each once, or that of the scene without stops.
std::string restitutions_of(const Scene &scene) {
  std::vector<double> values;
  for (const Stop &stop : scene.stops)
    if (const double r = law_of(scene, stop).at_rest();
        std::ranges::find(values, r) == values.end())
      values.push_back(r);
  if (values.empty()) values.push_back(scene.restitution);
  return fmt::format("{}", fmt::join(values, " and "));
}

// The chain, of which the user may have given little, and what happened to it.
void print_summary(const Scene &scene, const Outcome &outcome) {
  int forced = 0;
  for (int mass = 1; mass <= scene.masses(); ++mass) forced += scene.forced(mass);
  const Counters &counters = outcome.counters;
  fmt::print(stderr,
             "masses: {}, forced: {}, stops: {}, restitution: {}, beta: {}; t = {:.17g}: since t = "
             "0, {} impacts "
             "resolved, {} sticks, {} releases; chatter {} times carried to its limit, {} times "
             "incomplete\n",
             scene.masses(), forced, scene.stops.size(), restitutions_of(scene), scene.beta,
             outcome.time, counters.impacts, counters.sticks, counters.releases,
             counters.chatter_limits, counters.chatter_incomplete);
}

}  // namespace

void check_outputs_of(const RunRequest &request, const Output &more, const Output &table_of_plot) {
  check_outputs(
      {request.events, request.samples, request.summary, request.plot, request.portrait, more},
      request.scene_file);
  if (request.plot.wanted()) check_picture(request.plot, table_of_plot);
  if (request.portrait.wanted()) check_picture(request.portrait, request.samples);
  if (request.portrait.wanted() && !request.velocities)
    refuse("{}: needs --velocities", request.portrait.given());
}

Outcome record_run(const RunRequest &request) {
  EventRecorder events(request.from, request.slowest);
  SampleTable samples(request);
  PortraitRecorder portrait(request);
  TotalsRecorder totals(request.scene, request.from, request.until, request.slowest);
  ResponseRecorder response(request.scene, request.from, request.until);
  std::vector<Recorder *> recorders;
  if (request.events.wanted()) recorders.push_back(&events);
  if (request.samples.wanted()) recorders.push_back(&samples);
  if (request.portrait.wanted()) recorders.push_back(&portrait);
  if (request.summary.wanted()) recorders.insert(recorders.end(), {&totals, &response});
  Outcome outcome;
  {
    ProgressRecorder progress(request.until);
    if (isatty(STDERR_FILENO) != 0 && !request.start) recorders.push_back(&progress);
    Simulation simulation(request.scene, request.start.value_or(start_of(request.scene)),
                          request.options);
    outcome = simulation.advance(request.until, recorders);
  }
  outcome = require_complete(std::move(outcome));
  for (const auto &[output, text] : {std::pair{request.events, table_of(events).text},
                                     {request.samples, samples.table.text},
                                     {request.summary, table_of(totals, request.scene).text}})
    if (output.wanted()) write_text(request.head + text, output.path);
  print(response.responses());
  draw_pictures(request, portrait);
  return outcome;
}

void run_scene(const RunRequest &request) {
  check_outputs_of(request, {}, request.samples);
  print_summary(request.scene, record_run(request));
  if (!request.events.wanted() && !request.samples.wanted() && !request.summary.wanted())
    fmt::print(stderr, "no table was asked for, as by --events, --samples or --summary\n");
}

}  // namespace vibro_impact::runner
