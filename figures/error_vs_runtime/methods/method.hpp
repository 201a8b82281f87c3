// The methods that are compared by error against run time: what each is given, what it returns, and
// how far that is from the 50-digit reference.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reference/truth/case.hpp"
#include "vibro_impact/simulate.hpp"

namespace vibro_impact::comparison {

using truth::event_at;

// A piece of the motion of a scene, from a state at the time `from`, with its true events: those of
// the 50-digit generator. An instant has lost the last bits of the time.
struct Problem {
  std::string name;
  Scene scene;
  double from = 0.0;
  MotionState start = {};
  double until = 0.0;
  std::vector<Event> reference_events = {};
};

// Reads work_precision_states.csv and work_precision_events.csv from `reference`. Throws
// std::runtime_error naming the file that cannot be read or the scene that is not known.
std::vector<Problem> problems(const std::filesystem::path &reference);

// The motion from rest of a chain of 10 or 200 masses with two stops on each (extreme_scenes.hpp).
// Reads chain10_events.csv or chain200_events.csv.
Problem chain_problem(const std::filesystem::path &reference, int masses);

// The number by which the time of a run is divided: the forcing periods of a problem, or 1 if it is
// shorter than a period.
double runs_counted(const Problem &problem);

// The result of a run of a method. `failure` is empty if the run reached its end. Otherwise it says
// in one line where and why the run stopped.
struct Result {
  std::vector<Event> events = {};  // a method may leave out the velocities
  long long impacts = 0;
  std::string failure = {};

  // Adds an event of mass i + 1.
  void record(double time, std::size_t i, EventKind kind, double velocity = 0.0);
  // Counts an impact of mass i + 1. A method that resolves a chatter impact by impact fails after
  // 20,000 impacts.
  void count_impact(double time, std::size_t i, double speed);
};

// The impacts from the start or a release to the first slower impact are compared. Every method has
// to resolve these, however it ends a chatter, because the flights between them last longer than
// 0.05.
constexpr double slowest_impact_compared = 1e-2;

// Largest error in the time of a stick, a release or such an impact. It is NaN if `failure` names a
// missing event, a spurious event or the reason why the method gave up.
struct Error {
  double time;
  std::string failure = {};
};
Error error_of(const Result &result, const Problem &problem);

// A method and the settings it is swept over: tolerances, time steps, thresholds or stiffnesses.
// Settings are the same on every machine, and so is the work done.
struct Method {
  std::string name;
  std::vector<double> settings;
  Result (*run)(const Problem &problem, double setting);
  bool for_chains = false;  // knows any number of masses and stops
};

// The families, one file each.
std::vector<Method> this_library();
std::vector<Method> by_hand();
std::vector<Method> plain_event_driven();
std::vector<Method> dop853();
std::vector<Method> odeint();
std::vector<Method> stiff_spring();

// All methods.
std::vector<Method> all_methods();

}  // namespace vibro_impact::comparison
