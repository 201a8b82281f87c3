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

// From now on they are remembered, so that the program may end by itself, with whole tables. One
// that comes again, a tenth of a second later, ends it at once; so does the first where nobody has
// asked for it within two seconds: in the modes of thousands of masses, or waiting for a pipe.
void remember_signals();

// The signal that came; 0: none. May be asked as often as one likes.
int signal_that_came();

}  // namespace vibro_impact::runner
