#include "vibro_impact/analysis/parameter.hpp"

#include <algorithm>
#include <charconv>

#include "simulation/for_analysis.hpp"

namespace vibro_impact {

namespace {

// The numbers that stand once in a scene.
constexpr struct {
  std::string_view word;
  double Scene::*place;
} scalars[] = {
    {"omega", &Scene::omega}, {"beta", &Scene::beta}, {"restitution", &Scene::restitution}};

// Parameters of which each mass has one.
constexpr struct {
  std::string_view word;
  std::vector<double> Scene::*place;
} lists[] = {{"amplitude", &Scene::amplitude},
             {"sine", &Scene::sine},
             {"constant", &Scene::constant},
             {"ground", &Scene::ground},
             {"mass", &Scene::mass},
             {"stiffness", &Scene::stiffness},
             {"displacement", &Scene::displacement},
             {"velocity", &Scene::velocity}};

// The index (from 1) that these digits write, or 0 if they are anything else.
std::size_t index_of(std::string_view digits) {
  std::size_t index = 0;
  const char *end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, index);
  return error == std::errc() && stop == end && digits.front() != '0' ? index : 0;
}

// The number itself. Where the scene leaves it out, it is written out first.
double &value_of(Scene &scene, std::string_view name) {
  for (const auto &[word, place] : scalars)
    if (name == word) return scene.*place;
  const std::size_t letters = std::min(name.find_first_of("0123456789"), name.size());
  const std::string_view before = name.substr(0, letters);
  const std::size_t index = index_of(name.substr(letters));
  const auto require_index = [&](std::size_t count) {
    require(index <= count, name, ": the scene has ", count, " of these numbers");
  };
  for (const auto &[word, place] : lists) {
    if (index == 0 || before != word) continue;
    std::vector<double> &values = scene.*place;
    if (values.empty()) values.assign(scene.mass.size(), 0.0);
    require_index(values.size());
    return values[index - 1];
  }
  require(index > 0 && (before == "stop" || before == "restitution"), "parameter '", name,
          "': must be omega, beta, restitution, or, with the number of a mass, link or stop, "
          "restitution1, stop1, amplitude1, sine1, constant1, ground1, mass1, stiffness1, "
          "displacement1, velocity1");
  require_index(scene.stops.size());
  Stop &stop = scene.stops[index - 1];
  if (before == "stop") return stop.position;
  if (!stop.restitution) stop.restitution = scene.restitution;
  return *stop.restitution;
}

}  // namespace

double get(const Scene &scene, std::string_view name) {
  Scene copy = scene;
  return value_of(copy, name);
}

Scene with(Scene scene, std::string_view name, double value) {
  value_of(scene, name) = value;
  return scene;
}

}  // namespace vibro_impact
