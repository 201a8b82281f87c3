#include "scene_options.hpp"

#include <algorithm>

#include "refuse.hpp"
#include "values.hpp"

namespace vibro_impact::runner {

namespace {

bool given(const SceneOptions &words, const std::string &name) {
  return std::ranges::any_of(words.all, [&name](const CLI::Option *option) {
    return option->get_name() == name && option->count() > 0;
  });
}

}  // namespace

void add_scene_options(CLI::App &app, SceneOptions &words) {
  const auto add = [&](const char *name, auto &value, const char *type, const char *what) {
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
  add("--beta", words.beta, "NUMBER", "beta of C = beta K (the paper's c / k)")->excludes(damping);
  add("--restitution", words.restitution, "NUMBER",
      "Coefficient of restitution r in [0, 1] of the stops that have none of their own");
  add("--amplitude", words.amplitude, "LIST",
      "A_i of the forcing A cos(Omega t); if N is not 2: 0.5 on mass 1");
  add("--omega", words.omega, "NUMBER",
      "Forcing frequency Omega >= 0; the default is reconstructed, not printed");
  add("--stop", words.stops, "STOP",
      "mass:side:position or mass:side:position:restitution, with side lower or\n"
      "upper, repeatable; none: a chain without stops");
  add("--initial-displacement", words.displacement, "LIST", "x_i at t = 0");
  add("--initial-velocity", words.velocity, "LIST", "x_i' at t = 0");
}

Scene scene_of(const SceneOptions &words) {
  const auto size = static_cast<std::size_t>(number("--masses", words.masses));
  if (size < 2 && !given(words, "--stop"))
    refuse("--masses {}: the default stops stand on masses 1 and 2; give --stop, or --stop none",
           words.masses);
  Scene scene;
  scene.mass = per_mass("--mass", words.mass, size);
  scene.stiffness = per_mass("--stiffness", words.stiffness, size);
  scene.restitution = number("--restitution", words.restitution);
  if (size != 2 && !given(words, "--amplitude")) {
    scene.amplitude.assign(size, 0.0);
    scene.amplitude.front() = 0.5;
  } else {
    scene.amplitude = per_mass("--amplitude", words.amplitude, size);
  }
  scene.omega = number("--omega", words.omega);
  scene.displacement = per_mass("--initial-displacement", words.displacement, size);
  scene.velocity = per_mass("--initial-velocity", words.velocity, size);
  if (words.stops != std::vector<std::string>{"none"})
    for (const std::string &stop : words.stops) scene.stops.push_back(stop_of(stop));
  check(scene);  // before the damping is divided by the stiffness
  scene.beta = given(words, "--beta") ? number("--beta", words.beta)
                                      : beta_of(words.damping, scene.stiffness);
  check(scene);
  return scene;
}

std::string text_of(const SceneOptions &options) {
  std::string text;
  for (const CLI::Option *option : options.all)
    for (const std::string &value : option->results())
      text += fmt::format("{}={}\n", option->get_name(), value);
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
    refuse("{}", error.what());
  }
  return scene_of(options);
}

}  // namespace vibro_impact::runner
