// The two tables of a run, written row by row while it goes on.
#pragma once

#include <cstddef>
#include <string>

#include "streamed_file.hpp"
#include "vibro_impact/record.hpp"
#include "vibro_impact/table.hpp"

namespace vibro_impact::runner {

// A table that keeps no more than a block of its rows.
struct StreamedTable {
  StreamedFile file;
  Table rows;  // not yet written

  StreamedTable(Destination to, const std::string &header);
  void write_full_block();
  void complete();
};

// A recorder of the events from time `from` on. Ends the run when they cannot be written.
struct EventRows {
  StreamedTable &table;
  double from = 0.0;

  void event(const Event &event, const Moment &);
  bool done() const {
    return table.file.failed();
  }
};

// A recorder of the displacements at from, from + every, ... up to `to`.
struct SampleRows {
  StreamedTable &table;
  double from = 0.0, to = 0.0, every = 0.0;
  std::size_t taken = 0;

  double next_time() const {
    return sample_time(from, to, every, taken);
  }
  void sample(const Moment &moment);
  bool done() const {
    return table.file.failed();
  }
  // The time up to which the table reaches when the run has ended at `time`: that itself, but for
  // the rounding beside a sample. `samples_taken` gives `taken` there.
  double reach(double time) const;
};

inline constexpr const char *event_header =
    "time,mass,event,velocity_before,velocity_after,contact_mode";
std::string sample_header(int masses);

// How many samples at from, from + every, ... a run to `time` has taken.
std::size_t samples_taken(double from, double every, double time);

}  // namespace vibro_impact::runner
