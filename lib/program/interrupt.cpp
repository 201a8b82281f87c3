#include "interrupt.hpp"

#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <ctime>

namespace vibro_impact::runner {

namespace {

// A signal finds its way to the program through variables like these and no others.
volatile std::sig_atomic_t came = 0, since = 0;  // in tenths of a second

constexpr unsigned patience = 2;  // seconds
constexpr char said[] =
    "vibro-impact: ended by the signal, no table is whole; a sweep goes on with --resume\n";

void remember(int signal) {
  timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  const auto tenths = static_cast<int>(now.tv_sec % 1'000'000 * 10 + now.tv_nsec / 100'000'000);
  if (came == 0) {
    came = signal;
    since = tenths;
    alarm(patience);
  } else if (signal == SIGALRM || std::abs(tenths - since) > 1) {  // `timeout` sends it twice
    if (signal == SIGALRM) static_cast<void>(!write(STDERR_FILENO, said, sizeof said - 1));
    std::signal(came, SIG_DFL);
    raise(came);
  }
}

}  // namespace

void remember_signals() {
  struct sigaction now = {}, action = {};
  action.sa_handler = remember;
  action.sa_flags = SA_RESTART;  // what is being written is written
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGALRM})
    if (sigaction(signal, nullptr, &now) == 0 && now.sa_handler != SIG_IGN)
      sigaction(signal, &action, nullptr);
}

int signal_that_came() {
  if (came != 0) alarm(0);
  return came;
}

}  // namespace vibro_impact::runner
