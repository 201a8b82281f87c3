// Stability: every extreme scene against its true events. One row per case.
#include <fmt/format.h>

#include "extreme_verdict.hpp"
#include "figures/driver.hpp"

int main(int argc, char **argv) {
  using namespace vibro_impact;
  return figures::drive(
      argc, argv, "Stability: extreme scenes against 50-digit and exact motions",
      [](const std::filesystem::path &output) {
        const auto tables = figures::read_event_tables(EXTREME_EVENTS);
        const auto cases = extremes::all_cases();
        Progress progress("stability", static_cast<double>(cases.size()));
        Table table(
            "case,group,truth,events,time_error,conditioning,velocity_error,penetration,"
            "expansions,root_iterations,impacts,verdict");
        for (const extremes::Case &extreme : cases) {
          const extremes::Measured m = extremes::measure(extreme, tables);
          table.row(extreme.name, extreme.group, extremes::name(extreme.truth),
                    m.differences.matched, m.differences.time, m.conditioning,
                    m.differences.velocity, m.penetration, m.counters.expansions,
                    m.counters.root_iterations, m.counters.impacts, m.pass ? "pass" : "fail");
          if (!m.differences.first.empty())
            fmt::print(stderr, "stability: {}: {}\n", extreme.name, m.differences.first);
          progress.advance();
        }
        write(table, output / "stability.csv");
      });
}
