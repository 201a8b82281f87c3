#include "options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <vector>

#include "bad_input.hpp"
#include "misspelt.hpp"
#include "values.hpp"

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
    "  vibro-impact run --omega 0.2797 --stop 1:lower:-0.3 --stop 2:upper:0.1 --until 750 --from "
    "700\n"
    "    --events events.csv --samples samples.csv --every 0.01 --resolve-chatter 1e-4 --plot "
    "run.png\n"
    "Events: time,mass,event,velocity_before,velocity_after,contact_mode; event is impact, stick "
    "or\n"
    "release; contact_mode lists the stuck masses after the event (-, 1, 2, 1+2).\n"
    "In two parts, the tables of the second going on where those of the first end:\n"
    "  vibro-impact run --until 700 --events first.csv --save-state at700.state\n"
    "  vibro-impact run --resume at700.state --until 750 --events second.csv\n"
    "Ctrl-C ends a run early: its tables hold what came before, and --save-state what --resume "
    "goes\n"
    "on from.\n"
    "Exit status: 0 done, 1 the run was given up or a file could not be written, 2 bad input, 130 "
    "ended\n"
    "by Ctrl-C (128 + the number of the signal).";

// The words of the command line as they were given, with the defaults of the paper's Figure 2.
struct Words {
  std::string masses = "2", mass = "1", stiffness = "1", damping = "0.1", beta, restitution = "0.7";
  std::string amplitude = "0.5,0", omega = "0.2797", displacement = "0", velocity = "0";
  std::vector<std::string> stops = {"1:lower:-0.3", "2:upper:0.1"};
  std::string until = "750", from = "0", every = "0.01", resolve, most = "1000000";
};

// The options whose absence, too, means something.
struct Given {
  std::vector<const CLI::Option *> scene, files;
  const CLI::Option *amplitude = nullptr, *beta = nullptr, *stops = nullptr, *resolve = nullptr;
};

CLI::Option *option(CLI::App &run, const char *name, std::string &value, const char *type,
                    const char *what) {
  return run.add_option(name, value, what)->type_name(type)->capture_default_str();
}

void add_scene_options(CLI::App &run, Words &words, Given &given) {
  const auto add = [&](const char *name, std::string &value, const char *type, const char *what) {
    CLI::Option *added = option(run, name, value, type, what);
    given.scene.push_back(added);
    return added;
  };
  add("--masses", words.masses, "N", "Number of masses");
  add("--mass", words.mass, "LIST", "m_i > 0");
  add("--stiffness", words.stiffness, "LIST",
      "k_i > 0, link by link; k_1 = 0: a free chain, not tied to the ground");
  CLI::Option *damping =
      add("--damping", words.damping, "LIST", "c_i, proportional to k_i: C = beta K");
  CLI::Option *beta = add("--beta", words.beta, "NUMBER", "beta of C = beta K (the paper's c / k)");
  beta->excludes(damping);
  given.beta = beta;
  add("--restitution", words.restitution, "NUMBER",
      "Coefficient of restitution r in [0, 1] of the stops that have none of their own");
  given.amplitude = add("--amplitude", words.amplitude, "LIST",
                        "A_i of the forcing A cos(Omega t); if N is not 2: 0.5 on mass 1");
  add("--omega", words.omega, "NUMBER",
      "Forcing frequency Omega >= 0; the default is reconstructed, not printed");
  given.stops =
      run.add_option("--stop", words.stops,
                     "mass:side:position or mass:side:position:restitution, with side lower or\n"
                     "upper, repeatable; none: a chain without stops")
          ->type_name("STOP")
          ->capture_default_str();
  given.scene.push_back(given.stops);
  add("--initial-displacement", words.displacement, "LIST", "x_i at t = 0");
  add("--initial-velocity", words.velocity, "LIST", "x_i' at t = 0");
}

void add_run_options(CLI::App &run, Words &words, Request &request, Given &given) {
  option(run, "--until", words.until, "TIME", "End of the run, > 0");
  option(run, "--from", words.from, "TIME", "Start of both tables; the run itself starts at t = 0");
  option(run, "--every", words.every, "TIME", "Interval between samples, > 0, counted from --from");
  given.files = {
      option(run, "--events", request.events, "FILE", "Event table (CSV); - for standard output"),
      option(run, "--samples", request.samples, "FILE",
             "Displacements time,x1,x2,... (CSV); - for standard output"),
      option(run, "--plot", request.plot, "FILE",
             "Picture of the displacements, stops, impacts and sticking from --from on, by\n"
             "gnuplot: .png, .pdf or .svg; of at most 8 masses, those with stops first"),
      option(run, "--save-state", request.save_state, "FILE",
             "The scene and the state at the end of the run, for --resume"),
      option(run, "--resume", request.resume, "FILE",
             "Go on from a saved state, with its scene: options of the scene cannot be\n"
             "given. The tables hold what comes after it; for those of one whole run,\n"
             "give the other options as before")};
  given.resolve = option(run, "--resolve-chatter", words.resolve, "SPEED",
                         "Resolve and record every chatter impact faster than this; below it a\n"
                         "complete chatter may be carried to its limit. Default: as soon as the\n"
                         "limit is certain; 0: resolve until below rounding");
  option(run, "--max-impacts", words.most, "N",
         "Give up beyond this many impacts in one forcing period");
  run.add_flag("--progress", request.progress,
               "Say how far the run is and how long it still takes, on standard error, also where\n"
               "that is no terminal");
}

Scene scene_of(const Words &words, const Given &given) {
  const auto size = static_cast<std::size_t>(count_of("--masses", words.masses, most_masses));
  if (given.stops->count() == 0 && size < 2)
    throw BadInput(fmt::format(
        "--masses {}: the default stops stand on masses 1 and 2; give --stop, or --stop none",
        words.masses));
  Scene scene;
  scene.mass = per_mass("--mass", words.mass, size);
  scene.stiffness = per_mass("--stiffness", words.stiffness, size);
  scene.restitution = number("--restitution", words.restitution);
  if (given.amplitude->count() == 0 && size != 2) {
    scene.amplitude.assign(size, 0.0);
    scene.amplitude.front() = 0.5;
  } else {
    scene.amplitude = per_mass("--amplitude", words.amplitude, size);
  }
  scene.omega = number("--omega", words.omega);
  scene.displacement = per_mass("--initial-displacement", words.displacement, size);
  scene.velocity = per_mass("--initial-velocity", words.velocity, size);
  if (!(words.stops.size() == 1 && words.stops.front() == "none"))
    for (const std::string &stop : words.stops) scene.stops.push_back(stop_of(stop));
  check(scene);  // before the damping is divided by the stiffness
  scene.beta = given.beta->count() > 0 ? number("--beta", words.beta)
                                       : beta_of(words.damping, scene.stiffness);
  check(scene);
  return scene;
}

void read_run_options(const Words &words, const Given &given, Request &request) {
  request.until = positive("--until", words.until);
  request.from = number("--from", words.from);
  if (!(request.from >= 0.0 && request.from <= request.until))
    throw BadInput(
        fmt::format("--from {}: must lie between 0 and --until {}", words.from, words.until));
  request.every = positive("--every", words.every);
  // Sample times that rounding makes equal would never come to an end.
  if (!request.samples.empty() && !(request.until + request.every > request.until))
    throw BadInput(fmt::format(
        "--every {}: too short for double precision to tell samples at --until {} apart",
        words.every, words.until));
  if (given.resolve->count() > 0) {
    request.options.resolve_chatter = number("--resolve-chatter", words.resolve);
    if (!(request.options.resolve_chatter >= 0.0))
      throw BadInput(fmt::format("--resolve-chatter {}: must be non-negative", words.resolve));
  }
  request.options.max_impacts_per_period =
      count_of("--max-impacts", words.most, 1'000'000'000'000'000);
}

}  // namespace

std::optional<Answer> parse(int argc, char **argv, Request &request) {
  Words words;
  Given given;
  CLI::App app(purpose, "vibro-impact");
  app.footer(example);
  app.set_version_flag("--version", "vibro-impact " VIBRO_IMPACT_VERSION);
  app.require_subcommand(1);
  CLI::App &run = *app.add_subcommand("run", "Run one scene and write its tables");
  run.footer(example);
  add_scene_options(run, words, given);
  add_run_options(run, words, request, given);

  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForVersion &version) {
    return Answer{fmt::format("{}\n", version.what())};
  } catch (const CLI::CallForHelp &) {
    if (run.parsed()) return Answer{fmt::format("{}\n\n{}", purpose, run.help(app.get_name()))};
    return Answer{app.help()};
  } catch (const CLI::ParseError &error) {
    throw BadInput(explain(app, error));
  }

  for (const CLI::Option *file : given.files)
    if (file->count() > 0 && file->as<std::string>().empty())
      throw BadInput(fmt::format("{} '': must name a file", file->get_name()));
  if (request.resume.empty())
    request.scene = scene_of(words, given);
  else
    for (const CLI::Option *of_scene : given.scene)
      if (of_scene->count() > 0)
        throw BadInput(fmt::format("{}: the scene comes from --resume {} and cannot be changed",
                                   of_scene->get_name(), request.resume));
  read_run_options(words, given, request);
  return std::nullopt;
}

}  // namespace vibro_impact::runner
