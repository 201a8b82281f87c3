#include "vibro_impact/analysis/settle.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <deque>
#include <stdexcept>
#include <utility>

#include "analysis/orbits/orbit_tolerances.hpp"
#include "event_counts.hpp"
#include "settled.hpp"
#include "vibro_impact/analysis/orbit_record.hpp"

namespace vibro_impact {

namespace {

// A return of a motion near to one of its latest sections.
struct NearReturn {
  int periods = 1;
  double distance = infinity, size = 0.0;  // lengths; the size is that of the motion
};

// The latest sections of a motion as lengths.
class Sections {
 public:
  Sections(const Scene &scene, const MotionState &start, int largest_period)
      : frequencies_(local_frequencies(scene)), most_(static_cast<std::size_t>(largest_period)) {
    past_ = {lengths(frequencies_, start)};
    sizes_ = {past_.front().stableNorm()};
  }

  // Adds a section, and the state half a period before it, which counts for the size alone. A
  // longer period counts as nearer only if it is nearer by a factor of three.
  NearReturn add(const MotionState &between, const MotionState &section) {
    Eigen::VectorXd now = lengths(frequencies_, section);
    sizes_.push_front(std::max(now.stableNorm(), lengths(frequencies_, between).stableNorm()));
    NearReturn nearest{.size = std::ranges::max(sizes_)};
    for (std::size_t p = 1; p <= past_.size() && nearest.distance > 0.0; ++p) {
      const double distance = (now - past_[p - 1]).stableNorm();
      if (!(distance < nearest.distance / 3.0)) continue;
      nearest.distance = distance;
      nearest.periods = static_cast<int>(p);
    }
    past_.push_front(std::move(now));
    if (past_.size() > most_) {
      past_.pop_back();
      sizes_.pop_back();
    }
    return nearest;
  }

 private:
  std::vector<double> frequencies_;
  std::size_t most_;
  std::deque<Eigen::VectorXd> past_ = {};  // the latest first
  std::deque<double> sizes_ = {};
};

// How an orbit attracts its guess. One that is `near` was brought nearer by one return. In the
// `linear` neighbourhood the derivative decides, so that every further return does the same. Of an
// orbit that is neutral or has no derivative, and at the orbit itself, it is `unknown`.
enum class Attraction { none, unknown, near, linear };

Attraction attraction_of_guess(const NewtonOrbit &orbit) {
  const Smooth<Multipliers> multipliers = multipliers_of(orbit);
  if (!orbit.found) return Attraction::none;
  if (!multipliers.exists()) return Attraction::unknown;
  const double largest = largest_modulus(*multipliers);
  if (!(largest < 1.0 - neutral_modulus))
    return largest > 1.0 + neutral_modulus ? Attraction::none : Attraction::unknown;
  const Eigen::VectorXd before = orbit.guess - orbit.z, after = orbit.image_of_guess - orbit.z;
  if ((after - *orbit.derivative * before).stableNorm() <=
      nonlinear_part * (1.0 - largest) * before.stableNorm())
    return Attraction::linear;
  return after.stableNorm() < before.stableNorm() ? Attraction::near : Attraction::unknown;
}

// The orbit over the least divisor of its periods after which it returns.
NewtonOrbit of_least_period(NewtonOrbit orbit) {
  const Motion &motion = orbit.motion;
  const std::vector<double> frequencies = local_frequencies(motion.scene);
  const Eigen::VectorXd start = lengths(frequencies, motion.start());
  for (int q = 1; q < motion.periods; ++q) {
    if (motion.periods % q != 0) continue;
    const Motion part = motion_of(motion.scene, motion.start(), q, motion.options);
    if ((lengths(frequencies, part.end()) - start).stableNorm() > same_orbit * orbit.size) continue;
    // Next to a graze the states of an orbit of longer period are as near to each other.
    NewtonOrbit shorter = newton(motion.scene, motion.start(), q, most_corrections, motion.options);
    if (shorter.found) return shorter;
  }
  return orbit;
}

bool same_events_with_nearer_stops(const Motion &motion, double shift) {
  Scene scene = motion.scene;
  for (Stop &stop : scene.stops) stop.position -= sign(stop.side) * shift;
  scene = with_start_inside(scene);
  try {
    const Motion nearer =
        motion_of(scene, start_near(scene, motion.start()), motion.periods, motion.options);
    return same_events(without_chatters(motion.scene, events_of(motion), true),
                       without_chatters(scene, events_of(nearer), true));
  } catch (const std::invalid_argument &) {  // both stops of a mass have met
    return false;
  }
}

// Whether the motion has settled on the orbit that was found from it.
bool attracts(const NewtonOrbit &orbit, const NearReturn &nearest, Attraction attraction) {
  if (attraction == Attraction::none) return false;
  const bool returns = nearest.distance <= settle_tolerance * nearest.size;
  if (!returns && attraction != Attraction::linear) return false;
  const double left = std::max((orbit.guess - orbit.z).stableNorm(), orbit.residuals.back());
  return left == 0.0 || same_events_with_nearer_stops(orbit.motion, graze_margin * left);
}

void settle_on(NewtonOrbit orbit, const Instant &section, Settled &settled) {
  const RunOptions options = orbit.motion.options;
  const Scene scene = orbit.motion.scene;
  SettledMotion &motion = settled.motion;
  motion.period = orbit.motion.periods;
  motion.approached = 0;
  motion.orbit = as_periodic_orbit(orbit);
  motion.counts = counts_of(scene, motion.orbit.events, motion.period, motion.orbit.state.held);
  motion.section = samples_of(
      motion_of(scene, motion.orbit.state, motion.period, options, {.phase = section.phase}));
  for (MotionState &state : motion.section) state.instant = {0, section.phase};
  motion.state = motion.section.back();
  settled.orbit = std::move(orbit);
}

// Takes the sections of one run, and a state half a period before each.
class SettlingRecorder : public Recorder {
 public:
  SettlingRecorder(const Scene &scene, const MotionState &start, const SettleOptions &options)
      : scene_(scene),
        options_(options),
        clock_(scene.omega),
        first_(start.instant),
        held_(start.held),
        sections_(scene, start, options.largest_period) {
    settled.motion.state = start;
  }
  void event(const Event &event, const Moment &) override {
    held_ = event.held;
  }
  double next_time() const override {
    if (done()) return infinity;
    const double section = time_of({first_.cycle + taken_ / 2 + 1, first_.phase}, clock_);
    return taken_ % 2 == 0 ? section - 0.5 * clock_.period : section;
  }
  void sample(const Moment &moment) override {
    MotionState state = state_at(moment, held_);
    if (taken_++ % 2 == 0)
      between_ = std::move(state);
    else
      look_at(std::move(state));
  }
  bool done() const override {
    return settled.motion.period > 0 || taken_ == 2 * static_cast<long long>(options_.longest);
  }

  Settled settled = {};

 private:
  const Scene &scene_;
  const SettleOptions &options_;
  Clock clock_;
  Instant first_;
  Held held_;
  Sections sections_;
  long long taken_ = 0;
  MotionState between_ = {};
  double tried_ = infinity;  // distance of the latest return from which an orbit was looked for

  void look_at(MotionState section) {
    SettledMotion &motion = settled.motion;
    const int n = ++motion.periods_run;
    motion.state = std::move(section);
    motion.state.instant = {0, first_.phase};
    const NearReturn nearest = sections_.add(between_, motion.state);
    const bool last_resort =
        n == options_.longest ||
        (n >= earliest_resort && std::has_single_bit(static_cast<unsigned>(n)));
    const double near = (last_resort ? far_return : near_return) * nearest.size;
    if (!(nearest.distance <= near) || !(nearest.distance <= nearer_return * tried_ || last_resort))
      return;
    tried_ = nearest.distance;
    const MotionState quiet = quiet_section(motion_of(scene_, motion.state, 1, options_.run));
    NewtonOrbit orbit = newton(scene_, quiet, nearest.periods, few_corrections, options_.run,
                               NewtonGuess::late_motion);
    const Attraction attraction = attraction_of_guess(orbit);
    const bool settles = attracts(orbit, nearest, attraction);
    const bool approaches = attraction == Attraction::near || attraction == Attraction::linear;
    if (settles || approaches) orbit = of_least_period(std::move(orbit));
    motion.approached = approaches ? orbit.motion.periods : 0;
    if (settles) settle_on(std::move(orbit), first_, settled);
  }
};

}  // namespace

Settled settled(const Scene &scene, const MotionState &start, const SettleOptions &options) {
  Simulation run(scene, start, options.run);
  SettlingRecorder recorder(scene, start, options);
  require_complete(run.advance(time_after(scene, start, options.longest + 1), recorder));
  return std::move(recorder.settled);
}

void check_settling(const Scene &scene, const MotionState &start, const SettleOptions &options) {
  check(scene);
  check(scene, start);
  require(options.longest >= 1 && options.longest <= most_periods_run,
          "longest = ", options.longest, ": must lie from 1 to ", most_periods_run);
  require(options.largest_period >= 1 && options.largest_period <= most_periods_of_orbit,
          "largest_period = ", options.largest_period, ": must lie from 1 to ",
          most_periods_of_orbit);
  time_after(scene, start, options.longest);
}

SettledMotion settle(const Scene &scene, const MotionState &start, const SettleOptions &options) {
  check_settling(scene, start, options);
  return settled(scene, start, options).motion;
}

SettledMotion settle(const Scene &scene, const SettleOptions &options) {
  return settle(scene, start_of(scene), options);
}

}  // namespace vibro_impact
