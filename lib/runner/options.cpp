#include "options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

namespace vibro_impact::runner {

namespace {

constexpr const char *purpose =
    "Simulates a chain of masses with rigid stops under harmonic forcing.\n"
    "All quantities are non-dimensional. Masses are counted from 1; the link of mass i joins it "
    "to\n"
    "mass i - 1 (mass 1 to the ground). A single value stands for all masses; a list has one "
    "value\n"
    "per mass, separated by commas. The defaults are those of Wagg (2006), Figure 2 (its omega is\n"
    "reconstructed, not printed).";

constexpr const char *example =
    "Example:\n"
    "  vibro-impact run --omega 0.28 --stop 1:lower:-0.3 --stop 2:upper:0.1 --until 750 --from "
    "700\n"
    "    --events events.csv --samples samples.csv --every 0.01 --resolve-chatter 1e-4\n"
    "Events: time,mass,event,velocity_before,velocity_after,contact_mode; event is impact, stick "
    "or\n"
    "release; contact_mode lists the stuck masses after the event (-, 1, 2, 1+2).\n"
    "Exit status: 0 done, 1 the run was given up, 2 bad input.";

// Rows times columns of the sample table that are held in memory: some gigabytes.
constexpr double most_cells = 1e8;
constexpr int most_masses = 10000;

// A whole token as a number; from_chars takes no locale and no leading space. `given` is what the
// user wrote, of which `token` may be a part.
double number(const std::string &option, const std::string &token, const std::string &given) {
  double value = 0.0;
  const char *end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, value);
  if (stop != end || error == std::errc::invalid_argument)
    throw BadInput(fmt::format("{} {}: '{}' is not a number", option, given, token));
  if (error != std::errc())
    throw BadInput(fmt::format("{} {}: beyond the range of double precision", option, given));
  return value;
}

double number(const std::string &option, const std::string &token) {
  return number(option, token, token);
}

double positive(const std::string &option, const std::string &token) {
  const double value = number(option, token);
  if (!(std::isfinite(value) && value > 0.0))
    throw BadInput(fmt::format("{} {}: must be positive and finite", option, token));
  return value;
}

// A whole number from 1 to `most`.
long long count_of(const std::string &option, const std::string &token, long long most) {
  const double value = number(option, token);
  if (!(value >= 1.0 && value <= static_cast<double>(most)) || value != std::floor(value))
    throw BadInput(fmt::format("{} {}: must be a whole number from 1 to {}", option, token, most));
  return static_cast<long long>(value);
}

std::vector<std::string> split(const std::string &text, char separator) {
  std::vector<std::string> parts(1);
  for (char c : text) {
    if (c == separator)
      parts.emplace_back();
    else
      parts.back().push_back(c);
  }
  return parts;
}

// A list with one value per mass, or one value for all.
std::vector<double> per_mass(const std::string &option, const std::string &text,
                             std::size_t masses) {
  std::vector<double> values;
  for (const std::string &token : split(text, ',')) values.push_back(number(option, token, text));
  if (values.size() == 1) values.assign(masses, values.front());
  if (values.size() != masses)
    throw BadInput(fmt::format("{} {}: {} values given, the chain has {} masses", option, text,
                               values.size(), masses));
  return values;
}

Stop stop_of(const std::string &text) {
  const auto parts = split(text, ':');
  if (parts.size() != 3 || (parts[1] != "lower" && parts[1] != "upper"))
    throw BadInput(
        fmt::format("--stop {}: must read mass:lower:position or mass:upper:position", text));
  const double mass = number("--stop", parts[0], text);
  if (!(mass >= 1.0 && mass <= most_masses) || mass != std::floor(mass))
    throw BadInput(fmt::format("--stop {}: the mass must be a whole number, counted from 1", text));
  return {static_cast<int>(mass), parts[1] == "lower" ? Side::lower : Side::upper,
          number("--stop", parts[2], text)};
}

// beta of C = beta K from the paper's c: c_i / k_i must agree for all links.
double beta_of(const std::string &text, const std::vector<double> &stiffness) {
  const auto damping = per_mass("--damping", text, stiffness.size());
  for (double c : damping)
    if (!(std::isfinite(c) && c >= 0.0))
      throw BadInput(fmt::format("--damping {}: must be non-negative and finite", text));
  const double beta = damping.front() / stiffness.front();
  for (std::size_t i = 0; i < stiffness.size(); ++i)
    if (!(std::abs(damping[i] - beta * stiffness[i]) <= 1e-12 * damping[i]))
      throw BadInput(
          fmt::format("--damping {}: must be proportional to the stiffness, link by link "
                      "(C = beta K); or give --beta",
                      text));
  return beta;
}

// Before the run, not when memory runs out in it.
void require_storable_samples(const Request &request, const std::string &every) {
  const double rows = std::floor((request.until - request.from) / request.every) + 1.0;
  if (!(rows * (request.scene.masses() + 1.0) <= most_cells))
    throw BadInput(
        fmt::format("--every {}: asks for {:.3g} samples of {} masses, more than {:.0e} "
                    "values can be held",
                    every, rows, request.scene.masses(), most_cells));
}

}  // namespace

std::optional<Answer> parse(int argc, char **argv, Request &request) {
  std::string masses = "2", mass = "1", stiffness = "1", damping = "0.1", beta, restitution = "0.7";
  std::string amplitude = "0.5,0", omega = "0.28", displacement = "0", velocity = "0";
  std::string until = "750", from = "0", every = "0.01", resolve, most = "1000000";
  std::vector<std::string> stops = {"1:lower:-0.3", "2:upper:0.1"};

  CLI::App app(purpose, "vibro-impact");
  app.footer(example);
  app.set_version_flag("--version", "vibro-impact 0.1.0");
  app.require_subcommand(1);
  CLI::App &run = *app.add_subcommand("run", "Run one scene and write its tables");
  run.footer(example);
  const auto option = [&run](const char *name, std::string &value, const char *type,
                             const char *what) {
    return run.add_option(name, value, what)->type_name(type)->capture_default_str();
  };
  option("--masses", masses, "N", "Number of masses");
  option("--mass", mass, "LIST", "m_i > 0");
  option("--stiffness", stiffness, "LIST", "k_i > 0, link by link");
  CLI::Option *c = option("--damping", damping, "LIST", "c_i, proportional to k_i: C = beta K");
  CLI::Option *ratio = option("--beta", beta, "NUMBER", "beta of C = beta K (the paper's c / k)");
  ratio->excludes(c);
  option("--restitution", restitution, "NUMBER", "Coefficient of restitution r in [0, 1]");
  CLI::Option *forcing = option("--amplitude", amplitude, "LIST",
                                "A_i of the forcing A cos(Omega t); if N is not 2: 0.5 on mass 1");
  option("--omega", omega, "NUMBER",
         "Forcing frequency Omega >= 0; the default is reconstructed, not printed");
  CLI::Option *stopping = run.add_option("--stop", stops,
                                         "mass:lower:position or mass:upper:position, repeatable;\n"
                                         "none: a chain without stops")
                              ->type_name("STOP")
                              ->capture_default_str();
  option("--initial-displacement", displacement, "LIST", "x_i at t = 0");
  option("--initial-velocity", velocity, "LIST", "x_i' at t = 0");
  option("--until", until, "TIME", "End of the run, > 0");
  option("--from", from, "TIME", "Start of both tables; the run itself starts at t = 0");
  option("--every", every, "TIME", "Interval between samples, > 0");
  CLI::Option *events =
      option("--events", request.events, "FILE", "Event table (CSV); - for standard output");
  CLI::Option *samples = option("--samples", request.samples, "FILE",
                                "Displacements time,x1,x2,... (CSV); - for standard output");
  CLI::Option *resolved =
      option("--resolve-chatter", resolve, "SPEED",
             "Resolve and record every chatter impact faster than this; below it a\n"
             "complete chatter may be carried to its limit. Default: as soon as the\n"
             "limit is certain; 0: resolve until below rounding");
  option("--max-impacts", most, "N", "Give up beyond this many impacts in one forcing period");

  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForVersion &version) {
    return Answer{fmt::format("{}\n", version.what())};
  } catch (const CLI::CallForHelp &) {
    if (run.parsed()) return Answer{fmt::format("{}\n\n{}", purpose, run.help(app.get_name()))};
    return Answer{app.help()};
  } catch (const CLI::ParseError &error) {
    throw BadInput(error.what());
  }

  const auto size = static_cast<std::size_t>(count_of("--masses", masses, most_masses));
  if (stopping->count() == 0 && size < 2)
    throw BadInput(fmt::format(
        "--masses {}: the default stops stand on masses 1 and 2; give --stop, or --stop none",
        masses));
  Scene &scene = request.scene;
  scene.mass = per_mass("--mass", mass, size);
  scene.stiffness = per_mass("--stiffness", stiffness, size);
  scene.restitution = number("--restitution", restitution);
  if (forcing->count() == 0 && size != 2) {
    scene.amplitude.assign(size, 0.0);
    scene.amplitude.front() = 0.5;
  } else {
    scene.amplitude = per_mass("--amplitude", amplitude, size);
  }
  scene.omega = number("--omega", omega);
  scene.displacement = per_mass("--initial-displacement", displacement, size);
  scene.velocity = per_mass("--initial-velocity", velocity, size);
  if (!(stops.size() == 1 && stops.front() == "none"))
    for (const std::string &stop : stops) scene.stops.push_back(stop_of(stop));
  check(scene);  // before the damping is divided by the stiffness
  scene.beta = ratio->count() > 0 ? number("--beta", beta) : beta_of(damping, scene.stiffness);
  check(scene);

  request.until = positive("--until", until);
  request.from = number("--from", from);
  if (!(request.from >= 0.0 && request.from <= request.until))
    throw BadInput(fmt::format("--from {}: must lie between 0 and --until {}", from, until));
  request.every = positive("--every", every);
  if (resolved->count() > 0) {
    request.options.resolve_chatter = number("--resolve-chatter", resolve);
    if (!(request.options.resolve_chatter >= 0.0))
      throw BadInput(fmt::format("--resolve-chatter {}: must be non-negative", resolve));
  }
  request.options.max_impacts_per_period = count_of("--max-impacts", most, 1'000'000'000'000'000);
  for (const CLI::Option *path : {events, samples})
    if (path->count() > 0 && path->as<std::string>().empty())
      throw BadInput(
          fmt::format("{} '': must name a file, or - for standard output", path->get_name()));
  if (!request.samples.empty()) require_storable_samples(request, every);
  return std::nullopt;
}

}  // namespace vibro_impact::runner
