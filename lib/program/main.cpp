// vibro-impact: runs a scene of the user's and writes its tables, or sweeps over its parameters.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>

#include "files.hpp"
#include "options.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::runner;

void carry_out(const Request &request) {
  if (const auto *sweep = std::get_if<SweepRequest>(&request)) return run_sweep(*sweep);
  if (const auto *run = std::get_if<RunRequest>(&request)) return run_scene(*run);
  if (const auto *orbit = std::get_if<OrbitRequest>(&request)) return run_orbit(*orbit);
  write_text(std::get<std::string>(request), "-");
}

}  // namespace

int main(int argc, char **argv) {
  int status = 1;
  std::string message;
  try {
    carry_out(parse(argc, argv));
    return 0;
  } catch (const std::invalid_argument &refused) {
    status = 2;
    message = refused.what();
  } catch (const std::exception &failure) {
    message = failure.what();
  }
  std::replace_if(
      message.begin(), message.end(), [](unsigned char c) { return c < ' ' || c == 127; }, ' ');
  std::fputs(("vibro-impact: " + message + "\n").c_str(), stderr);
  return status;
}
