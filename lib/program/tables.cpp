#include "tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibro_impact::runner {

namespace {

// Large enough that the calls of the system cost nothing beside the rows.
constexpr std::size_t block = 1 << 16;

}  // namespace

void StreamedTable::end_row() {
  rows.end_row();
  if (rows.text.size() < block) return;
  file.write(rows.text);
  rows.text.clear();
}

void StreamedTable::complete() {
  file.write(rows.text);
  file.complete();
}

void EventRows::event(const Event &event, const Moment &) {
  if (event.time < from) return;
  rows.cell(event.time);
  rows.cell(event.mass);
  rows.cell(std::string_view(name(event.kind)));
  rows.cell(event.velocity_before);
  rows.cell(event.velocity_after);
  rows.cell(contact_mode_name(event.held));
  end_row();
}

SampleRows::SampleRows(const Named &to, int masses, const SampleTimes &times)
    : StreamedTable(to, ""), at(times) {
  rows.text = "time";
  for (int i = 1; i <= masses; ++i) rows.text += fmt::format(",x{}", i);
  rows.text += "\n";
}

void SampleRows::sample(const Moment &moment) {
  ++at.taken;
  rows.cell(moment.time);
  for (int mass = 1; mass <= moment.masses(); ++mass) rows.cell(moment.displacement(mass));
  end_row();
}

double SampleTimes::reach(double time) const {
  if (taken > 0) time = std::max(time, sample_time(from, to, every, taken - 1));
  // `sample_time` takes one that lies beyond by rounding for one that is due.
  return std::min(time, next() * (1.0 - 1e-15));
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
