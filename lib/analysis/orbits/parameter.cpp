#include "vibro_impact/analysis/parameter.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "simulation/for_analysis.hpp"

namespace vibro_impact {

namespace {

using Kind = Parameter::Kind;

struct Word {
  std::string_view word;
  bool bare, indexed;  // may stand without an index, with one
};

// In the order of the kinds.
constexpr std::array<Word, 9> words{{{"omega", true, false},
                                     {"beta", true, false},
                                     {"restitution", true, true},
                                     {"stop", false, true},
                                     {"amplitude", false, true},
                                     {"mass", false, true},
                                     {"stiffness", false, true},
                                     {"displacement", false, true},
                                     {"velocity", false, true}}};

const Word &word_of(const Parameter &parameter) {
  const auto kind = static_cast<std::size_t>(parameter.kind);
  require(kind < words.size(), "kind of parameter = ", static_cast<int>(parameter.kind),
          ": there are kinds 0 to ", words.size() - 1);
  return words[kind];
}

bool has_form(const Word &word, int index) {
  return index == 0 ? word.bare : word.indexed && index > 0;
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

// The scalar itself, written out in the scene.
double &value_of(Scene &scene, const Parameter &parameter) {
  require(
      has_form(word_of(parameter), parameter.index), name(parameter), ": ",
      parameter.index == 0 ? "needs the number of a mass, link or stop" : "no such number of it");
  switch (parameter.kind) {
    case Kind::omega:
      return scene.omega;
    case Kind::beta:
      return scene.beta;
    case Kind::restitution: {
      if (parameter.index == 0) return scene.restitution;
      auto &own = stop_of(scene, parameter).restitution;
      if (!own) own = scene.restitution;
      return *own;
    }
    case Kind::stop:
      return stop_of(scene, parameter).position;
    case Kind::amplitude:
      return of_mass(scene.amplitude, scene, parameter);
    case Kind::mass:
      return of_mass(scene.mass, scene, parameter);
    case Kind::stiffness:
      return of_mass(scene.stiffness, scene, parameter);
    case Kind::displacement:
      return of_mass(scene.displacement, scene, parameter);
    case Kind::velocity:
      break;
  }
  return of_mass(scene.velocity, scene, parameter);
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
