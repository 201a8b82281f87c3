#include "interrupt.hpp"

#include <unistd.h>

#include <csignal>

namespace vibro_impact::runner {

namespace {

// A signal finds its way to the program through a variable like this and no other.
volatile std::sig_atomic_t came = 0;

constexpr unsigned patience = 2;  // seconds

void set(int signal, void (*handler)(int)) {
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;  // what is being written is written
  sigaction(signal, &action, nullptr);
}

// The first signal is remembered; the second, or the alarm, ends the program by the first.
void remember(int number) {
  if (came != 0) {
    set(came, SIG_DFL);
    raise(came);
    return;
  }
  came = number;
  alarm(patience);
}

}  // namespace

void remember_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction now = {};
    if (sigaction(signal, nullptr, &now) == 0 && now.sa_handler != SIG_IGN) set(signal, remember);
  }
  set(SIGALRM, remember);
}

int signal_that_came() {
  if (came != 0) alarm(0);
  return came;
}

}  // namespace vibro_impact::runner
