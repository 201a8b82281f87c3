// The two tables of a run, written row by row while it goes on.
#pragma once

#include <cstddef>
#include <string>

#include "interrupt.hpp"
#include "output.hpp"
#include "vibro_impact/record.hpp"
#include "vibro_impact/table.hpp"

namespace vibro_impact::runner {

// A table that keeps no more than a block of its rows. As a recorder it ends the run when they
// cannot be written, and at a signal: a flight that nothing disturbs has any number of samples.
struct StreamedTable {
  Output file;
  Table rows;  // not yet written

  StreamedTable(const Named &to, const std::string &header) : file(to), rows(header) {
  }
  bool done() const {
    return file.failed() || signal_that_came() != 0;
  }
  void end_row();
  void complete();
};

// A recorder of the events from time `from` on.
struct EventRows : StreamedTable {
  double from;

  EventRows(const Named &to, double begin)
      : StreamedTable(to, "time,mass,event,velocity_before,velocity_after,contact_mode"),
        from(begin) {
  }
  void event(const Event &event, const Moment &);
};

// When samples are taken: at from, from + every, ... up to `to`; and how many have been.
struct SampleTimes {
  double from, to, every;
  std::size_t taken;

  double next() const {
    return sample_time(from, to, every, taken);
  }
  // The time up to which a table of them reaches when the run has ended at `time`: that itself, but
  // for the rounding beside a sample. `samples_taken` gives `taken` there.
  double reach(double time) const;
};

// How many samples at from, from + every, ... a run to `time` has taken.
std::size_t samples_taken(double from, double every, double time);

// A recorder of the displacements at such times.
struct SampleRows : StreamedTable {
  SampleTimes at;

  SampleRows(const Named &to, int masses, const SampleTimes &times);
  double next_time() const {
    return at.next();
  }
  void sample(const Moment &moment);
};

}  // namespace vibro_impact::runner
