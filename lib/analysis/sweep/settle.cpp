#include "vibro_impact/analysis/settle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/orbits/motion_state.hpp"
#include "analysis/orbits/tolerances.hpp"
#include "event_counts.hpp"
#include "vibro_impact/analysis/periodic_orbit.hpp"
#include "vibro_impact/analysis/pressing_force.hpp"

namespace vibro_impact {

namespace {

constexpr int largest_period = 10'000;  // the states of so many periods are kept

constexpr double infinity = std::numeric_limits<double>::infinity();

// The distances d_n of sections p periods apart, for one p. Infinite: not known yet.
struct Contraction {
  std::vector<double> distances = {};  // the latest p, by section modulo p
  std::vector<double> ratios = {};     // the latest d_n / d_(n-p), likewise
  double to_come = infinity;           // the estimate of settle.hpp

  explicit Contraction(std::size_t p) : distances(p, infinity), ratios(p, infinity) {
  }
  // Distances below `floor` cannot be told from zero.
  void add(std::size_t section, double distance, double floor) {
    double &before = distances[section % distances.size()];
    double &ratio = ratios[section % distances.size()];
    if (before > floor && before < infinity)
      ratio = distance / before;
    else if (distance > floor || before == infinity)
      ratio = infinity;
    else if (ratio == infinity)  // both distances are below the floor
      ratio = 0.0;
    // A single small ratio may be chance: the estimate is no less than a distance above the floor.
    const double least = distance > floor ? 1.0 : 0.0;
    to_come = ratio < 1.0 ? distance * std::max(ratio / (1.0 - ratio), least) : infinity;
    before = distance;
  }
};

// The state at a section, and the events of the period before it.
struct Section {
  std::vector<double> z = {};  // displacements, velocities
  Held held = {};
  std::vector<Event> events = {};
};

// A recorder that compares the sections.
class Sections {
 public:
  Sections(const Scene &scene, const MotionState &start, const SettleOptions &options)
      : scene_(scene), options_(options), clock_(scene.omega), first_(start.instant) {
    held_ = start.held;
    rest_.assign(2 * scene.mass.size(), 0.0);
    for (int p = 1; p <= options.most; ++p) contractions_.emplace_back(static_cast<std::size_t>(p));
    sections_.resize(2 * static_cast<std::size_t>(options.most) + 1);
    for (std::size_t i = 0; i < scene.mass.size(); ++i) {
      const double right = i + 1 < scene.mass.size() ? scene.stiffness[i + 1] : 0.0,
                   squared = (scene.stiffness[i] + right) / scene.mass[i];
      frequency_.push_back(squared > 0.0 ? std::sqrt(squared) : 1.0);  // a ball on no spring
    }
    enter(coordinates(start));
  }

  void event(const Event &event, const Moment &) {
    held_ = event.held;
    events_.push_back(event);
  }

  double next_time() const {
    return taken_ > options_.longest ? infinity : time_of(section_at(taken_), clock_);
  }

  void sample(const Moment &moment) {
    MotionState at = state_at(moment, held_);
    bring_to_section(at);
    enter(coordinates(at));
    const double scale = amplitude(latest(0).z, rest_);
    for (int p = 1; p <= options_.most && p < taken_; ++p)
      contractions_[index(p - 1)].add(index(taken_), distance(p), repeats * scale);
    judge();
  }

  bool done() const {
    return period_ > 0 || taken_ > options_.longest;
  }

  void tell(SettledMotion &motion) const {
    const std::size_t n = scene_.mass.size();
    const Section &now = latest(0);
    motion.period = period_;
    motion.periods_run = taken_ - 1;
    const auto middle = now.z.begin() + static_cast<std::ptrdiff_t>(n);
    motion.state = {
        section_at(taken_ - 1), {now.z.begin(), middle}, {middle, now.z.end()}, now.held};
    if (period_ > 0) motion.counts = counts_of(scene_, events_of(period_, 0), period_, now.held);
  }

 private:
  const Scene &scene_;
  const SettleOptions &options_;
  Clock clock_;
  Instant first_;
  int taken_ = 0;  // sections entered, that of the start included
  int period_ = 0;
  Held held_;
  std::vector<double> rest_;            // all coordinates zero
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

  void enter(std::vector<double> z) {
    Section &section = sections_[index(taken_++) % sections_.size()];
    section.z = std::move(z);
    section.held = held_;
    std::swap(section.events, events_);
    events_.clear();
  }

  // Moves a sample along the motion to its section. A sample is taken at a time, and the rounding
  // of a long time puts it beside the section.
  void bring_to_section(MotionState &at) const {
    const double tau = elapsed(at.instant, section_at(taken_), clock_);
    if (tau == 0.0) return;
    const std::vector<double> a = acceleration(scene_, at);
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (held_[i] != 0) continue;
      at.displacement[i] += tau * at.velocity[i];
      at.velocity[i] += tau * a[i];
    }
  }

  // The amplitude of the vibration of which the difference of two states is one phase: that of the
  // mass with the largest, in displacement or velocity, whichever is larger.
  double amplitude(const std::vector<double> &a, const std::vector<double> &b) const {
    const std::size_t n = frequency_.size();
    double largest = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      const double w = frequency_[i], x = a[i] - b[i], v = a[n + i] - b[n + i];
      largest = std::max(largest, std::max(1.0, 1.0 / w) * std::hypot(w * x, v));
    }
    return largest;
  }

  // The distance of the latest section and that p periods before.
  double distance(int p) const {
    return amplitude(latest(0).z, latest(p).z);
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

  void judge() {
    for (int p = 1; p <= options_.most && 2 * p < taken_; ++p) {
      if (!(contractions_[index(p - 1)].to_come <= options_.tolerance) || !same_events(p)) continue;
      // A motion of period q, a divisor of p, has settled after p periods, too.
      for (int q = 1; q < p; ++q) {
        if (p % q != 0) continue;
        const double apart = distance(q);
        if (apart <= same_section * options_.tolerance && same_events(q)) {
          period_ = q;
          return;
        }
        // The sections of one orbit are so near each other at a period doubling alone.
        if (apart <= not_decided * options_.tolerance) return;
      }
      period_ = p;
      return;
    }
  }
};

}  // namespace

SettledMotion settle(const Scene &scene, const MotionState &start, const SettleOptions &options) {
  require(options.longest >= 1 && options.longest <= most_periods_run,
          "longest = ", options.longest, ": must lie from 1 to ", most_periods_run);
  require(options.most >= 1 && options.most <= largest_period, "most = ", options.most,
          ": must lie from 1 to ", largest_period);
  require(options.tolerance > 0.0, "tolerance = ", options.tolerance, ": must be positive");
  require(std::abs(static_cast<double>(start.instant.cycle)) <= 0x1p53, "a start in period ",
          start.instant.cycle, ": beyond what can be counted");
  check(scene);
  const double until = time_after(scene, start, options.longest + 1);
  Sections sections(scene, start, options);
  Simulation simulation(scene, start, options.run);
  const Outcome end = require_complete(simulation.advance(until, sections));
  SettledMotion motion;
  sections.tell(motion);
  motion.simulation = std::move(simulation);
  motion.counters = end.counters;
  return motion;
}

}  // namespace vibro_impact
