#include "tables.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace vibro_impact::runner {

namespace {

// Large enough that the calls of the system cost nothing beside the rows.
constexpr std::size_t block = 1 << 16;

}  // namespace

std::string sample_header(int masses) {
  std::string header = "time";
  for (int i = 1; i <= masses; ++i) header += ",x" + std::to_string(i);
  return header;
}

StreamedTable::StreamedTable(Destination to, const std::string &header)
    : file(std::move(to)), rows(header) {
}

void StreamedTable::write_full_block() {
  if (rows.text.size() < block) return;
  file.write(rows.text);
  rows.text.clear();
}

void StreamedTable::complete() {
  file.write(rows.text);
  rows.text.clear();
  file.complete();
}

void EventRows::event(const Event &event, const Moment &) {
  if (event.time < from) return;
  table.rows.row(event.time, event.mass, std::string_view(name(event.kind)), event.velocity_before,
                 event.velocity_after, contact_mode_name(event.held));
  table.write_full_block();
}

void SampleRows::sample(const Moment &moment) {
  ++taken;
  table.rows.cell(moment.time);
  for (int mass = 1; mass <= moment.masses(); ++mass) table.rows.cell(moment.displacement(mass));
  table.rows.end_row();
  table.write_full_block();
}

double SampleRows::reach(double time) const {
  if (taken > 0) time = std::max(time, sample_time(from, to, every, taken - 1));
  // `sample_time` takes one that lies beyond by rounding for one that is due.
  return std::min(time, next_time() * (1.0 - 1e-15));
}

std::size_t samples_taken(double from, double every, double time) {
  if (time < from) return 0;
  // The quotient is right but for rounding.
  const double about = std::min(std::floor((time - from) / every), 0x1p53);
  auto taken = static_cast<std::size_t>(std::max(about - 1.0, 0.0));
  while (sample_time(from, time, every, taken) < std::numeric_limits<double>::infinity()) ++taken;
  return taken;
}

}  // namespace vibro_impact::runner
