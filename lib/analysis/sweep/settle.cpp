#include "vibro_impact/analysis/settle.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/orbits/motion_state.hpp"
#include "analysis/orbits/orbit_tolerances.hpp"
#include "settled_runs.hpp"
#include "vibro_impact/analysis/periodic_orbit.hpp"

namespace vibro_impact {

namespace {

bool rebounds(const Scene &scene, const Event &event) {
  return law_of(scene, stop_of(scene, event)).at_rest() > 0.0;
}

bool dual_sticking(const Held &held) {
  return std::count_if(held.begin(), held.end(), [](signed char h) { return h != 0; }) > 1;
}

// Leaves out the impacts of complete chatters: those before a stick at the same stop, each slower
// than the one before. The events repeat, so that a chatter under way at their end goes on at their
// beginning.
std::vector<Event> without_chatters(const Scene &scene, const std::vector<Event> &events) {
  std::vector<Event> twice = events;
  twice.insert(twice.end(), events.begin(), events.end());
  std::vector<bool> left_out(twice.size(), false);
  for (std::size_t k = 0; k < twice.size(); ++k) {
    const Event &stick = twice[k];
    if (stick.kind != EventKind::stick || !rebounds(scene, stick)) continue;
    for (std::size_t j = k; j-- > 0;) {
      const Event &before = twice[j];
      if (before.mass != stick.mass) continue;
      if (changes_contact_mode(before.kind) || before.stop != stick.stop) break;
      left_out[j] = true;
      if (before.falling == 0) break;
    }
  }
  std::vector<Event> kept;
  for (std::size_t k = 0; k < events.size(); ++k)
    if (!left_out[k]) kept.push_back(events[k]);
  return kept;
}

// How the distances d_n of sections p periods apart fall, for one p. Infinite: not known yet.
struct Contraction {
  std::vector<double> ratios;  // the latest p of d_n / d_(n-p), by section modulo p
  double to_come = infinity;   // the estimate of settle.hpp
};

// The state at a section, and the events of the period before it.
struct Section {
  MotionState state = {};
  std::vector<Event> events = {};
};

// A recorder that compares the sections.
class Sections : public Recorder {
 public:
  Sections(const Scene &scene, const MotionState &start, const SettleOptions &options)
      : scene_(scene), options_(options), clock_(scene.omega), first_(start.instant) {
    held_ = start.held;
    rest_.displacement = rest_.velocity = std::vector<double>(scene.mass.size(), 0.0);
    for (std::size_t p = 1; p <= most_periods_of_orbit; ++p)
      contractions_.push_back({std::vector<double>(p, infinity)});
    sections_.resize(2 * most_periods_of_orbit + 1);
    for (std::size_t i = 0; i < scene.mass.size(); ++i) {
      const double right = i + 1 < scene.mass.size() ? scene.stiffness[i + 1] : 0.0,
                   ground = entry_of(scene.ground, i),
                   squared = (scene.stiffness[i] + right + ground) / scene.mass[i];
      frequency_.push_back(squared > 0.0 ? std::sqrt(squared) : 1.0);  // a ball on no spring
    }
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
    const double scale = amplitude(latest(0).state, rest_);
    for (int p = 1; p <= most_periods_of_orbit && p < taken_; ++p) compare(p, repeats * scale);
    find_period();
  }

  bool done() const override {
    return period_ > 0 || taken_ > options_.longest;
  }

  void report_to(SettledMotion &motion) const {
    motion.period = period_;
    motion.periods_run = taken_ - 1;
    motion.state = latest(0).state;
    if (period_ > 0)
      motion.counts = counts_in(scene_, events_of(period_, 0), period_, motion.state.held);
  }

 private:
  const Scene &scene_;
  const SettleOptions &options_;
  Clock clock_;
  Instant first_;
  int taken_ = 0;  // sections entered, that of the start included
  int period_ = 0;
  Held held_;
  MotionState rest_;                    // all coordinates zero
  std::vector<double> frequency_ = {};  // of each mass between neighbours that stand still
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

  // The amplitude of the vibration of which the difference of two states is one phase: that of the
  // mass with the largest, in displacement or velocity, whichever is larger.
  double amplitude(const MotionState &a, const MotionState &b) const {
    double largest = 0.0;
    for (std::size_t i = 0; i < frequency_.size(); ++i) {
      const double w = frequency_[i], x = a.displacement[i] - b.displacement[i],
                   v = a.velocity[i] - b.velocity[i];
      largest = std::max(largest, std::max(1.0, 1.0 / w) * std::hypot(w * x, v));
    }
    return largest;
  }

  // The distance of the sections some periods ago.
  double distance(int back, int further_back) const {
    return amplitude(latest(back).state, latest(further_back).state);
  }

  // Compares the latest section with that p periods before. Distances below `floor` count
  // as zero.
  void compare(int p, double floor) {
    Contraction &contraction = contractions_[index(p - 1)];
    const double now = distance(0, p), before = 2 * p < taken_ ? distance(p, 2 * p) : infinity;
    double &ratio = contraction.ratios[index(taken_ % p)];
    if (before > floor && before < infinity)
      ratio = now / before;
    else if (now > floor || before == infinity)
      ratio = infinity;
    else if (ratio == infinity)  // both distances are below the floor
      ratio = 0.0;
    // A single small ratio may be chance: the estimate is no less than a distance above the floor.
    const double least = now > floor ? 1.0 : 0.0;
    contraction.to_come = ratio < 1.0 ? now * std::max(ratio / (1.0 - ratio), least) : infinity;
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

  // Whether the last p periods had the events of the p before. After the same sticks and releases
  // the contact modes are the same, too.
  bool same_events(int p) const {
    const auto same = [](const Event &a, const Event &b) {
      return a.kind == b.kind && a.stop == b.stop;
    };
    return std::ranges::equal(without_chatters(scene_, events_of(p, 0)),
                              without_chatters(scene_, events_of(p, p)), same);
  }

  void find_period() {
    for (int p = 1; p <= most_periods_of_orbit && 2 * p < taken_; ++p) {
      if (!(contractions_[index(p - 1)].to_come <= settle_tolerance) || !same_events(p)) continue;
      // A motion of period q, a divisor of p, has settled after p periods, too.
      for (int q = 1; q < p; ++q) {
        if (p % q != 0) continue;
        const double apart = distance(0, q);
        if (apart <= same_section * settle_tolerance && same_events(q)) {
          period_ = q;
          return;
        }
        // The sections of one orbit are so near each other at a period doubling alone.
        if (apart <= not_decided * settle_tolerance) return;
      }
      period_ = p;
      return;
    }
  }
};

void require_fits(const Scene &scene, const Event &event) {
  require_mass(event.mass, scene.masses());
  require(event.stop >= 1 && static_cast<std::size_t>(event.stop) <= scene.stops.size(), "stop ",
          event.stop, ": the scene has ", scene.stops.size());
}

}  // namespace

EventCounts counts_of(const Scene &scene, const std::vector<Event> &events, int periods,
                      const Held &held) {
  check(scene);
  return counts_in(scene, events, periods, held);
}

EventCounts counts_in(const Scene &scene, const std::vector<Event> &events, int periods,
                      const Held &held) {
  require(periods >= 1, "periods = ", periods, ": must be positive");
  require_held(scene, held);
  for (const Event &event : events) require_fits(scene, event);
  const std::vector<int> none(scene.mass.size(), 0);
  EventCounts counts{periods, none, none, dual_sticking(held)};
  for (const Event &event : without_chatters(scene, events)) {
    const auto mass = static_cast<std::size_t>(event.mass - 1);
    switch (event.kind) {
      case EventKind::impact:
        ++counts.impacts[mass];
        break;
      case EventKind::stick:
        ++counts.sticks[mass];
        break;
      case EventKind::release:
        break;
    }
    counts.dual_sticking = counts.dual_sticking || dual_sticking(event.held);
  }
  return counts;
}

SettledMotion settle(const Scene &scene, const MotionState &start, const SettleOptions &options) {
  return settle(Simulation(scene, start, options.run), start, options);
}

SettledMotion settle(Simulation simulation, const MotionState &start,
                     const SettleOptions &options) {
  require(options.longest >= 1 && options.longest <= most_periods_run,
          "longest = ", options.longest, ": must lie from 1 to ", most_periods_run);
  SettledMotion motion{.simulation = std::move(simulation)};
  const Scene &scene = motion.simulation.scene();
  const double until = time_after(scene, start, options.longest + 1);
  Sections sections(scene, start, options);
  require_complete(motion.simulation.advance(until, sections));
  sections.report_to(motion);
  return motion;
}

}  // namespace vibro_impact
