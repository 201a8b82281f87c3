/// \file
/// The fields of a scene in words, as scene files and tables of scenes have them: `omega = 0.2`,
/// `mass = 1,1,2`, `stop = 1:lower:-0.3,2:upper:0.1`.
///
/// A number is read as std::from_chars reads it. A list has a number for each mass, with commas
/// between them; one number stands for equal ones. A stop reads mass:side:position, or with a
/// restitution of its own mass:side:position:restitution. `none` stands for no stop. `masses` is
/// the number of masses, all of mass 1 on links of stiffness 1, and comes before the lists.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "scene_fields.hpp"

namespace vibro_impact {

/// Values in words. Each function that reads throws std::invalid_argument with one line naming the
/// word and the rule.
namespace words {

/// The beginning of a text that was given, for a message: printable, and short.
inline std::string shown(std::string_view text) {
  constexpr std::size_t longest = 60;
  std::string begin(text.substr(0, longest));
  for (char &c : begin)
    if (c < ' ' || c > '~') c = '?';
  return text.size() > longest ? begin + "..." : begin;
}

[[noreturn]] inline void refuse_words(std::string_view words, std::string_view rule) {
  throw std::invalid_argument("'" + shown(words) + "' " + std::string(rule));
}

/// The parts of a text between separators.
inline std::vector<std::string_view> parts_of(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

/// A finite number or not; from_chars knows no locale, no leading space and no plus sign.
inline double number_of(std::string_view word) {
  double value = 0.0;
  const char *end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (stop != end || error != std::errc())
    refuse_words(word, "is not a number in double precision");
  return value;
}

/// A whole number from 1 to `most`.
inline long long count_of(std::string_view word, long long most) {
  const double value = number_of(word);
  if (!(value >= 1.0 && value <= static_cast<double>(most) && value == std::floor(value)))
    refuse_words(word, "must be a whole number from 1 to " + std::to_string(most));
  return static_cast<long long>(value);
}

inline int mass_of(std::string_view word) {
  return static_cast<int>(count_of(word, 1'000'000));
}

inline Stop stop_in(std::string_view word) {
  const auto parts = parts_of(word, ':');
  const bool lower = parts.size() > 1 && parts[1] == "lower";
  if (parts.size() < 3 || parts.size() > 4 || (!lower && parts[1] != "upper"))
    refuse_words(word,
                 "must read mass:side:position or mass:side:position:restitution, with side "
                 "lower or upper");
  Stop stop{mass_of(parts[0]), lower ? Side::lower : Side::upper, number_of(parts[2])};
  if (parts.size() == 4) stop.restitution = number_of(parts[3]);
  return stop;
}

/// The shortest digits that give the number again.
inline std::string words_of(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

inline std::string words_of(const Stop &stop) {
  std::string words =
      std::to_string(stop.mass) + (stop.side == Side::lower ? ":lower:" : ":upper:");
  words += words_of(stop.position);
  if (stop.restitution) words += ":" + words_of(*stop.restitution);
  return words;
}

/// With commas between them.
template <class Value>
std::string joined(const std::vector<Value> &values) {
  std::string words;
  for (const Value &value : values) words += (words.empty() ? "" : ",") + words_of(value);
  return words;
}

}  // namespace words

/// Gives the field `name` of a scene, its `masses` or its stops (`stop`) the value in these words.
/// Returns false if there is no such field. Throws std::invalid_argument with one line naming the
/// word and the rule; `check` judges the values.
inline bool set_field(Scene &scene, std::string_view name, std::string_view given) {
  if (name == "masses") {
    scene.mass.assign(static_cast<std::size_t>(words::mass_of(given)), 1.0);
    scene.stiffness = scene.mass;
    return true;
  }
  if (name == "stop") {
    scene.stops.clear();
    if (given == "none") return true;
    for (const std::string_view word : words::parts_of(given, ','))
      scene.stops.push_back(words::stop_in(word));
    return true;
  }
  for (const auto &field : scalar_fields) {
    if (name != field.name) continue;
    scene.*field.value = words::number_of(given);
    return true;
  }
  for (const auto &field : list_fields) {
    if (name != field.name) continue;
    std::vector<double> values;
    for (const std::string_view word : words::parts_of(given, ','))
      values.push_back(words::number_of(word));
    if (values.size() == 1) values.assign(scene.mass.size(), values.front());
    if (values.size() != scene.mass.size())
      throw std::invalid_argument(std::to_string(values.size()) + " values given, the chain has " +
                                  std::to_string(scene.masses()) + " masses");
    scene.*field.value = std::move(values);
    return true;
  }
  return false;
}

/// A field of a scene by its name, and its value in words.
struct FieldInWords {
  std::string name, words;
};

/// All fields of a scene. Those with words, given to set_field in this order, make the same scene
/// again, bit by bit. One number stands for equal ones, and an empty list has no words.
inline std::vector<FieldInWords> fields_in_words(const Scene &scene) {
  std::vector<FieldInWords> fields{{"masses", std::to_string(scene.masses())}};
  for (const auto &field : list_fields) {
    const std::vector<double> &values = scene.*field.value;
    const std::string first = values.empty() ? "" : words::words_of(values.front());
    const auto is_first = [&](double value) { return words::words_of(value) == first; };
    const bool all_equal = std::all_of(values.begin(), values.end(), is_first);
    fields.push_back({field.name, all_equal ? first : words::joined(values)});
  }
  for (const auto &field : scalar_fields)
    fields.push_back({field.name, words::words_of(scene.*field.value)});
  fields.push_back({"stop", scene.stops.empty() ? "none" : words::joined(scene.stops)});
  return fields;
}

}  // namespace vibro_impact
