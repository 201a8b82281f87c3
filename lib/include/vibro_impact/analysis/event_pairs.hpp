/// \file
/// Pairs of events on two masses (Table I and Section 3.3 of the paper): dual grazing, dual
/// sticking, double impact, grazing-sticking, grazing-impact, sticking-impact.
///
/// A mass sticks over an interval, from its stick to its release; it grazes or impacts at an
/// instant. Two contacts pair when their times agree, a contact and a sticking phase when the phase
/// contains the contact, two sticking phases when they overlap.
///
/// The paper asks whether an impact of one mass while the other sticks is a double impact, since
/// the other mass is in contact with its stop too. It is not: the sticking mass has no impact at
/// that instant. That infinitely many impacts led to its sticking phase does not change this. Such
/// an impact is a sticking-impact. Where both readings apply, within the tolerance of the end of a
/// chatter, sticking takes precedence.
#pragma once

#include <array>
#include <compare>
#include <optional>
#include <vector>

#include "vibro_impact/record.hpp"
#include "vibro_impact/scene.hpp"

namespace vibro_impact {

/// The six entries of Table I, in its order.
enum class EventPair {
  dual_grazing,
  dual_sticking,
  double_impact,
  grazing_sticking,
  grazing_impact,
  sticking_impact
};

constexpr std::array<EventPair, 6> all_event_pairs{
    EventPair::dual_grazing,     EventPair::dual_sticking,  EventPair::double_impact,
    EventPair::grazing_sticking, EventPair::grazing_impact, EventPair::sticking_impact};

/// The paper's abbreviation: DG, DS, DI, GS, GI, SI.
const char *abbreviation(EventPair kind);

/// An event and the force that presses its mass into the stop (pressing_force.hpp) right after it.
/// The scales are those of tolerances: the sum of the moduli of the forces on the mass, the speed
/// that such a force gives it while its own vibration turns by a radian, and the time in which the
/// slowest mass between resting neighbours turns by a radian. All events of a run have one time
/// scale.
struct PressedEvent {
  Event event;
  double press = 0.0;
  double force_scale = 1.0, speed_scale = 1.0, time_scale = 1.0;
};

/// Every event from time `from` on, with the pressing force of each contact. A run refuses the
/// recorder if its scene has another number of masses or stops.
struct PressedEventRecorder : Recorder {
  Scene scene;
  double from;
  std::vector<PressedEvent> events = {};
  std::vector<double> frequencies = {};  ///< of each mass between resting neighbours, once known

  explicit PressedEventRecorder(const Scene &of, double from_time = 0.0)
      : scene(of), from(from_time) {
  }
  void check(const Scene &of_run) const override;
  void event(const Event &event, const Moment &moment) override;
};

/// One pair. In a mixed pair `mass` (from 1) has the event named first and `other` the second (GS:
/// `mass` grazes, `other` sticks). In a pair of two events of one kind `mass` < `other`. `from` and
/// `to` are the bounds of the common sticking phase (DS), the time of the contact (GS, SI) or the
/// two times of contact in order (DG, DI, GI). A bound that the record does not contain is
/// infinite.
struct PairedEvents {
  double from = 0.0, to = 0.0;
  EventPair kind = EventPair::double_impact;
  int mass = 1, other = 2;
  friend auto operator<=>(const PairedEvents &, const PairedEvents &) = default;
};

/// The pairs among `events`, for every two masses of the chain, in order of time. The events must
/// be in order of time, as a run reports them. `start` is the contact mode before the first of
/// them, if it is known: masses that stay held have no event. Events at most 1e-6 apart are
/// simultaneous. A contact is grazing if its speed is at most 1e-6 and the mass is pulled off its
/// stop by more than 1e-9. All three are relative to the scales of the event.
std::vector<PairedEvents> event_pairs(const std::vector<PressedEvent> &events,
                                      const std::optional<Held> &start = {});

}  // namespace vibro_impact
