#include "interrupt.hpp"

#include <unistd.h>

#include <csignal>
#include <initializer_list>

namespace vibro_impact::runner {

namespace {

// A signal finds its way to the program through variables like these and no others.
volatile std::sig_atomic_t came = 0, heard = 0;
const char *last_words = nullptr;
std::size_t length_of_last_words = 0;

constexpr unsigned patience = 2;  // seconds

constexpr auto signals = {SIGINT, SIGTERM, SIGHUP};

void set(int signal, void (*handler)(int)) {
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;  // what is being written is written
  sigaction(signal, &action, nullptr);
}

void catch_signals(void (*handler)(int)) {
  for (const int signal : signals) {
    struct sigaction now = {};
    if (sigaction(signal, nullptr, &now) == 0 && now.sa_handler != SIG_IGN) set(signal, handler);
  }
}

void remember(int number) {
  came = number;
  for (const int signal : signals) set(signal, SIG_DFL);
  set(SIGALRM, [](int) {
    if (heard == 0) raise(came);
  });
  alarm(patience);
}

void say_and_end(int number) {
  [[maybe_unused]] const auto written = write(STDERR_FILENO, last_words, length_of_last_words);
  set(number, SIG_DFL);
  raise(number);
}

}  // namespace

void remember_signals() {
  catch_signals(remember);
}

int signal_that_came() {
  if (came != 0) heard = 1;
  return came;
}

void say_when_interrupted(const std::string &text) {
  static std::string kept;
  kept = (isatty(STDERR_FILENO) != 0 ? "\r\033[K" : "") + text;  // over the progress line
  last_words = kept.data();
  length_of_last_words = kept.size();
  catch_signals(say_and_end);
}

}  // namespace vibro_impact::runner
