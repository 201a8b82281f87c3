#include "options.hpp"

#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <type_traits>

#include "scene_text.hpp"

namespace vibro_impact::runner {

namespace {

constexpr const char *scene_group = "Scene";

// The values of a parameter, given as parameter=from:to:count.
Axis axis_of(std::string_view text) {
  const auto sides = detail::parts_of(text, '='), range = detail::parts_of(sides.back(), ':');
  if (sides.size() != 2 || range.size() != 3)
    detail::refuse_words(text, "must read parameter=from:to:count");
  const Axis axis{std::string(sides[0]), detail::number_of(range[0]), detail::number_of(range[1]),
                  static_cast<std::size_t>(detail::count_of(range[2], 1'000'000'000))};
  if (axis.count > 1 && axis.from == axis.to)
    detail::refuse_words(text, "has equal values; one is enough");
  return axis;
}

// A time, or with a P behind it a number of forcing periods.
double time_of(std::string_view word, double omega) {
  if (!word.ends_with('P')) return detail::number_of(word);
  if (omega == 0.0) detail::refuse_words(word, "without a forcing frequency there is no period");
  return detail::number_of(word.substr(0, word.size() - 1)) * Clock(omega).period;
}

// The options of a command on which its rows depend (CLI11 calls these configurable), as far as
// they were given, but for those of the scene: words --name=value in one line.
std::string given(const CLI::App &app) {
  std::string text;
  for (const CLI::Option *option : app.get_options())
    for (const std::string &value : option->results())
      if (option->get_configurable() && option->get_group() != scene_group)
        text += fmt::format(" {}={}", option->get_name(), value);
  return text;
}

// The file of a scene, whose lines may begin with a mark.
std::string file_of(const Scene &scene, const char *mark = "") {
  std::string text;
  for (const auto &[name, words] : words_of(scene))
    text += fmt::format("{}{} = {}\n", mark, name, words);
  return text;
}

constexpr long long any_count = 1'000'000'000'000'000;
constexpr double most_numbers = 5e7;  // in a table of samples, which then has about 1 GB

// With the default bound a run, or a point of a sweep, ends within some ten seconds, or two. A step
// takes 2 microseconds with two masses and 22 with a hundred.
constexpr long long steps_of_run = 3'000'000, steps_of_point = 1'000'000, least_steps = 20'000;

long long default_steps(long long steps_of_two, int masses) {
  return std::max(steps_of_two * 2 / std::max(masses, 2), least_steps);
}

// The words that both commands have in common, and the times and ranges as they were given.
struct Words {
  std::string scene_file, until = "750", from = "0", every = "0.01", panels;
  std::vector<std::string> ranges;
  bool print_scene = false, header = false;
};

// An option with one value: a word, a number, or a whole number from 1 to `most`.
template <class Value>
CLI::Option *option(CLI::App &app, const std::string &name, Value &value, const char *type,
                    const std::string &what, long long most = 0) {
  const auto read = [=, &value](const std::string &word) {
    if (word.empty()) refuse("{}: needs a value", name);
    if constexpr (std::is_same_v<Value, std::string>)
      value = word;
    else if constexpr (std::is_same_v<Value, double> ||
                       std::is_same_v<Value, std::optional<double>>)
      value = read_at(name, [&] { return detail::number_of(word); });
    else
      value = static_cast<Value>(read_at(name, [&] { return detail::count_of(word, most); }));
  };
  CLI::Option *added = app.add_option_function<std::string>(name, read, what)->type_name(type);
  if constexpr (!std::is_same_v<Value, std::optional<double>>)
    added->default_str(fmt::format("{}", value));
  return added;
}

// The masses that have a panel: those that were given, or all, or those with a stop.
std::vector<int> panels_of(const Scene &scene, const std::string &words, bool all) {
  std::vector<int> panels;
  if (!words.empty())
    for (const std::string_view word : detail::parts_of(words, ','))
      panels.push_back(static_cast<int>(
          read_at("--panels", [&] { return detail::count_of(word, scene.masses()); })));
  for (int mass = 1; mass <= scene.masses() && words.empty(); ++mass)
    if (all || std::ranges::find(scene.stops, mass, &Stop::mass) != scene.stops.end())
      panels.push_back(mass);
  return panels;
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
         "Masses that pictures show, in panels of their own");
  app.option_defaults()->configurable(true);
}

// The scene of a command: its options, and the lines of its file where no option replaces them.
Scene scene_of(const CLI::App &command, const std::string &file) {
  std::vector<SceneLine> lines;
  if (!file.empty()) lines = scene_lines(file);
  for (const CLI::Option *option : command.get_options()) {
    if (option->get_group() != scene_group || option->empty()) continue;
    const std::string name = option->get_single_name();
    std::erase_if(lines, [&](const SceneLine &line) { return line.name == name; });
    lines.push_back({name, "--" + name, fmt::format("{}", fmt::join(option->results(), ","))});
  }
  return runner::scene_of(lines);
}

void add_limits(CLI::App &app, RunOptions &options) {
  option(
      app, "--max-steps", options.max_steps, "N",
      "Give up beyond this many steps: one or more a flight, as short as the stiffest link asks\n"
      "for; the default is that of two masses, and falls with their number",
      any_count);
}

void add_run_options(CLI::App &run, RunRequest &request, Words &times) {
  option(run, "--until", times.until, "TIME", "End of the run; with a P behind it, in periods");
  option(run, "--from", times.from, "TIME", "Start of the tables; the run itself starts at t = 0");
  option(run, "--every", times.every, "TIME", "Interval between samples, > 0, counted from --from");
  flag(run, "--velocities", request.velocities, "Add the velocities v1,v2,... to --samples");
  option(run, "--resolve-chatter", request.options.limit_below_speed, "SPEED",
         "Resolve and record every chatter impact faster than this; below it a\n"
         "complete chatter may be carried to its limit. Default: as soon as the\n"
         "limit is certain; 0: resolve until below rounding");
  add_limits(run, request.options);
  run.option_defaults()->configurable(false);  // the rows do not depend on these
  option(run, request.events, "Event table; - for standard output");
  option(run, request.samples, "Displacements time,x1,x2,...; - for standard output");
  option(run, request.summary,
         "For each stop, from --from to --until: impacts, their speeds, impulse and energy\n"
         "lost, sticks, time in contact, impulse of the pressing force; - for standard output.\n"
         "The speeds are those of resolved impacts (--resolve-chatter)");
  option(run, request.plot,
         "Picture of the tables, by gnuplot: displacements, stops and sticking of --samples,\n"
         "impacts of --events; .png, .pdf or .svg. --from and --until zoom");
  option(run, request.portrait,
         "Picture of the velocities of --samples against the displacements: a phase\n"
         "portrait, or with --every 1P and more a Poincare section");
}

void check_samples(const RunRequest &request) {
  // Sample times that rounding makes equal would never come to an end.
  if (request.until + request.every == request.until)
    refuse("--every {}: too short for double precision to tell samples at --until {} apart",
           request.every, request.until);
  const double samples = std::floor((request.until - request.from) / request.every) + 1.0;
  const int columns = 1 + request.scene.masses() * (request.velocities ? 2 : 1);
  if (samples * columns > most_numbers)
    refuse("--every {}: {} samples of {} numbers, and a table has at most {} numbers",
           request.every, samples, columns, most_numbers);
  for (const Output &picture : {request.plot, request.portrait})
    if (picture.wanted() && samples < 2.0)
      refuse("{}: needs at least two samples, and --every {} gives one", picture.given(),
             request.every);
}

// Adds to the options of a run what depends on its scene.
void complete(RunRequest &request, const Scene &scene, const Words &words) {
  const auto time = [&](const char *option, const std::string &word) {
    return read_at(option, [&] { return time_of(word, scene.omega); });
  };
  request.scene = scene;
  request.until = time("--until", words.until);
  request.from = time("--from", words.from);
  request.every = time("--every", words.every);
  if (!(request.from >= 0.0 && request.from <= request.until))
    refuse("--from {}: must lie between 0 and --until {}", request.from, request.until);
  if (request.samples.wanted() && request.every > 0.0) check_samples(request);
}

void add_sweep_options(CLI::App &sweep, SweepRequest &request, std::vector<std::string> &ranges) {
  RecordOptions &records = request.records;
  sweep
      .add_option("--vary", ranges,
                  "parameter=from:to:count, repeatable; a parameter is an option of the scene\n"
                  "that takes a NUMBER, one that takes a LIST with the number of a mass, as\n"
                  "amplitude2, or stop1 (the position of the first stop), restitution1 (its own)")
      ->type_name("RANGE")
      ->required();
  option(sweep, "--longest", records.settle.longest, "N",
         "Forcing periods after which a motion counts as not settling", 1'000'000);
  add_limits(sweep, records.settle.run);
  option(sweep, "--slowest", records.slowest, "SPEED",
         "Write the impacts of a chatter down to this speed to --impacts; by default down\n"
         "to 1e-4 of the speed of the fastest impact");
  flag(sweep, "--lyapunov", records.lyapunov, "Add the greatest Lyapunov exponent");
  flag(sweep, "--pairs", records.pairs, "Add the pairs of events of Table I that occur");
  flag(sweep, "--follow", request.follow,
       "Start each point at the settled state of its neighbour along the last range,\n"
       "which goes down where `from` lies above `to`");
  flag(sweep, "--back", request.back, "Follow the last range to its end and back");
  sweep.option_defaults()->configurable(false);  // the rows do not depend on these
  option(sweep, request.tables[0], "Periods and counts of the settled motions");
  option(sweep, request.tables[1],
         "Their impacts: parameters,mass,velocity, the velocity before the impact; over\n"
         "one period, or 40 forcing periods of a motion that has not settled");
  option(sweep, request.tables[2],
         "Their states at the phase of the start: parameters,x1,x2,...,v1,v2,...");
  option(sweep, request.plot,
         "Picture by gnuplot: --impacts against the parameter, or with two ranges a map of\n"
         "--column of --table; .png, .pdf or .svg");
  option(sweep, "--column", request.column, "NAME", "Column of the map");
  flag(sweep, "--resume", request.resume,
       "Go on with the rows that a sweep that was ended has left in FILE.partial");
}

}  // namespace

Request parse(int argc, const char *const *argv) {
  Words words;
  RunRequest run_request;
  SweepRequest sweep_request;
  CLI::App app("Simulates a chain of masses with rigid stops under harmonic forcing",
               "vibro-impact");
  app.footer(footer());
  app.set_version_flag("--version", "vibro-impact " VIBRO_IMPACT_VERSION);
  app.require_subcommand(0, 1);
  CLI::App &run = *app.add_subcommand("run", "Run one scene and write its tables");
  CLI::App &sweep =
      *app.add_subcommand("sweep", "Record the settled motion at many parameter points");
  RunOptions &of_point = sweep_request.records.settle.run;
  run_request.options.max_steps = steps_of_run;
  of_point.max_steps = steps_of_point;
  add_scene_options(run, words);
  add_run_options(run, run_request, words);
  add_scene_options(sweep, words);
  add_sweep_options(sweep, sweep_request, words.ranges);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForVersion &version) {
    return fmt::format("{}\n", version.what());
  } catch (const CLI::CallForHelp &) {
    return app.help();
  } catch (const CLI::ParseError &error) {
    const std::vector<std::string> others = app.remaining(true);
    if (!others.empty())
      refuse("not expected: {}; the commands are run and sweep, and --help says more",
             shown(fmt::format("{}", fmt::join(others, " "))));
    refuse("{}", error.what());
  }
  if (app.get_subcommands().empty()) refuse("needs a command, run or sweep: --help says more");
  const CLI::App &command = run.parsed() ? run : sweep;
  const Scene scene = scene_of(command, words.scene_file);
  if (words.print_scene) return file_of(scene);
  RunOptions &options = run.parsed() ? run_request.options : of_point;
  if (command.count("--max-steps") == 0)
    options.max_steps = default_steps(options.max_steps, scene.masses());
  const std::string definition =
      fmt::format("{}{} {}{}\n{}", table_head, VIBRO_IMPACT_VERSION, command.get_name(),
                  given(command), file_of(scene, "# "));
  Common &common = run.parsed() ? static_cast<Common &>(run_request) : sweep_request;
  common = {words.scene_file, words.header ? definition : "",
            panels_of(scene, words.panels, run.parsed())};
  if (run.parsed()) {
    complete(run_request, scene, words);
    return run_request;
  }
  sweep_request.definition = definition;
  sweep_request.grid.scene = scene;
  for (const std::string &range : words.ranges)
    sweep_request.grid.axes.push_back(read_at("--vary", [&] { return axis_of(range); }));
  check(sweep_request.grid);
  sweep_request.follow = sweep_request.follow || sweep_request.back;
  sweep_request.records.impact_velocities = sweep_request.tables[1].wanted();
  sweep_request.records.section = sweep_request.tables[2].wanted();
  return sweep_request;
}

}  // namespace vibro_impact::runner
