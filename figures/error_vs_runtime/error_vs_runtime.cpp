// Error against run time of this library and of the methods that one would otherwise pick, each
// method swept over its own tolerance or step. README.md says how each is used.
#include "figures/error_vs_runtime/methods/method.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <stdexcept>
#include <string>
#include <vector>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include "figures/driver.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::comparison;

// One method at one setting on one problem.
struct Trial {
  const Problem *problem;
  const Method *method;
  double setting;
  Result result = {};
  Error error = {};
  long long runs_per_sample = 1;
  std::vector<double> microseconds = {};  // one entry per sample
};

// A sample lasts at least this long, in seconds. The methods take turns, and the first run after
// another method pays some 0.1 ms for cold caches, which should not count for any of them.
constexpr double shortest_sample = 2.5e-3;

// Processor time of this thread, in which all methods run. It leaves out other programs.
double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double seconds_of(const Trial &trial) {
  const double begin = processor_seconds();
  for (long long i = 0; i < trial.runs_per_sample; ++i)
    trial.method->run(*trial.problem, trial.setting);
  return processor_seconds() - begin;
}

void add_sample(Trial &trial, double seconds) {
  trial.microseconds.push_back(1e6 * seconds / static_cast<double>(trial.runs_per_sample) /
                               runs_counted(*trial.problem));
}

// The first run of a trial gives its errors; further ones give how many runs make a sample.
void run_first(Trial &trial) {
  trial.result = trial.method->run(*trial.problem, trial.setting);
  trial.error = error_of(trial.result, *trial.problem);
  double seconds = seconds_of(trial);
  while (seconds < shortest_sample) {
    trial.runs_per_sample *= 2;
    seconds = seconds_of(trial);
  }
}

// A cell of text that may hold commas.
std::string in_quotes(const std::string &text) {
  return '"' + text + '"';
}

Table table_of(const std::vector<Trial> &trials) {
  Table table("problem,method,setting,error_time,fastest_us,slowest_us,impacts,failure");
  for (const Trial &trial : trials) {
    const auto [fastest, slowest] = std::ranges::minmax_element(trial.microseconds);
    table.row(trial.problem->name, in_quotes(trial.method->name), trial.setting, trial.error.time,
              *fastest, *slowest, trial.result.impacts, in_quotes(trial.error.failure));
  }
  return table;
}

// Repeats of every trial. The fastest one is the run time, because whatever else runs on the
// processor only adds to a time, by up to a factor of two.
constexpr int repeats = 10;

std::vector<Trial> measured(const std::vector<Problem> &cases, const std::vector<Method> &methods) {
  std::vector<Trial> trials;
  for (const Problem &problem : cases)
    for (const Method &method : methods)
      if (problem.scene.masses() == 2 || method.for_chains)
        for (const double setting : method.settings) trials.push_back({&problem, &method, setting});
  Progress progress("error_vs_runtime", static_cast<double>(trials.size()) * (repeats + 1));
  for (Trial &trial : trials) {
    run_first(trial);
    progress.advance();
  }
  // The methods take turns, so that a busy machine disturbs all of them alike.
  for (int repeat = 0; repeat < repeats; ++repeat)
    for (Trial &trial : trials) {
      add_sample(trial, seconds_of(trial));
      progress.advance();
    }
  return trials;
}

// Numbers below 1e-308 count as zero for all methods. A long chain at rest has them at its end,
// where DOP853 takes 2.5 times as long on a processor of Intel with them, but not on one of AMD.
void count_the_smallest_numbers_as_zero() {
#ifdef __SSE2__
  _mm_setcsr(_mm_getcsr() | 0x8040);  // results (flush to zero) and operands (denormals are zero)
#endif
}

}  // namespace

int main(int argc, char **argv) {
  std::string chains = "no";
  const auto compare = [&](const std::filesystem::path &output) {
    if (chains != "yes" && chains != "no")
      throw std::invalid_argument("--chains " + chains + ": must be yes or no");
    count_the_smallest_numbers_as_zero();
    std::vector<Problem> cases = problems(REFERENCE_DIR);
    if (chains == "yes")
      for (const int masses : {10, 200}) cases.push_back(chain_problem(REFERENCE_DIR, masses));
    const std::vector<Method> methods = all_methods();
    write(table_of(measured(cases, methods)), output / "error_vs_runtime.csv");
  };
  return figures::main_of_driver(
      argc, argv, "Error against run time of this library and other methods", compare,
      {{"--chains", "Whether chains of 10 and 200 masses are measured, too: yes or no", &chains}});
}
