// When a chatter is complete, with the flights that the generator leaves out.
#pragma once

#include "event_driven.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <stdexcept>

namespace vibro_impact_reference {

/// Looks for the first stick at a stop after `from`, in a run it observes. After the impact the
/// generator calls a stick the mass has the speed v and is pressed by a; the flights left out last
/// 2 v / a (1 + r + r^2 + ...), up to the relative change of a over them, which is as small as they
/// are.
struct Completion {
  const Scene &scene;
  std::size_t stop;
  Real from;
  bool was_free = false;
  std::optional<Real> begins = {}, acceleration = {};

  void observe(const Flow &flow) {
    const std::size_t mass = scene.stops[stop].mass;
    const bool free = std::find(flow.free.begin(), flow.free.end(), mass) != flow.free.end();
    if (!begins && was_free && !free && flow.start_time >= from) {
      begins = flow.start_time;
      const Motion motion = motion_at(flow, Real(0));
      acceleration =
          pressing_signal(scene.chain, scene.stops[stop], motion).value / scene.chain.masses[mass];
    }
    was_free = free;
  }

  Real of(const Event &stick) const {
    if (!begins || *begins != stick.time) throw std::logic_error("Completion: another stick");
    return stick.time + 2 * abs(stick.velocity_before) / (*acceleration * (1 - scene.restitution));
  }
};

}  // namespace vibro_impact_reference
