#include "options.hpp"

#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>

#include "files.hpp"

namespace vibro_impact::runner {

namespace {

// The options of a scene, which `run` and `sweep` share, as they were given. The defaults are the
// scene of the paper's Figure 2, and stand nowhere else in the program; a test compares them with
// the scenes of the paper.
struct SceneOptions {
  int masses = 2;
  double beta = 0.1, restitution = 0.7, omega = 0.2797;
  std::string mass = "1", stiffness = "1", displacement = "0", velocity = "0";
  std::string amplitude = {};  // empty: 0.5 on mass 1, however many masses there are
  std::vector<std::string> stops = {"1:lower:-0.3", "2:upper:0.1"};
};

// An option that takes one value.
template <class Value>
CLI::Option *option(CLI::App &app, const char *name, Value &value, const char *type,
                    const std::string &what) {
  CLI::Option *added = app.add_option(name, value, what)->type_name(type)->capture_default_str();
  if constexpr (std::is_same_v<Value, double>) added->check(CLI::Number);
  return added->check([](const std::string &word) { return word.empty() ? "needs a value" : ""; });
}

constexpr double default_amplitude = 0.5;  // on mass 1

// Longer chains are taken for a slip of the pen: the modes of a chain take cubic work.
constexpr int most_masses = 10000;

// The parts of `text` between separators. Parts may be empty.
std::vector<std::string> split(const std::string &text, char separator) {
  return CLI::detail::split(text + separator, separator);
}

// The number that a whole word of `given` stands for; from_chars knows no locale and no leading
// space.
double number(const std::string &given, const std::string &word) {
  double value = 0.0;
  const char *end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (stop != end || error != std::errc())
    refuse("{}: '{}' is not a number in double precision", given, word);
  return value;
}

int whole_number(const std::string &given, const std::string &word, double most) {
  const double value = number(given, word);
  if (!(value >= 1.0 && value <= most && value == std::floor(value)))
    refuse("{}: '{}' must be a whole number from 1 to {}", given, word, most);
  return static_cast<int>(value);
}

// The values of a list separated by commas: one value per mass, or a single one for all.
std::vector<double> per_mass(const std::string &option, const std::string &text,
                             std::size_t masses) {
  const std::string given = option + " " + text;
  std::vector<double> values;
  for (const std::string &word : split(text, ',')) values.push_back(number(given, word));
  if (values.size() == 1) values.assign(masses, values.front());
  if (values.size() != masses)
    refuse("{}: {} values given, the chain has {} masses", given, values.size(), masses);
  return values;
}

// The stop given as mass:side:position, or with a restitution of its own as a fourth part.
Stop stop_of(const std::string &text) {
  const std::string given = "--stop " + text;
  const auto parts = split(text, ':');
  if (parts.size() < 3 || parts.size() > 4 || (parts[1] != "lower" && parts[1] != "upper"))
    refuse(
        "{}: must read mass:side:position or mass:side:position:restitution, with side lower "
        "or upper",
        given);
  Stop stop{whole_number(given, parts[0], most_masses),
            parts[1] == "lower" ? Side::lower : Side::upper, number(given, parts[2])};
  if (parts.size() == 4) stop.restitution = number(given, parts[3]);
  return stop;
}

void add_scene_options(CLI::App &app, SceneOptions &words) {
  option(app, "--masses", words.masses, "N", "Number of masses")->check(CLI::Range(1, most_masses));
  option(app, "--mass", words.mass, "LIST", "m_i > 0");
  option(app, "--stiffness", words.stiffness, "LIST",
         "k_i > 0, link by link; k_1 = 0: a free chain, not tied to the ground");
  option(app, "--beta", words.beta, "NUMBER",
         "Factor of the damping C = beta K, the paper's c / k: the dampers of the links\n"
         "are proportional to their stiffness");
  option(app, "--restitution", words.restitution, "NUMBER",
         "Coefficient of restitution r in [0, 1] of the stops that have none of their own");
  option(
      app, "--amplitude", words.amplitude, "LIST",
      fmt::format("A_i of the forcing A cos(Omega t). Default: {} on mass 1", default_amplitude));
  option(app, "--omega", words.omega, "NUMBER",
         "Forcing frequency Omega >= 0; the default is inferred, not printed");
  option(app, "--stop", words.stops, "STOP",
         "mass:side:position or mass:side:position:restitution, with side lower or\n"
         "upper, repeatable; none: a chain without stops");
  option(app, "--initial-displacement", words.displacement, "LIST", "x_i at t = 0");
  option(app, "--initial-velocity", words.velocity, "LIST", "x_i' at t = 0");
}

Scene scene_of(const SceneOptions &words) {
  const auto size = static_cast<std::size_t>(words.masses);
  Scene scene;
  scene.mass = per_mass("--mass", words.mass, size);
  scene.stiffness = per_mass("--stiffness", words.stiffness, size);
  scene.beta = words.beta;
  scene.restitution = words.restitution;
  scene.amplitude.assign(size, 0.0);
  scene.amplitude.front() = default_amplitude;
  if (!words.amplitude.empty()) scene.amplitude = per_mass("--amplitude", words.amplitude, size);
  scene.omega = words.omega;
  scene.displacement = per_mass("--initial-displacement", words.displacement, size);
  scene.velocity = per_mass("--initial-velocity", words.velocity, size);
  if (words.stops != std::vector<std::string>{"none"})
    for (const std::string &stop : words.stops) scene.stops.push_back(stop_of(stop));
  check(scene);
  return scene;
}

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
         "amplitude2, mass1, stiffness1, displacement1, velocity1")
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
    app.parse(argc, argv);
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
