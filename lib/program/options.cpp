#include "options.hpp"

#include <fmt/ranges.h>

#include "files.hpp"
#include "scene_options.hpp"

namespace vibro_impact::runner {

namespace {

// The values of a parameter, given as parameter=from:to:count.
Axis axis_of(const std::string &text) {
  const std::string given = "--vary " + text;
  const auto sides = split(text, '='), range = split(sides.back(), ':');
  if (sides.size() != 2 || range.size() != 3)
    refuse("{}: must read parameter=from:to:count", given);
  return {sides[0], number(given, range[0]), number(given, range[1]),
          static_cast<std::size_t>(whole_number(given, range[2], 1e9))};
}

// The options of a sweep that were given and on which its rows depend (those that are configurable,
// as CLI11 has it), as words --name=value in one line.
std::string given(const CLI::App &app) {
  std::string text;
  for (const CLI::Option *option : app.get_options())
    for (const std::string &value : option->results())
      if (option->get_configurable()) text += fmt::format(" {}={}", option->get_name(), value);
  return text;
}

constexpr const char *notes =
    R"(All quantities are non-dimensional. Masses are counted from 1; the link of mass i joins
it to mass i - 1, and that of mass 1 to the ground. A single value stands for all masses; a list
has one value per mass, separated by commas. The defaults are those of Wagg (2006), Figure 2; its
omega is inferred, not printed.

Example of a run:
  vibro-impact run --from 700 --events events.csv --samples samples.csv --plot run.png
Events: time,mass,event,velocity_before,velocity_after,contact_mode; event is impact, stick or
release; contact_mode lists the sticking masses after the event (-, 1, 2, 1+2).

Example of a sweep:
  vibro-impact sweep --vary omega=0.25:0.7:10 --vary stop1=-0.4:-0.2:3 --table atlas.csv
The points are those of nested loops, the first range outermost. They are computed on
OMP_NUM_THREADS threads{}; the table does not depend on their number.
FILE.partial has the rows until all are there. A point that is refused or given up has empty cells.
Columns behind the parameters, for a chain of one mass:
{}
Exit status: 0 done, 1 the run was given up or a file could not be written, 2 bad input.)";

constexpr const char *notes_of_mpi =
    ", or with `mpirun -n 4 vibro-impact sweep ...`\non as many processes of one thread each";

std::string footer(bool with_mpi) {
  std::string columns;
  RecordOptions all;
  all.lyapunov = all.pairs = true;
  for (const Column &column : record_columns(1, all))
    columns += fmt::format("  {:<14} {}\n", column.name, column.meaning);
  return fmt::format(notes, with_mpi ? notes_of_mpi : "", columns);
}

const CLI::Range any_count(1LL, 1'000'000'000'000'000LL);

void add_run_options(CLI::App &run, RunRequest &request) {
  option(run, "--until", request.until, "TIME", "End of the run");
  option(run, "--from", request.from, "TIME",
         "Start of both tables; the run itself starts at t = 0");
  option(run, "--every", request.every, "TIME",
         "Interval between samples, > 0, counted from --from");
  option(run, "--events", request.events, "FILE", "Event table (CSV); - for standard output");
  option(run, "--samples", request.samples, "FILE",
         "Displacements time,x1,x2,... (CSV); - for standard output");
  option(run, "--plot", request.plot, "FILE",
         "Picture of the tables, by gnuplot: displacements, stops and sticking of --samples,\n"
         "impacts of --events; .png, .pdf or .svg");
  option(run, "--resolve-chatter", request.options.resolve_chatter, "SPEED",
         "Resolve and record every chatter impact faster than this; below it a\n"
         "complete chatter may be carried to its limit. Default: as soon as the\n"
         "limit is certain; 0: resolve until below rounding");
  option(run, "--max-impacts", request.options.max_impacts_per_period, "N",
         "Give up beyond this many impacts in one forcing period")
      ->check(any_count);
}

void check_times(const RunRequest &request) {
  if (!(request.from >= 0.0 && request.from <= request.until))
    refuse("--from {}: must lie between 0 and --until {}", request.from, request.until);
  // Sample times that rounding makes equal would never come to an end.
  if (!request.samples.empty() && request.every > 0.0 &&
      request.until + request.every == request.until)
    refuse("--every {}: too short for double precision to tell samples at --until {} apart",
           request.every, request.until);
}

void add_sweep_options(CLI::App &sweep, SweepRequest &request, std::vector<std::string> &ranges,
                       bool &no_lyapunov) {
  SettleOptions &settle = request.records.settle;
  option(sweep, "--vary", ranges, "RANGE",
         "parameter=from:to:count, repeatable; parameter is omega, beta,\n"
         "restitution, or restitution2 (of a stop), stop1 (its position),\n"
         "amplitude2, sine1, constant1, ground1, mass1, stiffness1,\n"
         "displacement1, velocity1")
      ->default_str("")
      ->required();
  option(sweep, "--longest", settle.longest, "N",
         "Forcing periods after which a motion counts as not settling")
      ->check(CLI::Range(1, 1'000'000));
  option(sweep, "--max-impacts", settle.run.max_impacts_per_period, "N",
         "Give up a point beyond this many impacts in one forcing period")
      ->check(any_count);
  sweep.add_flag("--no-lyapunov", no_lyapunov, "Leave out the Lyapunov exponent");
  sweep.add_flag("--pairs", request.records.pairs, "Add the pairs of events of Table I that occur");
  sweep.option_defaults()->configurable(false);  // the rows do not depend on these
  option(sweep, "--table", request.table, "FILE", "The table (CSV)")->required();
  sweep.add_flag("--resume", request.resume,
                 "Go on with the rows that a sweep that was ended has left in FILE.partial");
}

}  // namespace

Request parse(int argc, const char *const *argv, bool with_mpi) {
  SceneOptions scene;
  RunRequest run_request;
  SweepRequest sweep_request;
  std::vector<std::string> ranges;
  bool no_lyapunov = false;
  CLI::App app("Simulates a chain of masses with rigid stops under harmonic forcing",
               "vibro-impact");
  app.footer(footer(with_mpi));
  app.set_version_flag("--version", "vibro-impact " VIBRO_IMPACT_VERSION);
  app.require_subcommand(0, 1);
  CLI::App &run = *app.add_subcommand("run", "Run one scene and write its tables");
  CLI::App &sweep =
      *app.add_subcommand("sweep", "Record the settled motion at many parameter points");
  add_scene_options(run, scene);
  add_run_options(run, run_request);
  add_scene_options(sweep, scene);
  add_sweep_options(sweep, sweep_request, ranges, no_lyapunov);
  try {
    app.parse(reversed_arguments(argc, argv));
  } catch (const CLI::CallForVersion &version) {
    return fmt::format("{}\n", version.what());
  } catch (const CLI::CallForHelp &) {
    return app.help();
  } catch (const CLI::ParseError &error) {
    const std::vector<std::string> others = app.remaining(true);
    if (!others.empty()) refuse("not expected: {}", fmt::join(others, " "));
    refuse("{}", error.what());
  }
  if (app.get_subcommands().empty()) refuse("needs a command, run or sweep: --help says more");
  if (scene.print) {
    const CLI::App &command = run.parsed() ? run : sweep;
    scene_of(scene);  // refuses one that cannot be run
    return scene_file(command, scene);
  }
  if (run.parsed()) {
    check_times(run_request);
    run_request.scene = scene_of(scene);
    return run_request;
  }
  sweep_request.grid.scene = scene_of(scene);
  for (const std::string &range : ranges) sweep_request.grid.axes.push_back(axis_of(range));
  check(sweep_request.grid);
  sweep_request.records.lyapunov = !no_lyapunov;
  sweep_request.definition = given(sweep);
  return sweep_request;
}

}  // namespace vibro_impact::runner
