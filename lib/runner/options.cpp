#include "options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
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

// A whole token as a number; from_chars takes no locale and no leading space.
double number(const std::string &option, const std::string &token) {
  double value = 0.0;
  const char *end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, value);
  if (error != std::errc() || stop != end)
    throw BadInput(fmt::format("{} {}: not a number", option, token));
  return value;
}

// A number for an option that takes one value in a stated range.
double scalar(const std::string &option, const std::string &token, double above, const char *rule) {
  const double value = number(option, token);
  if (!std::isfinite(value) || !(value > above))
    throw BadInput(fmt::format("{} {}: must be {}", option, token, rule));
  return value;
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
  for (const std::string &token : split(text, ',')) values.push_back(number(option, token));
  if (values.size() == 1) values.assign(masses, values.front());
  if (values.size() != masses)
    throw BadInput(fmt::format("{} {}: {} values given, the chain has {} masses", option, text,
                               values.size(), masses));
  return values;
}

Stop stop_of(const std::string &text) {
  const auto parts = split(text, ':');
  const std::string rule = "must read mass:lower:position or mass:upper:position";
  if (parts.size() != 3 || (parts[1] != "lower" && parts[1] != "upper"))
    throw BadInput(fmt::format("--stop {}: {}", text, rule));
  const double mass = number("--stop", parts[0]);
  if (!(mass >= 1.0 && mass <= 1e6) || mass != std::floor(mass))
    throw BadInput(fmt::format("--stop {}: {}", text, "masses are counted from 1"));
  return {static_cast<int>(mass), parts[1] == "lower" ? Side::lower : Side::upper,
          number("--stop", parts[2])};
}

// beta of C = beta K from the paper's c: c_i / k_i must agree for all links.
double beta_of(const std::string &text, const std::vector<double> &stiffness) {
  const auto damping = per_mass("--damping", text, stiffness.size());
  const double beta = damping.front() / stiffness.front();
  for (std::size_t i = 0; i < stiffness.size(); ++i)
    if (!(std::abs(damping[i] - beta * stiffness[i]) <= 1e-12 * std::abs(damping[i])))
      throw BadInput(
          fmt::format("--damping {}: must be proportional to the stiffness, link by link "
                      "(C = beta K); or give --beta",
                      text));
  return beta;
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
  const auto option = [&run](const char *name, std::string &value, const char *what) {
    return run.add_option(name, value, what)->capture_default_str();
  };
  option("--masses", masses, "Number of masses N");
  option("--mass", mass, "m_i > 0");
  option("--stiffness", stiffness, "k_i > 0, link by link");
  CLI::Option *c = option("--damping", damping, "c_i, proportional to k_i: C = beta K");
  option("--beta", beta, "beta of C = beta K, instead of --damping")->excludes(c);
  option("--restitution", restitution, "Coefficient of restitution r in [0, 1]");
  CLI::Option *forcing =
      option("--amplitude", amplitude, "A_i of the forcing A cos(Omega t); other N: 0.5 on mass 1");
  option("--omega", omega, "Forcing frequency Omega >= 0");
  run.add_option("--stop", stops, "mass:lower:position or mass:upper:position, repeatable; none")
      ->capture_default_str();
  option("--initial-displacement", displacement, "x_i at t = 0");
  option("--initial-velocity", velocity, "x_i' at t = 0");
  option("--until", until, "End of the run, > 0");
  option("--from", from, "Start of both tables");
  option("--every", every, "Interval between samples, > 0");
  option("--events", request.events, "Event table (CSV); - for standard output");
  option("--samples", request.samples, "Displacements time,x1,x2,... (CSV); - for standard output");
  option(
      "--resolve-chatter", resolve,
      "Resolve every chatter impact faster than this; below it a complete chatter may be carried "
      "to its limit. Default: as soon as the limit is certain; 0: resolve until below rounding");
  option("--max-impacts", most, "Give up beyond this many impacts in one forcing period");

  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForVersion &version) {
    return Answer{fmt::format("{}\n", version.what())};
  } catch (const CLI::CallForHelp &) {
    return Answer{run.parsed() ? run.help("", CLI::AppFormatMode::Normal) : app.help()};
  } catch (const CLI::ParseError &error) {
    throw BadInput(error.what());
  }

  const double n = scalar("--masses", masses, 0.0, "a whole number from 1 to 10000");
  if (n != std::floor(n) || n > 10000.0)
    throw BadInput(fmt::format("--masses {}: must be a whole number from 1 to 10000", masses));
  const auto size = static_cast<std::size_t>(n);
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
  scene.beta = beta.empty() ? beta_of(damping, scene.stiffness) : number("--beta", beta);
  check(scene);

  request.until = scalar("--until", until, 0.0, "positive and finite");
  request.from = number("--from", from);
  if (!(request.from >= 0.0 && request.from <= request.until))
    throw BadInput(fmt::format("--from {}: must lie between 0 and --until {}", from, until));
  request.every = scalar("--every", every, 0.0, "positive and finite");
  if (!resolve.empty()) {
    request.options.resolve_chatter = number("--resolve-chatter", resolve);
    if (!(request.options.resolve_chatter >= 0.0))
      throw BadInput(fmt::format("--resolve-chatter {}: must be non-negative", resolve));
  }
  request.options.max_impacts_per_period = static_cast<long long>(
      std::min(1e18, scalar("--max-impacts", most, 0.0, "a positive number")));
  if (request.events == "-" && request.samples == "-")
    throw BadInput("--events - --samples -: only one table can go to standard output");
  return std::nullopt;
}

}  // namespace vibro_impact::runner
