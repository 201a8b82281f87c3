#include "sweep_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <stdexcept>

#include "bad_input.hpp"
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
    "lyapunov (greatest Lyapunov exponent, per unit of time); pairs (DG, DS, DI, GS, GI, SI or "
    "-).\n"
    "A point at which the run is given up has empty cells. The table does not depend on the\n"
    "number of threads or processes. Until it is complete its rows stand in FILE.partial, from\n"
    "which --resume goes on.\n"
    "Exit status: 0 done, 1 a file could not be written, 2 bad input.";

bool is_range(const std::string &text) {
  return text.find(':') != std::string::npos;
}

// name=from:to:count
Axis axis_given_as_vary(const std::string &text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos)
    throw BadInput(fmt::format("--vary {}: must read parameter=from:to:count", text));
  try {
    const Parameter parameter = parameter_named(text.substr(0, equals));
    Axis axis = axis_of("--vary", parameter, text.substr(equals + 1));
    return axis;
  } catch (const std::invalid_argument &error) {
    throw BadInput(fmt::format("--vary {}: {}", text, error.what()));
  }
}

// The range given to an option of a single number, which becomes its first value.
std::optional<Axis> axis_in(const CLI::Option &option, std::string &word, const char *name) {
  if (!is_range(word)) return std::nullopt;
  const Axis axis = axis_of(option.get_name(), parameter_named(name), word);
  word = fmt::format("{:.17g}", axis.from);
  return axis;
}

// The axes in the order in which they were given.
std::vector<Axis> take_axes(const CLI::App &app, const SweepWords &words, SceneWords &scene,
                            const SweepGiven &given) {
  std::vector<Axis> axes;
  std::size_t varied = 0;
  for (const CLI::Option *option : app.parse_order()) {
    std::optional<Axis> axis;
    if (option == given.vary)
      axis = axis_given_as_vary(words.vary.at(varied++));
    else if (option->get_name() == "--omega")
      axis = axis_in(*option, scene.omega, "omega");
    else if (option->get_name() == "--restitution")
      axis = axis_in(*option, scene.restitution, "restitution");
    else if (option == given.scene.beta)
      axis = axis_in(*option, scene.beta, "beta");
    if (axis) axes.push_back(*axis);
  }
  if (axes.empty())
    throw BadInput("sweep: needs a range from:to:count of some parameter (--omega, --vary, ...)");
  return axes;
}

}  // namespace

SweepGiven add_sweep_options(CLI::App &app, SweepWords &words) {
  SweepGiven given{add_scene_options(app, words.scene)};
  for (const char *name : {"--omega", "--restitution", "--beta"}) {
    CLI::Option *scalar = app.get_option(name);
    scalar->type_name("NUMBER or FROM:TO:COUNT");
  }
  given.vary = app.add_option("--vary", words.vary,
                              "parameter=from:to:count, repeatable; parameter is omega, beta,\n"
                              "restitution, or restitution2 (of a stop), stop1 (its position),\n"
                              "amplitude2, mass1, stiffness1, displacement1, velocity1")
                   ->type_name("RANGE");
  option(app, "--table", words.table, "FILE", "The table (CSV); - for standard output");
  app.add_flag("--resume", words.resume, "Go on with what a sweep that was ended left of --table");
  given.threads = option(app, "--threads", words.threads, "N",
                         "Threads of every process. Default: one per processor");
  option(app, "--longest", words.longest, "N",
         "Forcing periods after which a motion counts as not settling");
  option(app, "--counted", words.counted, "N",
         "Forcing periods over which such a motion is recorded after that");
  option(app, "--max-period", words.most_periods, "N", "Largest period looked for");
  option(app, "--tolerance", words.tolerance, "NUMBER",
         "Of what is still to come when a motion counts as settled");
  option(app, "--max-impacts", words.most_impacts, "N",
         "Give up a point beyond this many impacts in one forcing period");
  app.add_flag("--no-lyapunov", words.no_lyapunov, "Leave out the Lyapunov exponent");
  app.add_flag("--pairs", words.pairs, "Add the pairs of events of Table I that occur");
  app.add_flag("--progress", words.progress,
               "Show progress and time left also where standard error is no terminal");
  app.footer(footer);
  return given;
}

SweepRequest sweep_of(const CLI::App &app, const SweepWords &words, const SweepGiven &given) {
  SweepRequest request;
  SceneWords scene = words.scene;
  request.grid.axes = take_axes(app, words, scene, given);
  request.grid.scene = scene_of(scene, given.scene);
  check(request.grid);
  request.records.settle.longest = static_cast<int>(count_of("--longest", words.longest, 1000000));
  request.records.settle.most =
      static_cast<int>(count_of("--max-period", words.most_periods, 1000));
  request.records.settle.tolerance = positive("--tolerance", words.tolerance);
  request.records.settle.run.max_impacts_per_period =
      count_of("--max-impacts", words.most_impacts, 1'000'000'000'000'000);
  request.records.counted = static_cast<int>(count_of("--counted", words.counted, 1000000));
  request.records.lyapunov = !words.no_lyapunov;
  request.records.pairs = words.pairs;
  if (given.threads->count() > 0)
    request.threads = static_cast<int>(count_of("--threads", words.threads, 1024));
  if (words.table.empty()) throw BadInput("--table '': must name a file");
  if (words.resume && words.table == "-")
    throw BadInput("--resume: needs --table FILE, beside which the rows so far stand");
  request.table = words.table;
  request.resume = words.resume;
  request.progress = words.progress;
  return request;
}

}  // namespace vibro_impact::runner
