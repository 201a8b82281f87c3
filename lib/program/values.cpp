#include "values.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "bad_input.hpp"

namespace vibro_impact::runner {

namespace {

// A whole token as a number; from_chars takes no locale and no leading space. `given` is what the
// user wrote, of which `token` may be a part.
double number_in(const std::string &option, const std::string &token, const std::string &given) {
  double value = 0.0;
  const char *end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, value);
  if (stop != end || error == std::errc::invalid_argument)
    throw BadInput(fmt::format("{} {}: '{}' is not a number", option, given, token));
  if (error != std::errc())
    throw BadInput(fmt::format("{} {}: beyond the range of double precision", option, given));
  return value;
}

// The parts of a text between commas or colons, also empty ones.
std::vector<std::string> split(const std::string &text, char separator) {
  return CLI::detail::split(text + separator, separator);
}

// CLI11 puts the name of the option before what such a function returns.
CLI::Validator that(const std::function<bool(double)> &holds, const std::string &rule) {
  return {[=](std::string &text) -> std::string {
            try {
              return holds(number_in("", text, text)) ? "" : text + " must be " + rule;
            } catch (const BadInput &error) {
              const std::string said = error.what();
              return said.substr(said.find(": ") + 2);  // without the option and its value
            }
          },
          ""};
}

}  // namespace

double number(const std::string &option, const std::string &token) {
  return number_in(option, token, token);
}

CLI::Validator number_from(double least) {
  return that([least](double value) { return value >= least; }, fmt::format("{} or more", least));
}

CLI::Validator positive_number() {
  return that([](double value) { return std::isfinite(value) && value > 0.0; },
              "positive and finite");
}

CLI::Validator whole_number(long long most) {
  return that(
      [most](double value) {
        return value >= 1.0 && value <= static_cast<double>(most) && value == std::floor(value);
      },
      fmt::format("a whole number from 1 to {}", most));
}

std::vector<double> per_mass(const std::string &option, const std::string &text,
                             std::size_t masses) {
  std::vector<double> values;
  for (const std::string &token : split(text, ','))
    values.push_back(number_in(option, token, text));
  if (values.size() == 1) values.assign(masses, values.front());
  if (values.size() != masses)
    throw BadInput(fmt::format("{} {}: {} values given, the chain has {} masses", option, text,
                               values.size(), masses));
  return values;
}

Axis axis_of(const std::string &option, const Parameter &parameter, const std::string &text) {
  const auto parts = split(text, ':');
  if (parts.size() != 3)
    throw BadInput(fmt::format("{} {}: must read from:to:count", option, text));
  const double count = number_in(option, parts[2], text);
  if (!(count >= 1.0 && count <= 1e9) || count != std::floor(count))
    throw BadInput(
        fmt::format("{} {}: the count must be a whole number from 1 to 1e9", option, text));
  return {parameter, number_in(option, parts[0], text), number_in(option, parts[1], text),
          static_cast<std::size_t>(count)};
}

Stop stop_of(const std::string &text) {
  const auto parts = split(text, ':');
  if (parts.size() < 3 || parts.size() > 4 || (parts[1] != "lower" && parts[1] != "upper"))
    throw BadInput(fmt::format(
        "--stop {}: must read mass:side:position or mass:side:position:restitution, with side "
        "lower or upper",
        text));
  const double mass = number_in("--stop", parts[0], text);
  if (!(mass >= 1.0 && mass <= most_masses) || mass != std::floor(mass))
    throw BadInput(fmt::format("--stop {}: the mass must be a whole number, counted from 1", text));
  Stop stop{static_cast<int>(mass), parts[1] == "lower" ? Side::lower : Side::upper,
            number_in("--stop", parts[2], text)};
  if (parts.size() == 4) {
    stop.restitution = number_in("--stop", parts[3], text);
    if (!(*stop.restitution >= 0.0 && *stop.restitution <= 1.0))
      throw BadInput(fmt::format("--stop {}: the restitution must lie in [0, 1]", text));
  }
  return stop;
}

double beta_of(const std::string &text, const std::vector<double> &stiffness) {
  const auto damping = per_mass("--damping", text, stiffness.size());
  double beta = 0.0;
  for (std::size_t i = stiffness.size(); i-- > 0;) {
    if (!(std::isfinite(damping[i]) && damping[i] >= 0.0))
      throw BadInput(fmt::format("--damping {}: must be non-negative and finite", text));
    if (stiffness[i] == 0.0 && damping[i] != 0.0)
      throw BadInput(
          fmt::format("--damping {}: link {} has no stiffness and so no damper (C = beta K): its "
                      "value must be 0; or give --beta",
                      text, i + 1));
    if (stiffness[i] > 0.0) beta = damping[i] / stiffness[i];
  }
  for (std::size_t i = 0; i < stiffness.size(); ++i)
    if (!(std::abs(damping[i] - beta * stiffness[i]) <= 1e-12 * damping[i]))
      throw BadInput(
          fmt::format("--damping {}: must be proportional to the stiffness, link by link "
                      "(C = beta K); or give --beta",
                      text));
  return beta;
}

}  // namespace vibro_impact::runner
