// Ten masses, stops on three of them: impact velocities against the forcing frequency, from rest.
#include "reference/scenes/long_chain.hpp"

#include <fmt/format.h>

#include "figures/driver.hpp"
#include "figures/figure3.hpp"

namespace {

using namespace vibro_impact;

void draw(const std::filesystem::path &output) {
  const Axis axis{{Parameter::Kind::omega}, 0.05, 0.8, 401};
  std::vector<double> omegas;
  for (std::size_t k = 0; k < axis.count; ++k) omegas.push_back(axis.value(k));
  const auto chain_at = [&](double omega) {
    return with(figures::long_chain(), axis.parameter, omega);
  };
  Progress progress("long chain", static_cast<double>(omegas.size()));
  const std::vector<OrbitRecord> records = figures::records_from_rest(
      omegas, chain_at, figures::recorded_in_figure3(40), [&] { progress.advance(); });
  for (const Stop &stop : figures::long_chain().stops)
    write(figures::impact_velocities(omegas, records, stop.mass),
          output / fmt::format("long_chain{}.csv", stop.mass));
}

}  // namespace

int main(int argc, char **argv) {
  return figures::drive(argc, argv, "Ten masses, stops on three: impact velocities", draw);
}
