#include "tables.hpp"

#include "reference/scenes/extreme_scenes.hpp"

#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace vibro_impact_reference {

namespace {

/// Which events go to the table. Before a stick, the impacts of that mass slower than `slowest`
/// (per mass) are left out, back to the first faster one or to the first event of another mass: an
/// interrupted or incomplete chatter stays whole.
std::vector<bool> kept(const std::vector<Event> &events, const Vector &slowest) {
  std::vector<bool> keep(events.size(), true);
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (events[i].kind != EventKind::stick) continue;
    for (std::size_t j = i; j-- > 0;) {
      const Event &earlier = events[j];
      if (earlier.kind != EventKind::impact || earlier.mass != events[i].mass) break;
      if (abs(earlier.velocity_before) >= slowest[earlier.mass]) break;
      keep[j] = false;
    }
  }
  return keep;
}

}  // namespace

std::string event_rows(const std::vector<Event> &events, const Vector &slowest,
                       const std::string &lead) {
  std::ostringstream table;
  const std::vector<bool> keep = kept(events, slowest);
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (!keep[i]) continue;
    const Event &e = events[i];
    table << lead << e.time.str(30) << ',' << e.mass + 1 << ',' << name(e.kind) << ','
          << e.velocity_before.str(30) << ',' << e.velocity_after.str(30) << ','
          << contact_mode(e.stuck) << '\n';
  }
  return table.str();
}

std::string events_table(const std::vector<Event> &events, std::size_t masses) {
  return columns + event_rows(events, Vector(masses, kept_speed), "");
}

double forcing_periods(double count, const vibro_impact::Scene &scene) {
  return count * 6.283185307179586477 / scene.omega;
}

// Far from the ends of a long chain masses hit within 1e-50 of each other. Zeros closer than 1e-30
// are one event, so that a time may be off by as much.
std::string chain_table(int masses) {
  const vibro_impact::Scene scene = vibro_impact::extremes::chain_of_stops(masses);
  const Resolution resolution{.roots = {.newton = true, .least = Real("1e-33")}};
  const Run run = simulate(in_digits(scene, forcing_periods(2.0, scene)), resolution);
  return events_table(run.events, scene.mass.size());
}

namespace {

using numbers::Arguments;

/// The shortest decimal number to which a double is the nearest one: a formula takes a parameter as
/// the paper prints it, not the double nearest to that.
Real as_printed(double value) {
  return Real(fmt::format("{}", value));
}

/// The number of masses of the scene. Throws std::invalid_argument unless all its masses and
/// springs are one.
int masses_of_unit_chain(const Arguments &given) {
  const vibro_impact::Scene scene = numbers::run_of(given).scene;
  for (std::size_t i = 0; i < scene.mass.size(); ++i)
    if (scene.mass[i] != 1.0 || scene.stiffness[i] != 1.0)
      throw std::invalid_argument("a formula: the masses and springs must be one");
  return scene.masses();
}

/// The angle of mode `mode` (from 1) in a chain of n equal masses on equal springs, fixed at one
/// end and free at the other: the displacement of mass p is proportional to sin(p * angle).
Real mode_angle(int mode, int masses) {
  return (2 * mode - 1) * acos(Real(-1)) / (2 * masses + 1);
}

const std::string run_names = numbers::run_names;

/// Key numbers that have a formula.
const numbers::Quantities<DigitsEngine> formulas{
    // Eigenvalue of E, in the paper's order.
    {"eigenvalue",
     {run_names + " mode",
      [](DigitsEngine &, const Arguments &given) {
        return 2 - 2 * cos(mode_angle(given.mass("mode"), masses_of_unit_chain(given)));
      }}},
    // Component of the normalized eigenvector whose last component is positive.
    {"mode_shape",
     {run_names + " mode mass",
      [](DigitsEngine &, const Arguments &given) {
        const int masses = masses_of_unit_chain(given);
        const Real angle = mode_angle(given.mass("mode"), masses);
        const Real component = 2 * sin(given.mass("mass") * angle) / sqrt(Real(2 * masses + 1));
        return sin(masses * angle) > 0 ? component : Real(-component);
      }}},
    // The line x1' = (k/c)(s2 - x1) of Eq. 23.
    {"exit_slope",
     {run_names + " mass",
      [](DigitsEngine &, const Arguments &given) {
        return -1 / as_printed(numbers::run_of(given).scene.beta);
      }}},
    {"exit_intercept",
     {run_names + " mass",
      [](DigitsEngine &, const Arguments &given) {
        const vibro_impact::Scene scene = numbers::run_of(given).scene;
        const std::size_t stop = numbers::stop_of(scene, given.mass("mass"));
        return as_printed(scene.stops[stop].position) / as_printed(scene.beta);
      }}},
    // A mass that bounces at its equilibrium, with the damping ratio zeta = c/(2 sqrt(k m)), hits
    // its stop at half periods of its damped motion.
    {"interval", {numbers::event_names, [](DigitsEngine &, const Arguments &given) {
                    masses_of_unit_chain(given);
                    const Real zeta = as_printed(numbers::run_of(given).scene.beta) / 2;
                    return acos(Real(-1)) / sqrt(1 - zeta * zeta);
                  }}}};

}  // namespace

std::string digits_of(DigitsEngine &engine, const numbers::CheckedNumber &number) {
  static const auto of_runs = numbers::common_quantities<DigitsEngine>();
  const auto &quantities = number.kind == numbers::Kind::formula ? formulas : of_runs;
  // The frequencies are known to the width of a bracket, all else to 30 digits.
  const int known_digits = number.quantity.ends_with("_frequency") ? 18 : 30;
  return numbers::answer(engine, quantities, number).str(known_digits);
}

std::string filled_table() {
  const auto known = numbers::checked_numbers(REFERENCE_DIR);
  std::ifstream file = vibro_impact::truth::opened(REFERENCE_DIR "/checked_numbers.csv");
  std::string table, line;
  std::getline(file, line);
  table = line + '\n';
  DigitsEngine engine;
  for (const numbers::CheckedNumber &number : known) {
    std::getline(file, line);
    const auto comma = line.find(','), second = line.find(',', comma + 1);
    const std::string digits = number.of_the_paper() ? digits_of(engine, number) : number.digits;
    table += number.id + ',' + digits + line.substr(second) + '\n';
  }
  return table;
}

std::string digits_of(const std::string &id) {
  DigitsEngine engine;
  for (const numbers::CheckedNumber &number : numbers::checked_numbers(REFERENCE_DIR))
    if (number.id == id && number.of_the_paper()) return digits_of(engine, number) + '\n';
  throw std::runtime_error("key number '" + id + "': the table has no such row");
}

}  // namespace vibro_impact_reference
