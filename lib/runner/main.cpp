// vibro-impact: runs the user's own scene and writes its event and sample tables.
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>

#include "options.hpp"
#include "run_command.hpp"
#include "streamed_file.hpp"

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
  try {
    Request request;
    if (const auto answer = parse(argc, argv, request)) {
      StreamedFile out(Destination{"-"});
      out.write(answer->text);
      out.complete();
      return 0;
    }
    remember_signals();
    return run_scene(request);
  } catch (const std::invalid_argument &bad) {
    return fail(bad.what(), 2);
  } catch (const std::exception &failure) {
    return fail(failure.what(), 1);
  }
}
