#include "options.hpp"

#include <fmt/ranges.h>

#include <cmath>

#include "refuse.hpp"
#include "scene_options.hpp"

namespace vibro_impact::runner {

namespace {

constexpr const char *notes =
    R"(All quantities are non-dimensional. Masses are counted
from 1; the link of mass i joins it to mass i - 1 (mass 1 to the ground). A single value stands
for all masses; a list has one value per mass, separated by commas. The defaults are those of
Wagg (2006), Figure 2 (its omega is reconstructed, not printed).

Example:
  vibro-impact run --omega 0.2797 --stop 1:lower:-0.3 --stop 2:upper:0.1 --until 750 --from 700
    --events events.csv --samples samples.csv --every 0.01 --plot run.png
Events: time,mass,event,velocity_before,velocity_after,contact_mode; event is impact, stick or
release; contact_mode lists the stuck masses after the event (-, 1, 2, 1+2).

Example:
  mpirun -n 4 vibro-impact sweep --vary omega=0.25:0.7:901 --vary stop1=-0.4:-0.2:81
    --table atlas.csv
The points are those of nested loops, the first range outermost; the table does not depend on
threads (OMP_NUM_THREADS, of the first process) and processes. Columns: the parameters; period
(in forcing periods, 0: none up to 8); sticks and impacts of every mass per forcing period (a
mean over the period, or over 40; impacts of a complete chatter, infinitely many, are not
counted); dual_sticking (1: two masses are held at some time); lyapunov (greatest Lyapunov
exponent, per unit of time; empty: its sign is not certain); pairs (DG, DS, DI, GS, GI, SI or
-). A point that is given up has empty cells. FILE.partial has the rows until all are there.

Ctrl-C ends both; --resume goes on, a run from --save-state, a sweep from its rows.
Exit status: 0 done, 1 the run was given up or a file could not be written, 2 bad input, 130
ended by Ctrl-C (128 + the number of the signal).)";

const CLI::Range any_count(1LL, 1'000'000'000'000'000LL);

void add_run_options(CLI::App &run, Request &request) {
  run.option_defaults()->configurable(false);  // the motion does not depend on them
  option(run, "--until", request.until, "TIME", "End of the run, > 0");
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
  option(run, "--save-state", request.save_state, "FILE",
         "The scene and the state at the end of the run, for --resume");
  option(run, "--resume", request.resume, "FILE",
         "Go on from a saved state, with its scene: options of the scene cannot be\n"
         "given. The tables hold what comes after it; for those of one whole run,\n"
         "give the other options as before");
  option(run, "--resolve-chatter", request.options.resolve_chatter, "SPEED",
         "Resolve and record every chatter impact faster than this; below it a\n"
         "complete chatter may be carried to its limit. Default: as soon as the\n"
         "limit is certain; 0: resolve until below rounding");
  option(run, "--max-impacts", request.options.max_impacts_per_period, "N",
         "Give up beyond this many impacts in one forcing period")
      ->check(any_count);
}

void check_run(const Request &request) {
  if (!(request.until > 0.0 && std::isfinite(request.until)))
    refuse("--until {}: must be positive and finite", request.until);
  if (!(request.from >= 0.0 && request.from <= request.until))
    refuse("--from {}: must lie between 0 and --until {}", request.from, request.until);
  if (!(request.every > 0.0 && std::isfinite(request.every)))
    refuse("--every {}: must be positive and finite", request.every);
  // Sample times that rounding makes equal would never come to an end.
  if (!request.samples.empty() && !(request.until + request.every > request.until))
    refuse("--every {}: too short for double precision to tell samples at --until {} apart",
           request.every, request.until);
  if (!(request.options.resolve_chatter >= 0.0))
    refuse("--resolve-chatter {}: must be non-negative", request.options.resolve_chatter);
}

void add_sweep_options(CLI::App &sweep, SweepRequest &request, std::vector<std::string> &ranges) {
  SettleOptions &settle = request.records.settle;
  request.records.lyapunov = true;
  option(sweep, "--vary", ranges, "RANGE",
         "parameter=from:to:count, repeatable; parameter is omega, beta,\n"
         "restitution, or restitution2 (of a stop), stop1 (its position),\n"
         "amplitude2, mass1, stiffness1, displacement1, velocity1")
      ->default_str("")
      ->required();
  option(sweep, "--longest", settle.longest, "N",
         "Forcing periods after which a motion counts as not settling")
      ->check(CLI::Range(1, 1'000'000));
  option(sweep, "--max-impacts", settle.run.max_impacts_per_period, "N",
         "Give up a point beyond this many impacts in one forcing period")
      ->check(any_count);
  sweep.add_flag("--no-lyapunov{false}", request.records.lyapunov,
                 "Leave out the Lyapunov exponent");
  sweep.add_flag("--pairs", request.records.pairs, "Add the pairs of events of Table I that occur");
  sweep.option_defaults()->configurable(false);  // the rows do not depend on them
  option(sweep, "--table", request.table, "FILE", "The table (CSV)")->required();
  sweep.add_flag("--resume", request.resume,
                 "Go on with what a sweep that was ended left of --table");
}

}  // namespace

std::optional<std::string> parse(int argc, char **argv, Request &request) {
  SceneOptions scene;
  SweepRequest swept;
  std::vector<std::string> ranges;
  CLI::App app("Simulates a chain of masses with rigid stops under harmonic forcing",
               "vibro-impact");
  app.footer(notes);
  app.set_version_flag("--version", "vibro-impact " VIBRO_IMPACT_VERSION);
  app.require_subcommand(0, 1);
  CLI::App &run = *app.add_subcommand("run", "Run one scene and write its tables"),
           &sweep =
               *app.add_subcommand("sweep", "Record the settled motion at many parameter points");
  add_scene_options(run, scene);
  add_run_options(run, request);
  add_scene_options(sweep, scene);
  add_sweep_options(sweep, swept, ranges);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForVersion &version) {
    return fmt::format("{}\n", version.what());
  } catch (const CLI::CallForHelp &) {
    return app.help();
  } catch (const CLI::ParseError &error) {
    const std::vector<std::string> others = app.remaining(true);
    if (!others.empty()) refuse("not expected: {}", fmt::join(others, " "));
    const std::string said = error.what();
    const std::size_t twice = said.find("At Most 1");
    refuse("{}", twice < said.size() ? said.substr(0, twice) + "may be given once" : said);
  }
  if (app.get_subcommands().empty()) refuse("needs a command, run or sweep: --help says more");

  if (run.parsed()) check_run(request);
  request.scene_text = given(run);
  if (!request.resume.empty()) {
    if (!request.scene_text.empty())
      refuse("--resume {}: the scene comes from there, and cannot be changed by{}", request.resume,
             request.scene_text);
    return std::nullopt;
  }
  request.scene = scene_of(scene);
  if (run.parsed()) return std::nullopt;
  swept.grid.scene = request.scene;
  for (const std::string &range : ranges) swept.grid.axes.push_back(axis_of(range));
  check(swept.grid);
  swept.definition = VIBRO_IMPACT_VERSION + given(sweep);
  request.sweep = std::move(swept);
  return std::nullopt;
}

}  // namespace vibro_impact::runner
