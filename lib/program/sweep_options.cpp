#include "sweep_options.hpp"

#include <fmt/ranges.h>

#include <optional>
#include <stdexcept>

#include "output.hpp"
#include "refuse.hpp"
#include "values.hpp"

namespace vibro_impact::runner {

namespace {

constexpr const char *footer =
    "Example, on two machines or one:\n"
    "  vibro-impact sweep --omega 0.25:0.7:901 --restitution 0.1:0.9:81 --table atlas.csv\n"
    "  mpirun -n 4 vibro-impact sweep --vary stop1=-0.4:-0.2:101 --table stops.csv --resume\n"
    "The points are those of nested loops, the first range outermost. Columns: the parameters;\n"
    "period (in forcing periods, 0: none up to --max-period); sticks and impacts of every mass "
    "per\n"
    "forcing period (a mean over the period, or over --counted; impacts of a complete chatter,\n"
    "infinitely many, are not counted); dual_sticking (1: two masses are held at some time);\n"
    "lyapunov (greatest Lyapunov exponent, per unit of time; empty: its sign is not certain); "
    "pairs (DG, DS, DI, GS, GI, SI or "
    "-).\n"
    "A point at which the run is given up has empty cells. The table does not depend on the\n"
    "number of threads or processes. Until it is complete its rows stand in FILE.partial, from\n"
    "which --resume goes on.\n"
    "Exit status: 0 done, 1 a file could not be written, 2 bad input.";

// name=from:to:count
Axis axis_given_as_vary(const std::string &text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) refuse("--vary {}: must read parameter=from:to:count", text);
  std::optional<Parameter> parameter;
  try {
    parameter = parameter_named(text.substr(0, equals));
  } catch (const std::invalid_argument &error) {
    refuse("--vary {}: {}", text, error.what());
  }
  return axis_of("--vary", *parameter, text.substr(equals + 1));
}

// The axes in the order in which they were given: those of --vary, and the ranges given to options
// of a single number, which become their first values.
std::vector<Axis> take_axes(const CLI::App &app, SweepOptionsOf &options) {
  const std::pair<const char *, std::string *> numbers[] = {
      {"omega", &options.scene.omega},
      {"restitution", &options.scene.restitution},
      {"beta", &options.scene.beta}};
  std::vector<Axis> axes;
  std::size_t varied = 0;
  for (const CLI::Option *option : app.parse_order()) {
    const std::string name = option->get_name();
    if (name == "--vary") axes.push_back(axis_given_as_vary(options.vary.at(varied++)));
    for (const auto &[parameter, word] : numbers)
      if (name.substr(2) == parameter && word->find(':') != std::string::npos) {
        axes.push_back(axis_of(name, parameter_named(parameter), *word));
        *word = fmt::format("{:.17g}", axes.back().from);
      }
  }
  if (axes.empty())
    refuse("sweep: needs a range from:to:count of some parameter (--omega, --vary, ...)");
  return axes;
}

// The version and the options as they were given, in their order, which is that of the axes; but
// for those that the table does not depend on.
std::string definition_of(const CLI::App &app) {
  std::string text = VIBRO_IMPACT_VERSION;
  for (const CLI::Option *option : app.parse_order()) {
    const std::string name = option->get_name();
    if (name == "--table" || name == "--resume" || name == "--threads" || name == "--progress")
      continue;
    text += fmt::format(" {}={}", name, fmt::join(option->results(), ","));
  }
  return text;
}

}  // namespace

void add_sweep_options(CLI::App &app, SweepOptionsOf &options) {
  SweepRequest &request = options.request;
  SettleOptions &settle = request.records.settle;
  request.records.lyapunov = true;
  add_scene_options(app, options.scene);
  for (const char *name : {"--omega", "--restitution", "--beta"})
    app.get_option(name)->type_name("NUMBER or FROM:TO:COUNT");
  option(app, "--vary", options.vary, "RANGE",
         "parameter=from:to:count, repeatable; parameter is omega, beta,\n"
         "restitution, or restitution2 (of a stop), stop1 (its position),\n"
         "amplitude2, mass1, stiffness1, displacement1, velocity1");
  option(app, "--table", request.table, "FILE", "The table (CSV); - for standard output")
      ->check(file_name());
  app.add_flag("--resume", request.resume,
               "Go on with what a sweep that was ended left of --table");
  app.add_option("--threads", request.threads,
                 "Threads of every process. Default: one per processor")
      ->type_name("N")
      ->check(whole_number(1024));
  option(app, "--longest", settle.longest, "N",
         "Forcing periods after which a motion counts as not settling")
      ->check(whole_number(1e6));
  option(app, "--counted", request.records.counted, "N",
         "Forcing periods over which such a motion is recorded after that")
      ->check(whole_number(1e6));
  option(app, "--max-period", settle.most, "N", "Largest period looked for")
      ->check(whole_number(1000));
  option(app, "--tolerance", settle.tolerance, "NUMBER",
         "Of what is still to come when a motion counts as settled")
      ->check(positive_number());
  option(app, "--max-impacts", settle.run.max_impacts_per_period, "N",
         "Give up a point beyond this many impacts in one forcing period")
      ->check(whole_number(1e15));
  app.add_flag_callback(
      "--no-lyapunov", [&request] { request.records.lyapunov = false; },
      "Leave out the Lyapunov exponent");
  app.add_flag("--pairs", request.records.pairs, "Add the pairs of events of Table I that occur");
  app.add_flag("--progress", request.progress,
               "Show progress and time left also where standard error is no terminal");
  app.footer(footer);
}

SweepRequest sweep_of(const CLI::App &app, SweepOptionsOf options) {
  SweepRequest &request = options.request;
  request.grid.axes = take_axes(app, options);
  request.grid.scene = scene_of(options.scene);
  check(request.grid);
  request.definition = definition_of(app);
  if (request.resume && Destination({"--table", request.table}).standard)
    refuse("--resume: needs --table FILE, beside which the rows so far stand");
  return request;
}

}  // namespace vibro_impact::runner
