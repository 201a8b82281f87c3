// Chatters among the events of a run, and the number of sticking phases of a mass.
#pragma once

#include <vector>

#include "vibro_impact/record.hpp"

namespace vibro_impact {

// Consecutive impacts of a mass at one stop, each slower than the one before.
struct Chatter {
  std::size_t stop = 0;              // index in Scene::stops
  std::vector<std::size_t> impacts;  // indices of its events
  bool complete = false;             // it ends in sticking
};

// All chatters among the events of a run, in the order in which they begin. A single impact is a
// chatter of one.
std::vector<Chatter> chatters_of(const std::vector<Event> &events);

// The number of sticking phases of `mass` (from 1) that begin within `periods` forcing periods,
// after `settling` periods, of the motion from the scene's own initial state. Throws
// std::invalid_argument for a bad scene, mass or number of periods, and std::runtime_error when the
// run is given up.
int sticking_phases(const Scene &scene, int mass, int settling, int periods);

}  // namespace vibro_impact
