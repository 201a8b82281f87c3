// What every method of the work-precision figure is given, what it returns, and how far that is
// from the 50-digit reference. C++17: two of the methods do not compile as C++20.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "vibro_impact/scene.hpp"

// Of record.hpp, which is C++20. method.cpp checks that these are its values.
namespace vibro_impact {
enum class EventKind;
}

namespace vibro_impact::comparison {

constexpr EventKind impact{0}, stick{1}, release{2};

// Displacement and velocity of both masses, and which of them rests on its stop.
struct TwoMassState {
  double time = 0.0;
  std::array<double, 2> displacement = {}, velocity = {};
  std::array<bool, 2> held = {};
};

// One event of one mass, counted from 1. `velocity_before` is known for the impacts of the
// reference and may be left out by a method.
struct Happened {
  double time = 0.0;
  int mass = 1;
  EventKind kind = impact;
  double velocity_before = 0.0;
};

// A stretch of the motion of a scene with two masses, one stop each, and what the 50-digit
// generator says of it.
struct Problem {
  std::string name;
  Scene scene;
  TwoMassState start;
  double until = 0.0;
  std::vector<Happened> reference_events = {};
  TwoMassState reference_end = {};

  double periods() const;  // of the forcing
};

// Reads work_precision_states.csv and work_precision_events.csv from `reference`. Throws
// std::runtime_error naming the file that cannot be read or the scene that is not known.
std::vector<Problem> problems(const std::filesystem::path &reference);

// What a run of a method gives. `failure` is empty when it reached the end; otherwise it says in
// one line where and why it did not.
struct Result {
  std::vector<Happened> events = {};
  TwoMassState end = {};
  long long work = 0;  // right-hand sides, time steps or expansions: see Method::work
  long long impacts = 0;
  std::string failure = {};
};

// Impacts of the reference at least this fast are compared, up to the first slower one since the
// mass was last released (or the start): those a method has to resolve, whatever it does with the
// end of a chatter. Flights between them last longer than 0.05.
constexpr double slowest_impact_compared = 1e-2;

// Largest error in the time of a stick, a release or such an impact, and in the displacements and
// velocities at the end. NaN where `failure` says what is missing, what should not be there or why
// the method gave up.
struct Errors {
  double time, state;
  std::string failure = {};
};
Errors errors_of(const Result &result, const Problem &problem);

// A method and the settings it is swept over. A method with the same settings on every machine does
// the same work on every machine.
struct Method {
  std::string name;
  std::string setting;  // what is swept: tolerance, time step, stiffness
  std::string work;     // what Result::work counts
  std::vector<double> settings;
  Result (*run)(const Problem &problem, double setting);
};

// The families, one file each. cvode and siconos are built if their packages are found.
std::vector<Method> this_library();
std::vector<Method> plain_event_driven();
std::vector<Method> odeint();
std::vector<Method> cvode();
std::vector<Method> siconos();
std::vector<Method> stiff_spring();

// All of them, and the families that are not built.
struct Methods {
  std::vector<Method> methods;
  std::vector<std::string> left_out;
};
Methods all_methods();

}  // namespace vibro_impact::comparison
