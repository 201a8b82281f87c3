#include "vibro_impact/analysis/parameter.hpp"

#include <algorithm>
#include <charconv>
#include <string>

#include "simulation/for_analysis.hpp"
#include "vibro_impact/scene_fields.hpp"

namespace vibro_impact {

namespace {

// The index (from 1) that these digits write, or 0 if they are anything else.
std::size_t index_written(std::string_view digits) {
  std::size_t index = 0;
  const char *end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, index);
  return error == std::errc() && stop == end && digits.front() != '0' ? index : 0;
}

// The names of all parameters, for a message.
std::string all_names() {
  std::string names;
  for (const auto &field : scalar_fields) names += std::string(field.name) + ", ";
  names += "or, with the number of a mass, link or stop, ";
  for (const auto &field : list_fields) names += std::string(field.name) + "1, ";
  return names + "stop1, restitution1";
}

// The number itself. Where the scene leaves it out, it is written out first.
double &value_of(Scene &scene, std::string_view name) {
  for (const auto &field : scalar_fields)
    if (name == field.name) return scene.*field.value;
  const std::size_t letters = std::min(name.find_first_of("0123456789"), name.size());
  const std::string_view before = name.substr(0, letters);
  const std::size_t index = index_written(name.substr(letters));
  const auto require_index = [&](std::size_t count) {
    require(index <= count, name, ": the scene has ", count, " of these numbers");
  };
  for (const auto &field : list_fields) {
    if (index == 0 || before != field.name) continue;
    std::vector<double> &values = scene.*field.value;
    if (values.empty()) values.assign(scene.mass.size(), 0.0);
    require_index(values.size());
    return values[index - 1];
  }
  require(index > 0 && (before == "stop" || before == "restitution"), "parameter '", name,
          "': must be ", all_names());
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
