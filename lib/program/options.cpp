#include "options.hpp"

#include <fmt/format.h>

#include "bad_input.hpp"
#include "scene_options.hpp"
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

void add_run_options(CLI::App &run, Request &request) {
  option(run, "--until", request.until, "TIME", "End of the run, > 0")->check(positive_number());
  option(run, "--from", request.from, "TIME",
         "Start of both tables; the run itself starts at t = 0")
      ->check(number_from(0.0));
  option(run, "--every", request.every, "TIME",
         "Interval between samples, > 0, counted from --from")
      ->check(positive_number());
  option(run, "--events", request.events, "FILE", "Event table (CSV); - for standard output");
  option(run, "--samples", request.samples, "FILE",
         "Displacements time,x1,x2,... (CSV); - for standard output");
  option(run, "--plot", request.plot, "FILE",
         "Picture of the displacements, stops, impacts and sticking from --from on, by\n"
         "gnuplot: .png, .pdf or .svg; of at most 8 masses, those with stops first");
  option(run, "--save-state", request.save_state, "FILE",
         "The scene and the state at the end of the run, for --resume");
  option(run, "--resume", request.resume, "FILE",
         "Go on from a saved state, with its scene: options of the scene cannot be\n"
         "given. The tables hold what comes after it; for those of one whole run,\n"
         "give the other options as before");
  run.add_option("--resolve-chatter", request.options.resolve_chatter,
                 "Resolve and record every chatter impact faster than this; below it a\n"
                 "complete chatter may be carried to its limit. Default: as soon as the\n"
                 "limit is certain; 0: resolve until below rounding")
      ->type_name("SPEED")
      ->check(number_from(0.0));
  option(run, "--max-impacts", request.options.max_impacts_per_period, "N",
         "Give up beyond this many impacts in one forcing period")
      ->check(whole_number(1'000'000'000'000'000));
  run.add_flag("--progress", request.progress,
               "Say how far the run is and how long it still takes, on standard error, also where\n"
               "that is no terminal");
}

void check_run(const CLI::App &run, const Request &request) {
  for (const char *name : {"--events", "--samples", "--plot", "--save-state", "--resume"})
    if (run.count(name) > 0 && run.get_option(name)->as<std::string>().empty())
      throw BadInput(fmt::format("{} '': must name a file", name));
  if (!(request.from <= request.until))
    throw BadInput(
        fmt::format("--from {}: must lie between 0 and --until {}", request.from, request.until));
  // Sample times that rounding makes equal would never come to an end.
  if (!request.samples.empty() && !(request.until + request.every > request.until))
    throw BadInput(fmt::format(
        "--every {}: too short for double precision to tell samples at --until {} apart",
        request.every, request.until));
}

// What CLI11 says, but for what it puts in words of its own.
std::string explain(const CLI::App &app, const CLI::ParseError &error) {
  for (const CLI::App *command : app.get_subcommands())
    for (const CLI::Option *option : command->get_options())
      if (option->count() > 1 && option->get_items_expected_max() == 1)
        return fmt::format("{}: given {} times", option->get_name(), option->count());
  return error.what();
}

}  // namespace

std::optional<Answer> parse(int argc, char **argv, Request &request) {
  SceneOptions scene;
  CLI::App app(purpose, "vibro-impact");
  app.footer(example);
  app.set_version_flag("--version", "vibro-impact " VIBRO_IMPACT_VERSION);
  app.require_subcommand(1);
  CLI::App &run = *app.add_subcommand("run", "Run one scene and write its tables");
  run.footer(example);
  add_scene_options(run, scene);
  add_run_options(run, request);
  SweepOptionsOf of_sweep;
  CLI::App &sweep = *app.add_subcommand("sweep", sweep_purpose);
  add_sweep_options(sweep, of_sweep);

  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForVersion &version) {
    return Answer{fmt::format("{}\n", version.what())};
  } catch (const CLI::CallForHelp &) {
    for (const CLI::App *command : {&run, &sweep})
      if (command->parsed())
        return Answer{fmt::format("{}\n\n{}", purpose, command->help(app.get_name()))};
    return Answer{app.help()};
  } catch (const CLI::ParseError &error) {
    throw BadInput(explain(app, error));
  }

  if (sweep.parsed()) {
    request.sweep = sweep_of(sweep, of_sweep);
    return std::nullopt;
  }
  check_run(run, request);
  if (request.resume.empty()) {
    request.scene = scene_of(scene);
    request.scene_text = text_of(scene);
    return std::nullopt;
  }
  for (const CLI::Option *of_scene : scene.all)
    if (of_scene->count() > 0)
      throw BadInput(fmt::format("{}: the scene comes from --resume {} and cannot be changed",
                                 of_scene->get_name(), request.resume));
  return std::nullopt;
}

}  // namespace vibro_impact::runner
