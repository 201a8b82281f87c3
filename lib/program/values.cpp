#include "values.hpp"

#include <charconv>
#include <cmath>
#include <optional>

#include "refuse.hpp"

namespace vibro_impact::runner {

namespace {

// A whole word as a number; from_chars takes no locale and no leading space.
std::optional<double> parsed(const std::string &word) {
  double value = 0.0;
  const char *end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (stop != end || error != std::errc()) return std::nullopt;
  return value;
}

bool is_whole(double value, double most) {
  return value >= 1.0 && value <= most && value == std::floor(value);
}

// The parts of what was given, `text`, between commas or colons, also empty ones.
std::vector<std::string> split(const std::string &text, char separator) {
  return CLI::detail::split(text + separator, separator);
}

// One of them as a number.
double part(const std::string &option, const std::string &text, const std::string &word) {
  const auto value = parsed(word);
  if (!value) refuse("{} {}: '{}' is not a number in double precision", option, text, word);
  return *value;
}

// CLI11 puts the name of the option before what such a function returns.
CLI::Validator that(const std::function<bool(double)> &holds, const std::string &rule) {
  return {[=](std::string &text) -> std::string {
            const auto value = parsed(text);
            return value && holds(*value) ? "" : fmt::format("'{}' must be {}", text, rule);
          },
          ""};
}

}  // namespace

double number(const std::string &option, const std::string &word) {
  return part(option, word, word);
}

CLI::Validator number_from(double least) {
  return that([least](double value) { return value >= least; },
              fmt::format("a number, {} or more", least));
}

CLI::Validator positive_number() {
  return that([](double value) { return std::isfinite(value) && value > 0.0; },
              "a positive and finite number");
}

CLI::Validator whole_number(double most) {
  return that([most](double value) { return is_whole(value, most); },
              fmt::format("a whole number from 1 to {}", most));
}

CLI::Validator file_name() {
  return {[](std::string &text) { return text.empty() ? "must name a file" : std::string(); }, ""};
}

std::vector<double> per_mass(const std::string &option, const std::string &text,
                             std::size_t masses) {
  std::vector<double> values;
  for (const std::string &word : split(text, ',')) values.push_back(part(option, text, word));
  if (values.size() == 1) values.assign(masses, values.front());
  if (values.size() != masses)
    refuse("{} {}: {} values given, the chain has {} masses", option, text, values.size(), masses);
  return values;
}

Axis axis_of(const std::string &option, const Parameter &parameter, const std::string &text) {
  const auto parts = split(text, ':');
  if (parts.size() != 3) refuse("{} {}: must read from:to:count", option, text);
  const double count = part(option, text, parts[2]);
  if (!is_whole(count, 1e9))
    refuse("{} {}: the count must be a whole number from 1 to 1e9", option, text);
  return {parameter, part(option, text, parts[0]), part(option, text, parts[1]),
          static_cast<std::size_t>(count)};
}

Stop stop_of(const std::string &text) {
  const auto parts = split(text, ':');
  if (parts.size() < 3 || parts.size() > 4 || (parts[1] != "lower" && parts[1] != "upper"))
    refuse(
        "--stop {}: must read mass:side:position or mass:side:position:restitution, with side "
        "lower or upper",
        text);
  const double mass = part("--stop", text, parts[0]);
  if (!is_whole(mass, most_masses))
    refuse("--stop {}: the mass must be a whole number, counted from 1", text);
  Stop stop{static_cast<int>(mass), parts[1] == "lower" ? Side::lower : Side::upper,
            part("--stop", text, parts[2])};
  if (parts.size() == 4) {
    stop.restitution = part("--stop", text, parts[3]);
    if (!(*stop.restitution >= 0.0 && *stop.restitution <= 1.0))
      refuse("--stop {}: the restitution must lie in [0, 1]", text);
  }
  return stop;
}

double beta_of(const std::string &text, const std::vector<double> &stiffness) {
  const auto damping = per_mass("--damping", text, stiffness.size());
  double beta = 0.0;
  for (std::size_t i = stiffness.size(); i-- > 0;) {
    if (!(std::isfinite(damping[i]) && damping[i] >= 0.0))
      refuse("--damping {}: must be non-negative and finite", text);
    if (stiffness[i] > 0.0) beta = damping[i] / stiffness[i];
  }
  for (std::size_t i = 0; i < stiffness.size(); ++i)
    if (!(std::abs(damping[i] - beta * stiffness[i]) <= 1e-12 * damping[i]))
      refuse(
          "--damping {}: must be proportional to the stiffness, link by link (C = beta K; where "
          "link {} has no stiffness, 0); or give --beta",
          text, i + 1);
  return beta;
}

}  // namespace vibro_impact::runner
