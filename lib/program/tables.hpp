// The two tables of a run, written row by row while it goes on.
#pragma once

#include <cstddef>
#include <string>

#include "output.hpp"
#include "vibro_impact/record.hpp"
#include "vibro_impact/table.hpp"

namespace vibro_impact::runner {

inline constexpr const char *event_header =
    "time,mass,event,velocity_before,velocity_after,contact_mode";
std::string sample_header(int masses);

// A table that keeps no more than a block of its rows.
struct StreamedTable {
  Output file;
  Table rows;  // not yet written

  StreamedTable(const Named &to, const std::string &header) : file(to), rows(header) {
  }
  void end_row();
  void complete();
};

// A recorder of the events from time `from` on. Ends the run when they cannot be written.
struct EventRows {
  StreamedTable table;
  double from;

  EventRows(const Named &to, double begin) : table(to, event_header), from(begin) {
  }
  void event(const Event &event, const Moment &);
  bool done() const {
    return table.file.failed();
  }
};

// A recorder of the displacements at from, from + every, ... up to `to`.
struct SampleRows {
  // When they are taken, and how many have been.
  struct Times {
    double from, to, every;
    std::size_t taken;
  };
  StreamedTable table;
  Times at;

  SampleRows(const Named &to, int masses, const Times &times)
      : table(to, sample_header(masses)), at(times) {
  }
  double next_time() const {
    return sample_time(at.from, at.to, at.every, at.taken);
  }
  void sample(const Moment &moment);
  bool done() const {
    return table.file.failed();
  }
};

// The time up to which a table of such samples reaches when the run has ended at `time`: that
// itself, but for the rounding beside a sample. `samples_taken` gives `taken` there.
double reach(const SampleRows::Times &samples, double time);

// How many samples at from, from + every, ... a run to `time` has taken.
std::size_t samples_taken(double from, double every, double time);

}  // namespace vibro_impact::runner
