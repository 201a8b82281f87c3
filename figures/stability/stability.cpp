// Stability: compares every extreme scene with its true events. The table has one row per case.
#include <fmt/format.h>

#include <stdexcept>

#include "figures/driver.hpp"
#include "figures/measures/extreme_verdict.hpp"

namespace {

using namespace vibro_impact;

// Throws std::runtime_error naming the cases that fail, once the table is written.
void judge_all(const std::filesystem::path &output) {
  const auto tables = truth::read_event_tables(REFERENCE_DIR "/extreme_events.csv", "case");
  const auto cases = truth::extreme_cases();
  Progress progress("stability", static_cast<double>(cases.size()));
  Table table(
      "case,group,truth,events,time_error,time_sensitivity,velocity_error,velocity_sensitivity,"
      "penetration,verdict");
  std::string failed;
  for (const truth::Case &extreme : cases) {
    const stability::ExtremeErrors m = stability::measure(extreme, tables);
    const bool pass = stability::passes(m, extreme.truth);
    table.row(extreme.name, extreme.group,
              truth::truth_words[static_cast<std::size_t>(extreme.truth)], m.events, m.error.time,
              m.sensitivity.time, m.error.velocity, m.sensitivity.velocity, m.penetration,
              pass ? "pass" : "fail");
    if (!pass)
      failed += fmt::format("; {}: {} time off by {:.1e}, velocity by {:.1e}", extreme.name,
                            m.difference, m.error.time, m.error.velocity);
    progress.advance();
  }
  write(table, output / "stability.csv");
  if (!failed.empty()) throw std::runtime_error("these cases fail" + failed);
}

}  // namespace

int main(int argc, char **argv) {
  return figures::main_of_driver(
      argc, argv, "Stability: extreme scenes against 50-digit and exact motions", judge_all);
}
