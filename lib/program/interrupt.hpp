// Signals that ask the program to come to an end: SIGINT (Ctrl-C), SIGTERM and SIGHUP. Those that
// were ignored when the program began (nohup) are ignored still.
#pragma once

#include <string>

namespace vibro_impact::runner {

// Thrown where the program ends because of a signal, its files being in order.
struct EndedBySignal {
  int signal;
  std::string said;  // for standard error; may be empty
};

// From now on the first of them is remembered. The program may end by itself, with whole tables; it
// is ended by a second signal, and when nobody has asked for the first within two seconds: in the
// building of a contact mode of thousands of masses, or waiting for the reader of a pipe.
void remember_signals();

// The signal that came; 0: none. May be asked as often as one likes.
int signal_that_came();

}  // namespace vibro_impact::runner
