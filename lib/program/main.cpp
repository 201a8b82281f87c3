// vibro-impact: runs a scene of the user's and writes its tables, or sweeps over its parameters.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>

#include "options.hpp"
#include "refuse.hpp"

namespace {

using namespace vibro_impact::runner;

// Writes one line to standard error, and returns the exit status.
int fail(int status, std::string message, bool speaks) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  if (speaks) std::fputs(("vibro-impact: " + message + "\n").c_str(), stderr);
  return status;
}

void carry_out(const Request &request, const vibro_impact::Processes &processes) {
  if (const auto *sweep = std::get_if<SweepRequest>(&request)) return run_sweep(*sweep, processes);
  if (processes.rank() > 0) return;
  if (const auto *run = std::get_if<RunRequest>(&request)) return run_scene(*run);
  std::fputs(std::get<std::string>(request).c_str(), stdout);
}

}  // namespace

int main(int argc, char **argv) {
  const vibro_impact::Processes processes;
  bool all_alike = true;  // until the work begins, all processes fail alike, and one speaks
  int status = 0;
  const auto speaks = [&] { return !all_alike || processes.rank() == 0; };
  try {
    if (processes.size() > 1 && !vibro_impact::Processes::with_mpi())
      refuse("started as {} processes, but built without MPI", processes.size());
    const Request request = parse(argc, argv, vibro_impact::Processes::with_mpi());
    all_alike = false;
    carry_out(request, processes);
  } catch (const std::invalid_argument &refused) {
    status = fail(2, refused.what(), speaks());
  } catch (const std::exception &failure) {
    status = fail(1, failure.what(), speaks());
  }
  if (status != 0 && !all_alike) processes.end_others(status);
  return status;
}
