#include "summary.hpp"

namespace vibro_impact::runner {

Table table_of(const TotalsRecorder &totals, const Scene &scene) {
  Table table(
      "stop,mass,side,impacts,sticks,largest_speed,impulse,energy_lost,contact_time,"
      "pressing_impulse");
  for (std::size_t k = 0; k < totals.stops.size(); ++k) {
    const StopTotals &stop = totals.stops[k];
    table.row(k + 1, scene.stops[k].mass, name(scene.stops[k].side), stop.impacts, stop.sticks,
              stop.largest_speed, stop.taken.impulse, stop.taken.energy, stop.contact,
              stop.pressing);
  }
  return table;
}

}  // namespace vibro_impact::runner
