#include "scene_options.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <tuple>

#include "files.hpp"

namespace vibro_impact::runner {

std::vector<std::string> split(const std::string &text, char separator) {
  return CLI::detail::split(text + separator, separator);
}

// from_chars knows no locale and no leading space.
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

namespace {

constexpr double default_amplitude = 0.5;  // on mass 1

// Longer chains are taken for a slip of the pen: the modes of a chain take cubic work.
constexpr int most_masses = 10000;

constexpr const char *scene_group = "Scene";

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

}  // namespace

void add_scene_options(CLI::App &app, SceneOptions &words) {
  app.option_defaults()->group(scene_group);
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
  option(app, "--sine", words.sine, "LIST", "B_i of a further forcing B sin(Omega t)");
  option(app, "--constant", words.constant, "LIST", "Constant force P_i, as a weight or a preload");
  option(app, "--ground", words.ground, "LIST",
         "Stiffness >= 0 of a spring from mass i to the ground");
  option(app, "--omega", words.omega, "NUMBER",
         "Forcing frequency Omega >= 0; the default is inferred, not printed");
  option(app, "--stop", words.stops, "STOP",
         "mass:side:position or mass:side:position:restitution, with side lower or\n"
         "upper, repeatable; none: a chain without stops");
  option(app, "--initial-displacement", words.displacement, "LIST", "x_i at t = 0");
  option(app, "--initial-velocity", words.velocity, "LIST", "x_i' at t = 0");
  app.option_defaults()->group("Options");
  // The rows of a sweep depend on the options in the file, not on its name.
  option(app, "--scene", words.file, "FILE",
         "Options of the scene, a line name = value each; those given here replace them")
      ->configurable(false);
  app.add_flag("--print-scene", words.print, "Write the options of the scene as such a file")
      ->configurable(false);
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
  for (const auto &[name, text, values] : {std::tuple{"--sine", &words.sine, &scene.sine},
                                           {"--constant", &words.constant, &scene.constant},
                                           {"--ground", &words.ground, &scene.ground}})
    if (*text != "0") *values = per_mass(name, *text, size);
  scene.omega = words.omega;
  scene.displacement = per_mass("--initial-displacement", words.displacement, size);
  scene.velocity = per_mass("--initial-velocity", words.velocity, size);
  if (words.stops != std::vector<std::string>{"none"})
    for (const std::string &stop : words.stops) scene.stops.push_back(stop_of(stop));
  check(scene);
  return scene;
}

std::vector<std::string> reversed_arguments(int argc, const char *const *argv) {
  std::vector<std::string> arguments(argv + 1, argv + argc);
  const auto place_of = [&](const std::string &name) {
    return std::find_if(arguments.begin(), arguments.end(), [&](const std::string &argument) {
      return argument == name || argument.starts_with(name + "=");
    });
  };
  std::vector<std::string> of_file;
  const auto scene = place_of("--scene");
  const bool apart = scene != arguments.end() && *scene == "--scene";
  if (scene != arguments.end() && !(apart && scene + 1 == arguments.end())) {
    const std::string file = apart ? *(scene + 1) : scene->substr(std::string("--scene=").size());
    for (const CLI::ConfigItem &item : CLI::ConfigBase().from_file(file)) {
      const std::string name = "--" + item.fullname();
      if (place_of(name) != arguments.end()) continue;
      if (item.name != "stop")
        of_file.push_back(fmt::format("{}={}", name, fmt::join(item.inputs, ",")));
      else
        for (const std::string &stop : item.inputs) of_file.push_back(name + "=" + stop);
    }
  }
  arguments.insert(arguments.end(), of_file.begin(), of_file.end());
  std::reverse(arguments.begin(), arguments.end());
  return arguments;
}

std::string scene_file(const CLI::App &app, const SceneOptions &words) {
  std::string text;
  for (const CLI::Option *given : app.get_options()) {
    if (given->get_group() != scene_group) continue;
    const std::string value =
        given->get_single_name() == "stop"
            ? fmt::format("[\"{}\"]", fmt::join(words.stops, "\", \""))
            : fmt::format("\"{}\"",
                          given->empty() ? given->get_default_str() : given->as<std::string>());
    if (value != "\"\"") text += fmt::format("{} = {}\n", given->get_single_name(), value);
  }
  return text;
}

}  // namespace vibro_impact::runner
