#include "vibro_impact/analysis/parameter.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "simulation/for_analysis.hpp"

namespace vibro_impact {

namespace {

using Kind = Parameter::Kind;

// The word for a kind of parameter, and where its numbers stand: in the scene itself (named without
// an index), in a vector with one entry per mass, or in the stops (named with an index).
struct Word {
  std::string_view word;
  double Scene::*scalar = nullptr;
  std::vector<double> Scene::*of_masses = nullptr;
  bool of_stops = false;
};

// In the order of Parameter::Kind.
constexpr std::array<Word, 9> words{{{"omega", &Scene::omega},
                                     {"beta", &Scene::beta},
                                     {"restitution", &Scene::restitution, nullptr, true},
                                     {"stop", nullptr, nullptr, true},
                                     {"amplitude", nullptr, &Scene::amplitude},
                                     {"mass", nullptr, &Scene::mass},
                                     {"stiffness", nullptr, &Scene::stiffness},
                                     {"displacement", nullptr, &Scene::displacement},
                                     {"velocity", nullptr, &Scene::velocity}}};

const Word &word_of(const Parameter &parameter) {
  const auto kind = static_cast<std::size_t>(parameter.kind);
  require(kind < words.size(), "kind of parameter = ", static_cast<int>(parameter.kind),
          ": there are kinds 0 to ", words.size() - 1);
  return words[kind];
}

bool has_form(const Word &word, int index) {
  if (index == 0) return word.scalar != nullptr;
  return index > 0 && (word.of_masses != nullptr || word.of_stops);
}

// Entry `index` (from 1) of a vector with one entry per mass, which may have been left empty.
double &of_mass(std::vector<double> &values, const Scene &scene, const Parameter &parameter) {
  const auto n = static_cast<int>(scene.mass.size());
  require(parameter.index <= n, name(parameter), ": the chain has masses 1 to ", n);
  if (values.empty()) values.assign(scene.mass.size(), 0.0);
  require(static_cast<int>(values.size()) == n, name(parameter), ": ", values.size(),
          " values given, the chain has ", n, " masses");
  return values[static_cast<std::size_t>(parameter.index - 1)];
}

Stop &stop_of(Scene &scene, const Parameter &parameter) {
  require(parameter.index <= static_cast<int>(scene.stops.size()), name(parameter),
          ": the scene has ", scene.stops.size(), " stops");
  return scene.stops[static_cast<std::size_t>(parameter.index - 1)];
}

// The number itself. Where the scene leaves it out, it is written out first.
double &value_of(Scene &scene, const Parameter &parameter) {
  const Word &word = word_of(parameter);
  require(
      has_form(word, parameter.index), name(parameter), ": ",
      parameter.index == 0 ? "needs the number of a mass, link or stop" : "no such number of it");
  if (parameter.index == 0) return scene.*word.scalar;
  if (word.of_masses != nullptr) return of_mass(scene.*word.of_masses, scene, parameter);
  Stop &stop = stop_of(scene, parameter);
  if (parameter.kind == Kind::stop) return stop.position;
  if (!stop.restitution) stop.restitution = scene.restitution;
  return *stop.restitution;
}

}  // namespace

std::string name(const Parameter &parameter) {
  const Word &word = word_of(parameter);
  return parameter.index == 0 ? std::string(word.word) : line(word.word, parameter.index);
}

Parameter parameter_named(std::string_view name) {
  const std::size_t letters = std::min(name.find_first_of("0123456789"), name.size());
  int index = 0;
  const auto [end, error] =
      std::from_chars(name.data() + letters, name.data() + name.size(), index);
  const bool whole =
      letters == name.size() || (error == std::errc() && end == name.data() + name.size() &&
                                 index > 0 && name[letters] != '0');
  for (std::size_t kind = 0; kind < words.size(); ++kind)
    if (whole && words[kind].word == name.substr(0, letters) && has_form(words[kind], index))
      return {static_cast<Kind>(kind), index};
  throw std::invalid_argument(
      line("parameter '", name,
           "': must be omega, beta, restitution, or, with the number of a mass, link or stop, "
           "restitution1, stop1, amplitude1, mass1, stiffness1, displacement1, velocity1"));
}

double get(const Scene &scene, const Parameter &parameter) {
  Scene copy = scene;
  return value_of(copy, parameter);
}

Scene with(Scene scene, const Parameter &parameter, double value) {
  value_of(scene, parameter) = value;
  return scene;
}

}  // namespace vibro_impact
