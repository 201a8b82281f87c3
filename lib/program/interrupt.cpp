#include "interrupt.hpp"

#include <unistd.h>

#include <csignal>
#include <initializer_list>

namespace vibro_impact::runner {

namespace {

// A signal finds its way to the program through variables like these and no others.
volatile std::sig_atomic_t came = 0, heard = 0;

constexpr unsigned patience = 2;  // seconds

constexpr auto signals = {SIGINT, SIGTERM, SIGHUP};

void set(int signal, void (*handler)(int)) {
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;  // what is being written is written
  sigaction(signal, &action, nullptr);
}

void remember(int number) {
  came = number;
  for (const int signal : signals) set(signal, SIG_DFL);
  set(SIGALRM, [](int) {
    if (heard == 0) raise(came);
  });
  alarm(patience);
}

}  // namespace

void remember_signals() {
  for (const int signal : signals) {
    struct sigaction now = {};
    if (sigaction(signal, nullptr, &now) == 0 && now.sa_handler != SIG_IGN) set(signal, remember);
  }
}

int signal_that_came() {
  if (came != 0) heard = 1;
  return came;
}

}  // namespace vibro_impact::runner
