#include "interrupt.hpp"

#include <unistd.h>

#include <csignal>

namespace vibro_impact::runner {

namespace {

// A signal finds its way to the program through a variable like this and no other.
volatile std::sig_atomic_t came = 0;

constexpr unsigned patience = 2;  // seconds

void remember(int signal) {
  if (signal == SIGALRM) raise(came);  // nobody has asked for it
  came = signal;
  alarm(patience);
}

}  // namespace

void remember_signals() {
  struct sigaction now = {}, action = {};
  action.sa_handler = remember;
  action.sa_flags = SA_RESTART | SA_RESETHAND;  // what is being written is written, once
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGALRM})
    if (sigaction(signal, nullptr, &now) == 0 && now.sa_handler != SIG_IGN)
      sigaction(signal, &action, nullptr);
}

int signal_that_came() {
  if (came != 0) alarm(0);
  return came;
}

}  // namespace vibro_impact::runner
