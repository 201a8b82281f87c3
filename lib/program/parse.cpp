#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "scene_text.hpp"
#include "vibro_impact/analysis/follow_orbit.hpp"
#include "words.hpp"

namespace vibro_impact::runner {

namespace {

constexpr double most_numbers = 5e7;  // in a table of samples, which then has about 1 GB

// The values of a parameter, given as parameter=from:to:count or parameter=from:to:count:log.
Axis axis_of(std::string_view text) {
  return read_at("--vary", [&] {
    const auto sides = parts_of(text, '='), range = parts_of(sides.back(), ':');
    const bool logarithmic = range.size() == 4 && range[3] == "log";
    if (sides.size() != 2 || range.size() != (logarithmic ? 4 : 3))
      refuse_words(text, "must read parameter=from:to:count or parameter=from:to:count:log");
    const Axis axis{std::string(sides[0]), number_of(range[0]), number_of(range[1]),
                    static_cast<std::size_t>(count_of(range[2], 1'000'000'000)), logarithmic};
    if (axis.count > 1 && axis.from == axis.to)
      refuse_words(text, "has equal values; one is enough");
    return axis;
  });
}

// A time, or with a P behind it a number of forcing periods.
double time_of(const std::string &option, std::string_view word, double omega) {
  return read_at(option, [&] {
    const bool in_periods = word.ends_with('P');
    if (in_periods && omega == 0.0)
      refuse_words(word, "without a forcing frequency there is no period");
    try {
      const double number = number_of(word.substr(0, word.size() - (in_periods ? 1 : 0)));
      return in_periods ? number * Clock(omega).period : number;
    } catch (const std::invalid_argument &) {
      refuse_words(word, "is not a number, nor one with a P behind it");
    }
  });
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

bool has(const CLI::App &app, const char *name) {
  const CLI::Option *option = app.get_option_no_throw(name);
  return option != nullptr && !option->empty();
}

// Refuses options that add to what is not asked for.
void check_combinations(const CLI::App &app) {
  for (const auto &[option, needed] : {std::pair{"--lyapunov", "--table"},
                                       {"--pairs", "--table"},
                                       {"--attractor", "--table"},
                                       {"--response", "--table"},
                                       {"--exponent-periods", "--lyapunov"},
                                       {"--column", "--plot"},
                                       {"--column", "--vary"},
                                       {"--diagram", "--plot"},
                                       {"--diagram", "--vary"},
                                       {"--every", "--samples"},
                                       {"--velocities", "--samples"}})
    if (has(app, option) && !has(app, needed)) refuse("{}: needs {}", option, needed);
  if (has(app, "--panels") && !has(app, "--plot") && !has(app, "--portrait"))
    refuse("--panels: needs a picture");
  if (has(app, "--from") && !has(app, "--events") && !has(app, "--samples") &&
      !has(app, "--summary"))
    refuse("--from: needs --events, --samples or --summary");
  if (has(app, "--slowest") && !has(app, "--impacts") && !has(app, "--events") &&
      !has(app, "--summary"))
    refuse("--slowest: needs {}",
           app.get_option_no_throw("--impacts") != nullptr ? "--impacts" : "--events or --summary");
  for (const char *option : {"--longest", "--largest-period"})
    if (has(app, option) && has(app, "--near-start"))
      refuse("{}: bounds the settling, which --near-start omits", option);
}

// The file of a scene, whose lines may begin with a mark.
std::string file_of(const Scene &scene, const char *mark = "") {
  std::string text;
  for (const auto &[name, words] : words_of(scene))
    text += fmt::format("{}{} = {}\n", mark, name, words);
  return text;
}

// The masses that have a panel: those that were given, or all, or those with a stop.
std::vector<int> panels_of(const Scene &scene, const std::string &words, bool all) {
  std::vector<int> panels;
  all = all || scene.stops.empty();
  if (!words.empty())
    for (const std::string_view word : parts_of(words, ',')) {
      const auto mass =
          static_cast<int>(read_at("--panels", [&] { return count_of(word, scene.masses()); }));
      if (std::ranges::find(panels, mass) != panels.end())
        refuse("--panels {}: has mass {} twice", words, mass);
      panels.push_back(mass);
    }
  for (int mass = 1; mass <= scene.masses() && words.empty(); ++mass)
    if (all || std::ranges::find(scene.stops, mass, &Stop::mass) != scene.stops.end())
      panels.push_back(mass);
  return panels;
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

// Adds to the options of a run the interval of its samples. Sample times that rounding makes equal
// would never come to an end.
void complete_samples(RunRequest &request, const std::string &every, const std::string &until) {
  request.every = time_of("--every", every, request.scene.omega);
  if (!(request.every > 0.0)) refuse("--every {}: must be positive", every);
  if (!request.samples.wanted()) return;
  if (request.until + request.every == request.until)
    refuse("--every {}: too short for double precision to tell samples at --until {} apart", every,
           until);
  const double samples = std::floor((request.until - request.from) / request.every) + 1.0;
  const int columns = 1 + request.scene.masses() * (request.velocities ? 2 : 1);
  if (samples * columns > most_numbers)
    refuse("--every {}: {} samples of {} numbers, and a table has at most {} numbers", every,
           samples, columns, most_numbers);
  for (const Output &picture : {request.plot, request.portrait})
    if (picture.wanted() && samples < 2.0)
      refuse("{}: needs at least two samples, and --every {} gives one", picture.given(), every);
}

// Adds to the options of a run its times.
void complete(RunRequest &request, const Words &words) {
  const double omega = request.scene.omega;
  request.until = time_of("--until", words.until, omega);
  request.from = time_of("--from", words.from, omega);
  if (!std::isfinite(request.until)) refuse("--until {}: must be finite", words.until);
  if (!(request.from >= 0.0 && request.from <= request.until))
    refuse("--from {}: must lie between 0 and --until {}", words.from, words.until);
  complete_samples(request, words.every, words.until);
}

// Adds to the options of an orbit its range, and its samples over the most periods that it may
// have.
void complete(OrbitRequest &request, const Words &words) {
  if (request.scene.omega == 0.0) refuse("--omega 0: an orbit needs a forcing period");
  const int periods = request.period > 0 ? request.period : request.settle.largest_period;
  request.until = periods * Clock(request.scene.omega).period;
  complete_samples(request, words.every_in_orbit, "the end");
  if (words.ranges.empty()) return;
  if (words.ranges.size() > 1) refuse("--vary: an orbit is followed along one range");
  request.range = axis_of(words.ranges.front());
  if (request.range->logarithmic)
    refuse("--vary {}: an orbit is followed in equal steps, without log", words.ranges.front());
  if (!request.table.wanted()) refuse("--vary {}: needs --table", words.ranges.front());
  check_range(request.scene, *request.range);
}

// Adds to the options of a sweep its grid.
void complete(SweepRequest &request, const Words &words) {
  for (const std::string &range : words.ranges) request.grid.axes.push_back(axis_of(range));
  check(request.grid);
  read_at("--part", [&] {
    const auto parts = parts_of(words.part, '/');
    if (parts.size() != 2) refuse_words(words.part, "must read K/N");
    request.parts = static_cast<std::size_t>(count_of(parts[1], 1'000'000'000));
    request.part =
        static_cast<std::size_t>(count_of(parts[0], static_cast<long long>(request.parts)));
  });
  if (request.parts > 1 && request.plot.wanted())
    refuse("--part {}: a picture needs all parts", words.part);
  if (request.parts > 1 && request.records.attractor)
    refuse(
        "--part {}: attractors are numbered in the order of all rows; the states of --section "
        "tell those of several parts apart",
        words.part);
  if (!words.panels.empty() && (request.grid.axes.size() > 1 || !request.column.empty()))
    refuse("--panels {}: a picture of a column has one panel", words.panels);
  request.follow = request.follow || request.back;
  request.records.impacts = request.tables[1].wanted();
  request.records.section = request.tables[2].wanted();
}

}  // namespace

Request parse(int argc, const char *const *argv) {
  Words words;
  RunRequest run_request;
  OrbitRequest orbit_request;
  SweepRequest sweep_request;
  CLI::App app("Simulates a chain of masses with rigid stops under harmonic forcing",
               "vibro-impact");
  app.footer(footer_of_program());
  app.set_version_flag("--version", "vibro-impact " VIBRO_IMPACT_VERSION);
  app.require_subcommand(0, 1);
  CLI::App &run = *app.add_subcommand("run", "Run one scene and write its tables");
  CLI::App &orbit = *app.add_subcommand("orbit", "Find a periodic orbit and its multipliers");
  CLI::App &sweep =
      *app.add_subcommand("sweep", "Record the settled motion at many parameter points");
  run.footer(footer_of_run());
  add_run_options(run, run_request, words);
  orbit.footer(footer_of_orbit());
  add_orbit_options(orbit, orbit_request, words);
  sweep.footer(footer_of_sweep());
  add_sweep_options(sweep, sweep_request, words);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForVersion &version) {
    return fmt::format("{}\n", version.what());
  } catch (const CLI::CallForHelp &) {
    return app.help();
  } catch (const CLI::ParseError &error) {
    const std::vector<std::string> others = app.remaining(true);
    for (const auto &[word, option] :
         {std::pair{"--damping", "--beta"}, {"--gap", "--stop"}, {"--force", "--amplitude"}})
      if (!others.empty() && others.front().starts_with(word))
        refuse("{}: is no option; {} may be meant", word, option);
    if (!others.empty())
      refuse("not expected: {}; the commands are run, orbit and sweep, and --help says more",
             shown(fmt::format("{}", fmt::join(others, " "))));
    refuse("{}", error.what());
  }
  if (app.get_subcommands().empty())
    refuse("needs a command, run, orbit or sweep: --help says more");
  const CLI::App &command = *app.get_subcommands().front();
  const Scene scene = scene_of(command, words.scene_file);
  if (words.print_scene) return file_of(scene);
  std::string head;
  if (words.header)
    head = fmt::format("{}{} {}{}\n{}", table_head, VIBRO_IMPACT_VERSION, command.get_name(),
                       given(command), file_of(scene, "# "));
  check_combinations(command);
  const Common common{words.scene_file, head, panels_of(scene, words.panels, !sweep.parsed())};
  const bool default_bound = command.count("--max-steps") == 0;
  const auto completed = [&](auto &request, Scene &of_request, RunOptions &options) {
    static_cast<Common &>(request) = common;
    of_request = scene;
    if (default_bound) options.max_steps = default_steps(run.parsed(), scene.masses());
    complete(request, words);
    return request;
  };
  if (run.parsed()) return completed(run_request, run_request.scene, run_request.options);
  if (orbit.parsed())
    return completed(orbit_request, orbit_request.scene, orbit_request.settle.run);
  return completed(sweep_request, sweep_request.grid.scene, sweep_request.records.settle.run);
}

}  // namespace vibro_impact::runner
