#include "options.hpp"

#include "refuse.hpp"
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
  option(run, "--events", request.events, "FILE", "Event table (CSV); - for standard output")
      ->check(file_name());
  option(run, "--samples", request.samples, "FILE",
         "Displacements time,x1,x2,... (CSV); - for standard output")
      ->check(file_name());
  option(run, "--plot", request.plot, "FILE",
         "Picture of the displacements, stops, impacts and sticking from --from on, by\n"
         "gnuplot: .png, .pdf or .svg; of at most 8 masses, those with stops first")
      ->check(file_name());
  option(run, "--save-state", request.save_state, "FILE",
         "The scene and the state at the end of the run, for --resume")
      ->check(file_name());
  option(run, "--resume", request.resume, "FILE",
         "Go on from a saved state, with its scene: options of the scene cannot be\n"
         "given. The tables hold what comes after it; for those of one whole run,\n"
         "give the other options as before")
      ->check(file_name());
  run.add_option("--resolve-chatter", request.options.resolve_chatter,
                 "Resolve and record every chatter impact faster than this; below it a\n"
                 "complete chatter may be carried to its limit. Default: as soon as the\n"
                 "limit is certain; 0: resolve until below rounding")
      ->type_name("SPEED")
      ->check(number_from(0.0));
  option(run, "--max-impacts", request.options.max_impacts_per_period, "N",
         "Give up beyond this many impacts in one forcing period")
      ->check(whole_number(1e15));
  run.add_flag("--progress", request.progress,
               "Say how far the run is and how long it still takes, on standard error, also where\n"
               "that is no terminal");
}

void check_run(const Request &request) {
  if (!(request.from <= request.until))
    refuse("--from {}: must lie between 0 and --until {}", request.from, request.until);
  // Sample times that rounding makes equal would never come to an end.
  if (!request.samples.empty() && !(request.until + request.every > request.until))
    refuse("--every {}: too short for double precision to tell samples at --until {} apart",
           request.every, request.until);
}

}  // namespace

std::optional<std::string> parse(int argc, char **argv, Request &request) {
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
  CLI::App &sweep =
      *app.add_subcommand("sweep", "Record the settled motion at many parameter points");
  add_sweep_options(sweep, of_sweep);

  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForVersion &version) {
    return fmt::format("{}\n", version.what());
  } catch (const CLI::CallForHelp &) {
    for (const CLI::App *command : {&run, &sweep})
      if (command->parsed()) return fmt::format("{}\n\n{}", purpose, command->help(app.get_name()));
    return app.help();
  } catch (const CLI::ParseError &error) {
    refuse("{}", error.what());
  }

  if (sweep.parsed()) {
    request.sweep = sweep_of(sweep, of_sweep);
    return std::nullopt;
  }
  check_run(request);
  if (request.resume.empty()) {
    request.scene = scene_of(scene);
    request.scene_text = text_of(scene);
    return std::nullopt;
  }
  for (const CLI::Option *of_scene : scene.all)
    if (of_scene->count() > 0)
      refuse("{}: the scene comes from --resume {} and cannot be changed", of_scene->get_name(),
             request.resume);
  return std::nullopt;
}

}  // namespace vibro_impact::runner
