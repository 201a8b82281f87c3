#include "options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <vector>

#include "bad_input.hpp"
#include "misspelt.hpp"
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

// The words of the command line as they were given.
struct Words {
  SceneWords scene;
  std::string until = "750", from = "0", every = "0.01", resolve, most = "1000000";
};

// The options whose absence, too, means something.
struct Given {
  SceneOptions scene;
  std::vector<const CLI::Option *> files;
  const CLI::Option *resolve = nullptr;
};

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
  given.scene = add_scene_options(run, words.scene);
  add_run_options(run, words, request, given);
  SweepWords sweep_words;
  CLI::App &sweep = *app.add_subcommand("sweep", sweep_purpose);
  const SweepGiven sweep_given = add_sweep_options(sweep, sweep_words);

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
    request.sweep = sweep_of(sweep, sweep_words, sweep_given);
    return std::nullopt;
  }
  for (const CLI::Option *file : given.files)
    if (file->count() > 0 && file->as<std::string>().empty())
      throw BadInput(fmt::format("{} '': must name a file", file->get_name()));
  if (request.resume.empty())
    request.scene = scene_of(words.scene, given.scene);
  else
    for (const CLI::Option *of_scene : given.scene.all)
      if (of_scene->count() > 0)
        throw BadInput(fmt::format("{}: the scene comes from --resume {} and cannot be changed",
                                   of_scene->get_name(), request.resume));
  read_run_options(words, given, request);
  return std::nullopt;
}

}  // namespace vibro_impact::runner
