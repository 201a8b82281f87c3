// Signals that ask the program to come to an end: SIGINT (Ctrl-C), SIGTERM and SIGHUP.
#pragma once

namespace vibro_impact::runner {

// From now on the first of them is remembered and no more; a second one ends the program at once.
// Those that were ignored when the program began (nohup) are ignored still.
void remember_signals();

// The signal that came; 0: none. May be asked as often as one likes.
int signal_that_came();

}  // namespace vibro_impact::runner
