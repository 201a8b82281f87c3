#include "scene_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "bad_input.hpp"
#include "values.hpp"

namespace vibro_impact::runner {

void add_scene_options(CLI::App &app, SceneOptions &words) {
  const auto add = [&](const char *name, std::string &value, const char *type, const char *what) {
    CLI::Option *added = option(app, name, value, type, what);
    words.all.push_back(added);
    return added;
  };
  add("--masses", words.masses, "N", "Number of masses")->check(whole_number(most_masses));
  add("--mass", words.mass, "LIST", "m_i > 0");
  add("--stiffness", words.stiffness, "LIST",
      "k_i > 0, link by link; k_1 = 0: a free chain, not tied to the ground");
  CLI::Option *damping =
      add("--damping", words.damping, "LIST", "c_i, proportional to k_i: C = beta K");
  CLI::Option *beta = add("--beta", words.beta, "NUMBER", "beta of C = beta K (the paper's c / k)");
  beta->excludes(damping);
  words.beta_option = beta;
  add("--restitution", words.restitution, "NUMBER",
      "Coefficient of restitution r in [0, 1] of the stops that have none of their own");
  words.amplitude_option = add("--amplitude", words.amplitude, "LIST",
                               "A_i of the forcing A cos(Omega t); if N is not 2: 0.5 on mass 1");
  add("--omega", words.omega, "NUMBER",
      "Forcing frequency Omega >= 0; the default is reconstructed, not printed");
  words.stops_option =
      app.add_option("--stop", words.stops,
                     "mass:side:position or mass:side:position:restitution, with side lower or\n"
                     "upper, repeatable; none: a chain without stops")
          ->type_name("STOP")
          ->capture_default_str();
  words.all.push_back(words.stops_option);
  add("--initial-displacement", words.displacement, "LIST", "x_i at t = 0");
  add("--initial-velocity", words.velocity, "LIST", "x_i' at t = 0");
}

Scene scene_of(const SceneOptions &words) {
  const auto size = static_cast<std::size_t>(number("--masses", words.masses));
  if (words.stops_option->count() == 0 && size < 2)
    throw BadInput(fmt::format(
        "--masses {}: the default stops stand on masses 1 and 2; give --stop, or --stop none",
        words.masses));
  Scene scene;
  scene.mass = per_mass("--mass", words.mass, size);
  scene.stiffness = per_mass("--stiffness", words.stiffness, size);
  scene.restitution = number("--restitution", words.restitution);
  if (words.amplitude_option->count() == 0 && size != 2) {
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
  scene.beta = words.beta_option->count() > 0 ? number("--beta", words.beta)
                                              : beta_of(words.damping, scene.stiffness);
  check(scene);
  return scene;
}

std::string text_of(const SceneOptions &options) {
  std::string text;
  for (const CLI::Option *given : options.all)
    for (const std::string &value : given->results())
      text += fmt::format("{}={}\n", given->get_name(), value);
  return text;
}

Scene scene_in(const std::string &text) {
  CLI::App app;
  SceneOptions options;
  add_scene_options(app, options);
  std::vector<std::string> lines = CLI::detail::split(text, '\n');
  std::reverse(lines.begin(), lines.end());  // as CLI11 wants them
  std::erase(lines, "");
  try {
    app.parse(lines);
  } catch (const CLI::ParseError &error) {
    throw BadInput(error.what());
  }
  return scene_of(options);
}

}  // namespace vibro_impact::runner
