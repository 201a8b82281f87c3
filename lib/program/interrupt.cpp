#include "interrupt.hpp"

#include <unistd.h>

#include <csignal>

namespace vibro_impact::runner {

namespace {

// A signal finds its way to the program through a variable like this and no other.
volatile std::sig_atomic_t came = 0;

constexpr unsigned patience = 2;  // seconds
constexpr char said[] =
    "vibro-impact: ended by the signal, no table is whole; a sweep goes on with --resume\n";

void remember(int signal) {
  if (signal == SIGALRM) {  // nobody has asked for it
    static_cast<void>(!write(STDERR_FILENO, said, sizeof said - 1));
    raise(came);
  }
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
