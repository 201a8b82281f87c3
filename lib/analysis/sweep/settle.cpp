#include "vibro_impact/analysis/settle.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "analysis/orbits/motion_state.hpp"
#include "analysis/orbits/orbit_tolerances.hpp"
#include "contraction.hpp"
#include "event_counts.hpp"
#include "vibro_impact/analysis/periodic_orbit.hpp"

namespace vibro_impact {

namespace {

// The state at a section, and the events of the period before it.
struct Section {
  MotionState state = {};
  std::vector<Event> events = {};
};

// A recorder that compares the sections.
class Sections : public Recorder {
 public:
  Sections(const Scene &scene, const MotionState &start, const SettleOptions &options)
      : scene_(scene),
        options_(options),
        clock_(scene.omega),
        first_(start.instant),
        frequency_(local_frequencies(scene)) {
    held_ = start.held;
    for (std::size_t p = 1; p <= index(options.largest_period); ++p) contractions_.emplace_back(p);
    sections_.resize(2 * contractions_.size() + 1);
    enter(start);
  }

  void event(const Event &event, const Moment &) override {
    held_ = event.held;
    events_.push_back(event);
  }

  double next_time() const override {
    return taken_ > options_.longest ? infinity : time_of(section_at(taken_), clock_);
  }

  void sample(const Moment &moment) override {
    MotionState at = state_at(moment, held_);
    bring_to_section(at);
    at.instant = section_at(taken_);
    enter(std::move(at));
    amplitude_.add(amplitude(frequency_, latest(0).state), taken_);
    for (int p = 1; p <= options_.largest_period && p < taken_; ++p)
      contractions_[index(p - 1)].add(distance(0, p), taken_, scale());
    find_period();
  }

  bool done() const override {
    return period_ > 0 || taken_ > options_.longest;
  }

  void report_to(SettledMotion &motion) const {
    motion.period = period_;
    motion.periods_run = taken_ - 1;
    motion.state = latest(0).state;
    const int counted = period_ > 0 ? period_ : std::min(2 * options_.largest_period, taken_ - 1);
    const std::vector<Event> events = events_of(counted, 0);
    for (const Event &event : events)
      motion.fastest_impact = std::max(motion.fastest_impact, std::abs(event.velocity_before));
    if (period_ > 0) {
      motion.counts = counts_of(scene_, events, period_, motion.state.held);
      for (int k = period_; k-- > 0;) motion.section.push_back(latest(k).state);
      return;
    }
    if (undecided_ > 0 && taken_ <= looked_ + undecided_) {
      motion.approached = undecided_;
      return;
    }
    const auto approached = std::ranges::find_if(contractions_, [](const Contraction &c) {
      const auto &[latest, before, earlier] = c.largest_distance;
      return before < approaching * earlier;
    });
    if (approached != contractions_.end())
      motion.approached = static_cast<int>(approached - contractions_.begin()) + 1;
  }

 private:
  const Scene &scene_;
  const SettleOptions &options_;
  Clock clock_;
  Instant first_;
  int taken_ = 0;  // sections entered, that of the start included
  int period_ = 0;
  int undecided_ = 0;  // a period that was not accepted next to a graze,
  int looked_ = 0;     // ... and the sections entered then
  Held held_;
  std::vector<double> frequency_;       // of each mass
  LargestByBlock amplitude_ = {};       // at the sections
  std::vector<Event> events_ = {};      // since the latest section
  std::vector<Section> sections_ = {};  // the latest, by number modulo their size
  std::vector<Contraction> contractions_ = {};

  static std::size_t index(int k) {
    return static_cast<std::size_t>(k);
  }
  Instant section_at(int k) const {
    return {first_.cycle + k, first_.phase};
  }
  // The section `back` periods ago.
  const Section &latest(int back) const {
    return sections_[index(taken_ - 1 - back) % sections_.size()];
  }

  void enter(MotionState state) {
    Section &section = sections_[index(taken_++) % sections_.size()];
    section.state = std::move(state);
    std::swap(section.events, events_);
    events_.clear();
  }

  // Moves a sample along the motion to its section. A sample is taken at a time, and the rounding
  // of a long time puts it off the section.
  void bring_to_section(MotionState &at) const {
    const double tau = elapsed(at.instant, section_at(taken_), clock_);
    if (tau == 0.0) return;
    const std::vector<double> a = acceleration_of(scene_, at);
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (held_[i] != 0) continue;
      at.displacement[i] += tau * at.velocity[i];
      at.velocity[i] += tau * a[i];
    }
  }

  // The unit of length of the tolerances: the amplitude of the motion at its latest sections.
  double scale() const {
    return std::max(amplitude_.latest, amplitude_.before);
  }

  // The distance of the sections some periods ago.
  double distance(int back, int further_back) const {
    return amplitude(frequency_, latest(back).state, latest(further_back).state);
  }

  // The events of the p periods that ended `back` periods ago.
  std::vector<Event> events_of(int p, int back) const {
    std::vector<Event> events;
    for (int k = p; k-- > 0;) {
      const std::vector<Event> &of = latest(back + k).events;
      events.insert(events.end(), of.begin(), of.end());
    }
    return events;
  }

  // Whether the last p periods consist of q periods again and again with the same events.
  bool same_events(int q, int p) const {
    const std::vector<Event> last = without_chatters(scene_, events_of(q, 0));
    for (int back = q; back < p; back += q)
      if (!std::ranges::equal(last, without_chatters(scene_, events_of(q, back)), same_kind))
        return false;
    return true;
  }

  void find_period() {
    if (undecided_ > 0 && taken_ < looked_ + undecided_) return;
    const double tolerance = settle_tolerance * scale();
    for (int p = 1; p <= options_.largest_period && 2 * p < taken_; ++p) {
      const Contraction &contraction = contractions_[index(p - 1)];
      if (contraction.settled < p) continue;
      const double to_come = contraction.still_to_come(scale());
      // A motion of period q, a divisor of p, has settled after p periods, too.
      for (int q = 1; q < p; ++q) {
        if (p % q != 0 || !same_events(q, p)) continue;
        double apart = 0.0;
        for (int k = 0; k < p; ++k) apart = std::max(apart, distance(k, k + q));
        if (apart <= same_section * tolerance)
          return accept_away_from_a_graze(q, std::max(apart, to_come));
        // The sections of one orbit are so near each other at a period doubling alone.
        if (apart <= not_decided * tolerance) return;
      }
      return accept_away_from_a_graze(p, to_come);
    }
  }

  // The events of some periods, stop by stop, without complete chatters and without events at a
  // section, which may lie in the period before. Impacts of several masses at one instant commute.
  std::vector<Event> inside(const std::vector<Event> &events) const {
    std::vector<Event> kept = without_chatters(scene_, events);
    std::erase_if(kept, [this](const Event &event) {
      const double part =
          elapsed(Instant{event.instant.cycle, first_.phase}, event.instant, clock_) /
          clock_.period;
      return std::abs(part - std::round(part)) < at_section;
    });
    std::ranges::stable_sort(kept, {}, &Event::stop);
    return kept;
  }

  // Accepts a period, unless what is still to come may bring another event, as next to a graze: the
  // last periods must have the same events with every stop nearer by some times this length.
  void accept_away_from_a_graze(int period, double length) {
    if (length == 0.0 || scene_.stops.empty() ||
        same_events_with_nearer_stops(period, graze_margin * length)) {
      period_ = period;
    } else {
      undecided_ = period;
      looked_ = taken_;
    }
  }

  bool same_events_with_nearer_stops(int period, double shift) const {
    Scene scene = scene_;
    MotionState start = latest(period).state;
    for (Stop &stop : scene.stops) stop.position -= sign(stop.side) * shift;
    move_inside(scene, start.displacement);   // a mass that is held, too
    scene.displacement = start.displacement;  // the scene's own start may lie beyond a stop
    try {
      EventRecorder nearer(-infinity);
      stroboscopic_map(scene, start, period, options_.run, nearer);
      return std::ranges::equal(inside(events_of(period, 0)), inside(nearer.events), same_kind);
    } catch (const std::invalid_argument &) {  // both stops of a mass have met
      return false;
    }
  }
};

}  // namespace

SettledMotion settle(const Scene &scene, const MotionState &start, const SettleOptions &options) {
  SettledMotion motion{.simulation = Simulation(scene, start, options.run)};
  require(options.longest >= 1 && options.longest <= most_periods_run,
          "longest = ", options.longest, ": must lie from 1 to ", most_periods_run);
  require(options.largest_period >= 1 && options.largest_period <= most_periods_of_orbit,
          "largest_period = ", options.largest_period, ": must lie from 1 to ",
          most_periods_of_orbit);
  const double until = time_after(scene, start, options.longest + 1);
  Sections sections(scene, start, options);
  require_complete(motion.simulation.advance(until, sections));
  sections.report_to(motion);
  return motion;
}

}  // namespace vibro_impact
