#include <algorithm>
#include <optional>
#include <type_traits>

#include "scene_text.hpp"
#include "words.hpp"

namespace vibro_impact::runner {

namespace {

constexpr long long any_count = 1'000'000'000'000'000;

// An option with one value: a word, a number that is not negative, or a whole number from 1 to
// `most`.
template <class Value>
CLI::Option *option(CLI::App &app, const std::string &name, Value &value, const char *type,
                    const std::string &what, long long most = 0) {
  constexpr bool may_be_empty = std::is_same_v<Value, std::optional<double>>,
                 is_number = may_be_empty || std::is_same_v<Value, double>;
  const auto read = [=, &value](const std::string &word) {
    if (word.empty()) refuse("{}: needs a value", name);
    if constexpr (std::is_same_v<Value, std::string>)
      value = word;
    else if constexpr (is_number)
      value = read_at(name, [&] { return number_of(word); });
    else
      value = static_cast<Value>(read_at(name, [&] { return count_of(word, most); }));
    if constexpr (is_number)
      if (!(value >= 0.0)) refuse("{} {}: must be non-negative", name, word);
  };
  CLI::Option *added = app.add_option_function<std::string>(name, read, what)->type_name(type);
  if constexpr (!may_be_empty) added->default_str(fmt::format("{}", value));
  return added;
}

void option(CLI::App &app, Output &output, const char *what) {
  option(app, output.option, output.path, "FILE", what);
}

void flag(CLI::App &app, const char *name, bool &value, const char *what) {
  app.add_flag(name, value, what)->disable_flag_override();
}

// The options of a scene have its names and the default scene as defaults.
void add_scene_options(CLI::App &app, Words &words) {
  const auto defaults = words_of(default_scene(2));
  auto add = [&, next = defaults.begin()](const char *type, const std::string &what) mutable {
    const auto &[name, value] = *next++;
    return app.add_option("--" + name, what)->type_name(type)->default_str(value);
  };
  app.option_defaults()->group(scene_group);
  add("N", "Number of masses");
  for (const auto &field : list_fields) add("LIST", field.meaning);
  for (const auto &field : scalar_fields) add("NUMBER", field.meaning);
  add("STOP",
      "mass:side:position or mass:side:position:restitution, with side lower or upper,\n"
      "repeatable; none: a chain without stops. A stop of the default that is on a mass\n"
      "which the chain does not have is left out")
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  app.option_defaults()->group("Options");
  // The rows of a sweep depend on the scene, not on the name of its file.
  option(app, "--scene", words.scene_file, "FILE",
         "Options of the scene, a line name = value each, or a table that was written with\n"
         "--header; options given here replace them")
      ->configurable(false);
  app.option_defaults()->configurable(false);
  flag(app, "--print-scene", words.print_scene, "Write the options of the scene as such a file");
  flag(app, "--header", words.header,
       "Begin each table with the options, in lines # name = value, which --scene reads");
  option(app, "--panels", words.panels, "LIST",
         "Masses that pictures show, one in each panel; default: all, and in a sweep those\n"
         "with a stop");
  app.option_defaults()->configurable(true);
}

void add_steps(CLI::App &app, RunOptions &options) {
  option(
      app, "--max-steps", options.max_steps, "N",
      "Give up beyond this many steps: one or more a flight, as short as the stiffest link asks\n"
      "for; the default is that of two masses, and falls with their number",
      any_count);
}

void add_settling(CLI::App &app, SettleOptions &options) {
  option(app, "--longest", options.longest, "N",
         "Forcing periods after which a motion counts as not settling", 1'000'000);
  option(app, "--largest-period", options.largest_period, "N",
         "The largest period that is looked for, in forcing periods", 1000);
  add_steps(app, options.run);
}

void add_files_of_run(CLI::App &app, RunRequest &request) {
  option(app, "--slowest", request.slowest, "SPEED",
         "Count the impacts of a chatter down to this speed, and list these and all that\n"
         "the run resolves; by default down to 1e-4 of the speed of its first impact");
  flag(app, "--velocities", request.velocities, "Add the velocities v1,v2,... to --samples");
  app.option_defaults()->configurable(false);  // the rows do not depend on these
  option(app, request.events, "Event table; - for standard output");
  option(app, request.samples, "Displacements time,x1,x2,...; - for standard output");
  option(app, request.summary,
         "For each stop: impacts down to --slowest, the largest speed, impulse and energy lost,\n"
         "sticks, time in contact, impulse of the pressing force; - for standard output.\n"
         "Impulse and energy are those of all impacts, also of infinitely many. The extremes\n"
         "of the displacement of each mass and its root mean square are printed");
  option(app, request.plot,
         "Picture of the tables, by gnuplot: displacements, stops and sticking of --samples,\n"
         "impacts of --events; .png, .pdf or .svg");
  option(app, request.portrait,
         "Picture of the velocities against the displacements at the times of --samples: a\n"
         "phase portrait with stops, jumps at impacts and sticking, or with --every 1P and\n"
         "more a Poincare section");
}

}  // namespace

long long default_steps(bool of_run, int masses) {
  const long long of_two_masses = of_run ? RunOptions().max_steps : 1'000'000, least = 20'000;
  return std::max(of_two_masses * 2 / std::max(masses, 2), least);
}

void add_run_options(CLI::App &run, RunRequest &request, Words &words) {
  request.options.max_steps = default_steps(true, 2);
  add_scene_options(run, words);
  option(run, "--until", words.until, "TIME", "End of the run; with a P behind it, in periods");
  option(run, "--from", words.from, "TIME", "Start of the tables; the run itself starts at t = 0");
  option(run, "--every", words.every, "TIME", "Interval between samples, > 0, counted from --from");
  option(run, "--resolve-chatter", request.options.limit_below_speed, "SPEED",
         "Resolve and record every chatter impact faster than this; below it a\n"
         "complete chatter may be carried to its limit. Default: as soon as the\n"
         "limit is certain; 0: resolve until below rounding");
  add_steps(run, request.options);
  add_files_of_run(run, request);
}

void add_orbit_options(CLI::App &orbit, OrbitRequest &request, Words &words) {
  request.settle.run.max_steps = default_steps(false, 2);
  add_scene_options(orbit, words);
  option(orbit, "--period", request.period, "N",
         "Forcing periods of the orbit, or a multiple of them; default: those of the settled\n"
         "motion",
         1000)
      ->default_str("");
  flag(orbit, "--near-start", request.near_start,
       "Look near --displacement and --velocity at once, not where their motion settles");
  add_settling(orbit, request.settle);
  orbit
      .add_option(
          "--vary", words.ranges,
          "parameter=from:to:count: follow the orbit through its folds and unstable parts,\n"
          "from the value of the scene in both directions, with steps of at most the\n"
          "distance of two of so many values; to where it ends, with the kind of the end")
      ->type_name("RANGE");
  option(orbit, "--every", words.every_in_orbit, "TIME", "Interval between samples of the orbit");
  add_files_of_run(orbit, request);
  option(orbit, request.table,
         "The orbit in one row, or those of --vary: period, residual, state, counts and\n"
         "fastest impact of each mass, multipliers multiplier1_re,...,multiplier1_im,...");
  option(orbit, "--column", request.column, "NAME",
         "With --vary, --plot shows the branch, stable parts full and unstable ones dashed,\n"
         "with its special points: this column of --table; default: the fastest impacts.\n"
         "At a fold the parameter turns round, at a flip the period doubles, and at a graze\n"
         "a mass touches a stop without speed. \"most points\": 1000 rows were written");
  option(orbit, "--diagram", request.diagram, "FILE",
         "Draw the branch over this table of a sweep along the same range: its --impacts, or\n"
         "with --column one that has the column");
}

void add_sweep_options(CLI::App &sweep, SweepRequest &request, Words &words) {
  RecordOptions &records = request.records;
  records.settle.run.max_steps = default_steps(false, 2);
  add_scene_options(sweep, words);
  sweep
      .add_option("--vary", words.ranges,
                  "parameter=from:to:count, repeatable, with :log behind it at equal ratios; a\n"
                  "parameter is an option of the scene that takes a NUMBER, one that takes a\n"
                  "LIST with the number of a mass, as amplitude2 or displacement1, or stop1 (the\n"
                  "position of the first stop), restitution1 (its own)")
      ->type_name("RANGE")
      ->required();
  add_settling(sweep, records.settle);
  option(sweep, "--slowest", records.slowest, "SPEED",
         "Write the impacts of a chatter down to this speed to --impacts; by default down\n"
         "to 1e-4 of the speed of the fastest impact");
  flag(sweep, "--lyapunov", records.lyapunov,
       "Add the greatest Lyapunov exponent and its standard error to --table");
  option(sweep, "--exponent-periods", records.growth.longest, "N",
         "Forcing periods over which the exponent of an irregular motion is averaged; its\n"
         "error is known from 640 on",
         1'000'000);
  flag(sweep, "--attractor", records.attractor,
       "Add the number of the attractor to --table: 1, 2, ... as they appear there, among\n"
       "motions that differ in their start alone. Mirror images are two attractors");
  flag(sweep, "--response", records.response,
       "Add the extremes and the root mean square of each displacement to --table");
  flag(sweep, "--pairs", records.pairs, "Add the pairs of events of Table I that occur");
  flag(sweep, "--follow", request.follow,
       "Start each point at the settled state of its neighbour along the last range,\n"
       "which goes down where `from` lies above `to`. Points that are refused or given up\n"
       "are passed over");
  flag(sweep, "--back", request.back, "Follow the last range to its end and back");
  sweep.option_defaults()->configurable(false);  // the rows do not depend on these
  option(sweep, request.tables[0], "Periods and counts of the settled motions");
  option(sweep, request.tables[1],
         "Their impacts, with the velocity before, the stop, the phase and the impulse; over\n"
         "one period, or 40 forcing periods of a motion that has not settled");
  option(sweep, request.tables[2],
         "Their states at the phase of the start: parameters,x1,x2,...,v1,v2,...");
  option(sweep, request.plot,
         "Picture by gnuplot. With one range: --impacts against the parameter, without them\n"
         "--section (displacements), with --column this column of --table. With two ranges:\n"
         "a map of --column, with a colour for each of its most frequent values. A motion is\n"
         "\"irregular\" if it comes near no orbit, and of one that does so too slowly no period\n"
         "is found. A motion without impacts has no point. .png, .pdf or .svg");
  option(sweep, "--column", request.column, "NAME", "Column of --table in --plot; of maps: period");
  option(sweep, "--part", words.part, "K/N",
         "Compute the K-th of N consecutive parts of the points alone. The tables of all\n"
         "parts, put together in their order, are those of the sweep");
}

}  // namespace vibro_impact::runner
