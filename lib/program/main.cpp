// vibro-impact: runs the user's own scene and writes its event and sample tables, or sweeps over
// its parameters.
#include <fcntl.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "options.hpp"

namespace {

using namespace vibro_impact::runner;

// One line on standard error, from one of all processes.
int ends_with(int status, std::string said, bool speaks) {
  std::replace(said.begin(), said.end(), '\n', ' ');
  if (speaks && !said.empty()) std::fputs(("vibro-impact: " + said + "\n").c_str(), stderr);
  return status;
}

}  // namespace

int main(int argc, char **argv) {
  // Whatever of 0, 1 and 2 is closed must not become one of the program's files.
  for (int opened = 0; opened >= 0 && opened <= 2;) opened = open("/dev/null", O_RDONLY);
  // A reader that leaves a pipe is met like a full disk: no table is left half written.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  const vibro_impact::Processes processes;
  const bool speaks = processes.rank() == 0;
  try {
    Request request;
    const auto answer = parse(argc, argv, request);
    if (request.sweep) {
      run_sweep(*request.sweep, processes);
    } else if (speaks && answer) {
      std::fputs(answer->c_str(), stdout);
    } else if (speaks) {
      run_scene(request);
    }
    return 0;
  } catch (const EndedBySignal &end) {
    return ends_with(128 + end.signal, end.said, speaks);
  } catch (const std::invalid_argument &bad) {
    return ends_with(2, bad.what(), speaks);
  } catch (const std::exception &failure) {
    return ends_with(1, failure.what(), speaks);
  }
}
