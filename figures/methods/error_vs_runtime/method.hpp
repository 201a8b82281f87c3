// What every method of the work-precision figure is given and what it returns.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "vibro_impact/scene.hpp"

// Of record.hpp, which is C++20; two of the methods compile as C++17 only.
namespace vibro_impact {
enum class EventKind;
}

namespace vibro_impact::comparison {

// Displacement and velocity of both masses, and which of them rests on its stop.
struct TwoMassState {
  double time = 0.0;
  std::array<double, 2> displacement = {}, velocity = {};
  std::array<bool, 2> held = {};
};

// One event of one mass. `velocity_before` is known for the impacts of the reference and may be
// left out by a method.
struct Happened {
  double time = 0.0;
  int mass = 1;         // from 1
  EventKind kind = {};  // an impact
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

// What a run of a method gives. `failure` is empty when it reached the end; otherwise it says in
// one line where and why it did not.
struct Result {
  std::vector<Happened> events = {};
  TwoMassState end = {};
  long long work = 0;  // right-hand sides, time steps or expansions: see Method::work
  long long impacts = 0;
  std::string failure = {};
};

// A method and the settings it is swept over. A method with the same settings on every machine does
// the same work on every machine.
struct Method {
  std::string name;
  std::string setting;  // what is swept: tolerance, time step, stiffness
  std::string work;     // what Result::work counts
  std::vector<double> settings;
  Result (*run)(const Problem &problem, double setting);
};

// The families, one file each. A family whose package was not found at build time is empty.
std::vector<Method> this_library();
std::vector<Method> odeint_with_dense_output();
std::vector<Method> odeint_rosenbrock();
std::vector<Method> odeint_without_dense_output();
std::vector<Method> cvode();
std::vector<Method> siconos_time_stepping();
std::vector<Method> siconos_event_driven();
std::vector<Method> plain_event_driven();
std::vector<Method> stiff_spring();

// All of them, in the order of the figure, and one line for every family that is not built.
struct Methods {
  std::vector<Method> methods;
  std::vector<std::string> left_out;
};
Methods all_methods();

}  // namespace vibro_impact::comparison
