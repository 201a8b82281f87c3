#include "vibro_impact/analysis/settle.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "analysis/orbits/motion_state.hpp"
#include "analysis/orbits/orbit_tolerances.hpp"
#include "settled_runs.hpp"
#include "vibro_impact/analysis/periodic_orbit.hpp"

namespace vibro_impact {

namespace {

// The largest numbers of a sequence in its latest blocks. The numbers from 2^k to 2^(k+1) are one
// block: a long sequence forgets its beginning.
struct LargestByBlock {
  double latest = 0.0, before = 0.0, earlier = 0.0;

  void add(double value, int number) {
    if (std::has_single_bit(static_cast<unsigned>(number))) {
      earlier = std::exchange(before, latest);
      latest = 0.0;
    }
    latest = std::max(latest, value);
  }
};

// How the distances d_n of sections p periods apart fall, for one p. Infinite: not known yet.
struct Contraction {
  std::vector<double> distances;  // the latest p, by section modulo p
  std::vector<double> ratios;     // likewise of d_n / d_(n-p)
  int settled = 0;                // latest sections in a row with the estimate below the tolerance
  LargestByBlock largest_distance = {};
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
      : scene_(scene),
        options_(options),
        clock_(scene.omega),
        first_(start.instant),
        frequency_(local_frequencies(scene)) {
    held_ = start.held;
    for (std::size_t p = 1; p <= index(options.largest_period); ++p)
      contractions_.push_back({std::vector<double>(p, infinity), std::vector<double>(p, infinity)});
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
    for (int p = 1; p <= options_.largest_period && p < taken_; ++p) compare(p);
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
      motion.counts = counts_in(scene_, events, period_, motion.state.held);
      for (int k = period_; k-- > 0;) motion.section.push_back(latest(k).state);
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

  // Compares the latest section with that p periods before. Distances below `floor` count as zero.
  void compare(int p) {
    Contraction &contraction = contractions_[index(p - 1)];
    const double now = distance(0, p), floor = repeats * scale(),
                 before = std::exchange(contraction.distances[index(taken_ % p)], now);
    double &ratio = contraction.ratios[index(taken_ % p)];
    if (before > floor && before < infinity)
      ratio = now / before;
    else if (now > floor || before == infinity)
      ratio = infinity;
    else if (ratio == infinity)  // both distances are below the floor
      ratio = 0.0;
    // A single small ratio may be chance: the estimate is no less than a distance above the floor.
    const double least = now > floor ? 1.0 : 0.0;
    const bool below =
        ratio < 1.0 && now * std::max(ratio / (1.0 - ratio), least) <= settle_tolerance * scale();
    contraction.settled = below ? contraction.settled + 1 : 0;
    contraction.largest_distance.add(now, taken_);
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

  // Whether the last periods, `length` in number, consist of q periods again and again with the
  // same events. After the same sticks and releases the contact modes are the same, too.
  bool same_events(int q, int length) const {
    const auto same = [](const Event &a, const Event &b) {
      return a.kind == b.kind && a.stop == b.stop;
    };
    const std::vector<Event> last = without_chatters(scene_, events_of(q, 0));
    for (int back = q; back < length; back += q)
      if (!std::ranges::equal(last, without_chatters(scene_, events_of(q, back)), same))
        return false;
    return true;
  }

  void find_period() {
    const double tolerance = settle_tolerance * scale();
    for (int p = 1; p <= options_.largest_period && 2 * p < taken_; ++p) {
      if (contractions_[index(p - 1)].settled < p || !same_events(p, 2 * p)) continue;
      // A motion of period q, a divisor of p, has settled after p periods, too.
      for (int q = 1; q < p; ++q) {
        if (p % q != 0 || !same_events(q, p)) continue;
        double apart = 0.0;
        for (int k = 0; k < p; ++k) apart = std::max(apart, distance(k, k + q));
        if (apart <= same_section * tolerance) {
          period_ = q;
          return;
        }
        // The sections of one orbit are so near each other at a period doubling alone.
        if (apart <= not_decided * tolerance) return;
      }
      period_ = p;
      return;
    }
  }
};

}  // namespace

SettledMotion settle(const Scene &scene, const MotionState &start, const SettleOptions &options) {
  return settle(Simulation(scene, start, options.run), start, options);
}

SettledMotion settle(Simulation simulation, const MotionState &start,
                     const SettleOptions &options) {
  require(options.longest >= 1 && options.longest <= most_periods_run,
          "longest = ", options.longest, ": must lie from 1 to ", most_periods_run);
  require(options.largest_period >= 1 && options.largest_period <= most_periods_of_orbit,
          "largest_period = ", options.largest_period, ": must lie from 1 to ",
          most_periods_of_orbit);
  SettledMotion motion{.simulation = std::move(simulation)};
  const Scene &scene = motion.simulation.scene();
  const double until = time_after(scene, start, options.longest + 1);
  Sections sections(scene, start, options);
  require_complete(motion.simulation.advance(until, sections));
  sections.report_to(motion);
  return motion;
}

}  // namespace vibro_impact
