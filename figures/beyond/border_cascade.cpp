// The border orbits unfolded: how many impacts the chatter has that completes at the border,
// against the distance beyond it.
//
// border_cascade.csv          the counts, on the orbit followed away from every border orbit
// border_cascade_factor.csv   the factor of the distances from one impact to the next, derived
#include "border_cascade.hpp"

#include "figures/driver.hpp"
#include "figures/parallel.hpp"

namespace {

using namespace vibro_impact;

void draw(const std::filesystem::path &output) {
  constexpr double farthest = 1e-2;  // from the border, in omega
  std::vector<figures::CurveStart> borders = figures::starts_in_frequency();
  std::erase_if(borders, [](const auto &start) { return start.what != Bifurcation::border_orbit; });
  std::vector<std::vector<figures::UnfoldedChatter>> chatters(borders.size());
  figures::in_parallel(borders.size(), [&](std::size_t k) {
    chatters[k] = figures::unfolded(borders[k], farthest);
  });
  Table counts("orbit,omega,distance,impacts"), factor("restitution,factor");
  for (std::size_t k = 0; k < borders.size(); ++k)
    for (const auto &[distance, impacts] : chatters[k])
      counts.row(borders[k].name, borders[k].at.x, distance, impacts);
  const double r = paper::figure2().restitution;
  factor.row(r, figures::cascade_factor(r));
  write(counts, output / "border_cascade.csv");
  write(factor, output / "border_cascade_factor.csv");
}

}  // namespace

int main(int argc, char **argv) {
  return figures::drive(argc, argv, "Impacts added one by one beyond the border orbits", draw);
}
