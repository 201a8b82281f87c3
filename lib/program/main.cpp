// vibro-impact: runs the user's own scene and writes its event and sample tables, or sweeps over
// its parameters.
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>

#include "options.hpp"
#include "output.hpp"
#include "run_command.hpp"
#include "sweep_command.hpp"

namespace {

using namespace vibro_impact::runner;

int fail(std::string message, int status) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  std::fputs(("vibro-impact: " + message + "\n").c_str(), stderr);
  return status;
}

}  // namespace

int main(int argc, char **argv) {
  // A reader that leaves the pipe is met like a full disk: with a message, and no table half
  // written.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  const vibro_impact::Processes processes(argc, argv);
  // What all processes find wrong is said by one.
  const bool speaks = processes.rank() == 0;
  try {
    Request request;
    const auto answer = parse(argc, argv, request);
    if (request.sweep) {
      run_sweep(*request.sweep, processes);
      return 0;
    }
    if (!speaks) return 0;
    if (answer) {
      Output out({"standard output", "-"});
      out.write(answer->text);
      out.complete();
      return 0;
    }
    return run_scene(request);
  } catch (const ReaderLeft &) {
    return 128 + SIGPIPE;
  } catch (const std::invalid_argument &bad) {
    return speaks ? fail(bad.what(), 2) : 2;
  } catch (const std::exception &failure) {
    return speaks ? fail(failure.what(), 1) : 1;
  }
}
