#include "interrupt.hpp"

#include <csignal>
#include <initializer_list>

namespace vibro_impact::runner {

namespace {

// A signal finds its way to the program through a variable like this and no other.
volatile std::sig_atomic_t came = 0;

constexpr auto signals = {SIGINT, SIGTERM, SIGHUP};

}  // namespace

void remember_signals() {
  for (const int signal : signals) {
    struct sigaction now = {};
    if (sigaction(signal, nullptr, &now) != 0 || now.sa_handler == SIG_IGN) continue;
    struct sigaction wanted = {};
    wanted.sa_handler = [](int number) {
      came = number;
      struct sigaction at_once = {};
      at_once.sa_handler = SIG_DFL;
      for (const int other : signals) sigaction(other, &at_once, nullptr);
    };
    wanted.sa_flags = SA_RESTART;  // what is being written is written
    sigaction(signal, &wanted, nullptr);
  }
}

int signal_that_came() {
  return came;
}

}  // namespace vibro_impact::runner
