#include "scene_options.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <tuple>

#include "files.hpp"

namespace vibro_impact::runner {

std::vector<std::string> split(const std::string &text, char separator) {
  return CLI::detail::split(text + separator, separator);
}

// from_chars knows no locale, no leading space and no plus sign.
double number(const std::string &given, const std::string &word) {
  double value = 0.0;
  const char *end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (stop != end || error != std::errc())
    refuse("{}: '{}' is not a number in double precision", given, shown(word));
  return value;
}

long long whole_number(const std::string &given, const std::string &word, double most) {
  const double value = number(given, word);
  if (!(value >= 1.0 && value <= most && value == std::floor(value)))
    refuse("{}: '{}' must be a whole number from 1 to {}", given, shown(word), most);
  return static_cast<long long>(value);
}

std::string shown(const std::string &text) {
  constexpr std::size_t longest = 60;
  std::string begin = text.substr(0, longest);
  for (char &c : begin)
    if (c < ' ' || c > '~') c = '?';
  return text.size() > longest ? begin + "..." : begin;
}

namespace {

constexpr double default_amplitude = 0.5;  // on mass 1

const std::vector<std::string> default_stops = {"1:lower:-0.3", "2:upper:0.1"};

// Longer chains are taken for a slip of the pen: the modes of a chain take cubic work, 10 s here.
constexpr int most_masses = 2000;

constexpr const char *scene_group = "Scene";

// The values of a list separated by commas: one value per mass, or a single one for all.
std::vector<double> per_mass(const std::string &option, const std::string &text,
                             std::size_t masses) {
  const std::string given = option + " " + shown(text);
  std::vector<double> values;
  for (const std::string &word : split(text, ',')) values.push_back(number(given, word));
  if (values.size() == 1) values.assign(masses, values.front());
  if (values.size() != masses)
    refuse("{}: {} values given, the chain has {} masses", given, values.size(), masses);
  return values;
}

// The stop given as mass:side:position, or with a restitution of its own as a fourth part.
Stop stop_of(const std::string &given, const std::string &text) {
  const auto parts = split(text, ':');
  if (parts.size() < 3 || parts.size() > 4 || (parts[1] != "lower" && parts[1] != "upper"))
    refuse(
        "{}: must read mass:side:position or mass:side:position:restitution, with side lower "
        "or upper",
        given);
  Stop stop{static_cast<int>(whole_number(given, parts[0], most_masses)),
            parts[1] == "lower" ? Side::lower : Side::upper, number(given, parts[2])};
  if (parts.size() == 4) stop.restitution = number(given, parts[3]);
  return stop;
}

std::vector<std::string> stops_of(const SceneOptions &words) {
  if (!words.stops.empty()) return words.stops;
  std::vector<std::string> stops;
  for (const std::string &stop : default_stops)
    if (stop_of(stop, stop).mass <= words.masses) stops.push_back(stop);
  return stops;
}

// The words of a value in a scene file: a word, or words separated by commas, which may stand in
// brackets and in quotes. Returns no words if a bracket or a quote has no partner.
std::vector<std::string> words_of(std::string value) {
  if (value.starts_with('[') && value.ends_with(']')) value = value.substr(1, value.size() - 2);
  if (value.find_first_of("[]") != std::string::npos) return {};
  for (const char quote : {'"', '\''}) {
    if (std::count(value.begin(), value.end(), quote) % 2 != 0) return {};
    std::erase(value, quote);
  }
  std::vector<std::string> words = split(value, ',');
  for (std::string &word : words) CLI::detail::trim(word);
  return words;
}

// The arguments of a line of a scene file. `names` has the options above this line.
std::vector<std::string> arguments_of(const std::string &given, const std::string &line,
                                      const CLI::App &command, std::set<std::string> &names) {
  const std::size_t equals = line.find('=');
  if (equals == std::string::npos) refuse("{}: must read name = value", given);
  const std::string name = "--" + CLI::detail::trim_copy(line.substr(0, equals));
  const CLI::Option *option = command.get_option_no_throw(name);
  if (option == nullptr || option->get_group() != scene_group)
    refuse("{}: is no option of a scene", given);
  if (!names.insert(name).second) refuse("{}: is given twice", given);
  const auto words = words_of(CLI::detail::trim_copy(line.substr(equals + 1)));
  if (words.empty()) refuse("{}: a bracket or a quote is not closed", given);
  if (name != "--stop") {
    for (const std::string &word : words) number(given, word);
    return {fmt::format("{}={}", name, fmt::join(words, ","))};
  }
  std::vector<std::string> arguments;
  for (const std::string &word : words) {
    if (word != "none") stop_of(given, word);
    arguments.push_back(name + "=" + word);
  }
  return arguments;
}

std::vector<std::string> arguments_of_file(const std::string &path, const CLI::App &command) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) refuse("--scene {}: is no file", path);
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse("--scene {}: cannot be read", path);
  std::vector<std::string> arguments;
  std::set<std::string> names;
  bool in_table = false;
  std::size_t number = 0;
  for (std::string line; std::getline(file, line);) {
    if (++number == 1 && line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);
    if (number == 1) in_table = line.starts_with(table_head);
    if (in_table && !line.starts_with('#')) break;
    if (in_table) line.erase(0, number == 1 ? line.size() : 1);
    line.erase(std::min(line.size(), line.find('#')));
    CLI::detail::trim(line);
    if (line.empty()) continue;
    const std::string given = fmt::format("--scene {}, line {}: {}", path, number, shown(line));
    for (std::string &argument : arguments_of(given, line, command, names))
      arguments.push_back(std::move(argument));
  }
  if (file.bad()) refuse("--scene {}: cannot be read", path);
  return arguments;
}

}  // namespace

void add_scene_options(CLI::App &app, SceneOptions &words) {
  app.option_defaults()->group(scene_group);
  count_option(app, "--masses", words.masses, most_masses, "Number of masses");
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
         "upper, repeatable; none: a chain without stops. Default: 1:lower:-0.3 and\n"
         "2:upper:0.1, as far as the chain has these masses")
      ->default_str("");
  option(app, "--initial-displacement", words.displacement, "LIST", "x_i at t = 0");
  option(app, "--initial-velocity", words.velocity, "LIST", "x_i' at t = 0");
  app.option_defaults()->group("Options");
  // The rows of a sweep depend on the options in the file, not on its name.
  option(app, "--scene", words.file, "FILE",
         "Options of the scene, a line name = value each, or a table that was written with\n"
         "--header; options given here replace them")
      ->configurable(false);
  app.add_flag("--print-scene", words.print, "Write the options of the scene as such a file")
      ->disable_flag_override()
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
    for (const std::string &stop : stops_of(words))
      scene.stops.push_back(stop_of("--stop " + shown(stop), stop));
  check(scene);
  return scene;
}

std::vector<std::string> reversed_arguments(int argc, const char *const *argv,
                                            const CLI::App &command) {
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
    for (const std::string &argument : arguments_of_file(file, command))
      if (place_of(argument.substr(0, argument.find('='))) == arguments.end())
        of_file.push_back(argument);
  }
  arguments.insert(arguments.end(), of_file.begin(), of_file.end());
  std::reverse(arguments.begin(), arguments.end());
  return arguments;
}

std::string scene_file(const CLI::App &app, const SceneOptions &words) {
  std::string text;
  for (const CLI::Option *given : app.get_options()) {
    if (given->get_group() != scene_group) continue;
    std::string value = given->empty() ? given->get_default_str() : given->as<std::string>();
    if (given->get_single_name() == "stop")
      value = fmt::format("{}", fmt::join(stops_of(words), ", "));
    if (value.empty()) {  // the amplitude
      value = fmt::format("{}", default_amplitude);
      for (int mass = 2; mass <= words.masses; ++mass) value += ",0";
    }
    text += fmt::format("{} = {}\n", given->get_single_name(), value);
  }
  return text;
}

}  // namespace vibro_impact::runner
