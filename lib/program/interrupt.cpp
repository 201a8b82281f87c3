#include "interrupt.hpp"

#include <sys/times.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

namespace vibro_impact::runner {

namespace {

// A signal finds its way to the program through variables like these and no others.
volatile std::sig_atomic_t came = 0, since = 0;  // in ticks of a hundredth of a second

constexpr unsigned patience = 2;  // seconds
constexpr char said[] =
    "vibro-impact: ended by the signal, no table is whole; a sweep goes on with --resume\n";

void remember(int signal) {
  const auto now = static_cast<int>(times(nullptr));
  if (came == 0) {
    since = now;
    came = signal;
    alarm(patience);
  } else if (signal == SIGALRM || std::abs(now - since) > 10) {  // `timeout` sends it twice
    if (signal == SIGALRM) static_cast<void>(!write(STDERR_FILENO, said, sizeof said - 1));
    std::signal(came, SIG_DFL);
    raise(came);
  }
}

}  // namespace

void remember_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGALRM})
    if (std::signal(signal, SIG_IGN) != SIG_IGN) std::signal(signal, remember);
}

int signal_that_came() {
  if (came != 0) alarm(0);
  return came;
}

}  // namespace vibro_impact::runner
