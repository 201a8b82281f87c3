#include "vibro_impact/analysis/lyapunov.hpp"

#include <cmath>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "analysis/orbits/motion_state.hpp"
#include "analysis/orbits/tolerances.hpp"
#include "vibro_impact/analysis/periodic_orbit.hpp"
#include "vibro_impact/analysis/tangent.hpp"

namespace vibro_impact {

namespace {

// Whether the sign of a mean growth is no chance.
bool is_certain(const std::vector<double> &blocks) {
  if (blocks.size() < least_blocks) return false;
  const auto count = static_cast<double>(blocks.size());
  const double mean = std::accumulate(blocks.begin(), blocks.end(), 0.0) / count;
  double squares = 0.0;
  for (const double growth : blocks) squares += (growth - mean) * (growth - mean);
  return std::isinf(mean) ||
         std::abs(mean) > least_ratio * std::sqrt(squares / ((count - 1.0) * count));
}

double length_of(const Matrix &column) {
  double largest = 0.0, sum = 0.0;
  for (const double value : column.values) largest = std::max(largest, std::abs(value));
  if (largest == 0.0) return 0.0;
  for (const double value : column.values) sum += (value / largest) * (value / largest);
  return largest * std::sqrt(sum);
}

class GrowthRecorder {
 public:
  GrowthRecorder(const Scene &scene, const MotionState &start)
      : scene_(scene),
        clock_(scene.omega),
        started_(start.instant),
        next_{start.instant.cycle + rescaled_after, start.instant.phase},
        held_(start.held),
        block_begin_(start.instant) {
    // A change in all directions that the masses are free to go.
    const std::size_t n = scene.mass.size();
    Matrix column(2 * n, 1);
    for (std::size_t i = 0; i < 2 * n && i % n < held_.size(); ++i)
      column(i, 0) = held_[i % n] == 0 ? 1.0 : 0.0;
    follow(start, std::move(column));
    logarithm_ = 0.0;
  }

  void event(const Event &event, const Moment &moment) {
    held_ = event.held;
    in_chatter_ = event.kind == EventKind::impact && event.falling > 0;
    tangents_->event(event, moment);
  }

  double next_time() const {
    return time_of(next_, clock_);
  }

  void sample(const Moment &moment) {
    if (in_chatter_) {  // as a section may be in every period: at another phase
      next_ = later(next_, clock_.period / 32.0, clock_);
      return;
    }
    next_.cycle += rescaled_after;
    const MotionState at = state_at(moment, held_);
    follow(at, tangents_->finish(at.instant).tangents);
    if (at.instant.cycle - block_begin_.cycle >= block_length) end_block(at.instant);
  }

  bool done() const {
    return sign_is_certain_;
  }

  Growth finish(const Instant &end) {
    logarithm_ += std::log(length_of(tangents_->finish(end).tangents));
    return {logarithm_ / elapsed(started_, end, clock_), sign_is_certain_,
            end.cycle - started_.cycle};
  }

 private:
  const Scene &scene_;
  Clock clock_;
  Instant started_, next_;
  Held held_;
  bool in_chatter_ = false;  // tangents of a chatter are extrapolated from all of its impacts
  double logarithm_ = 0.0;
  std::optional<TangentRecorder> tangents_ = {};
  Instant block_begin_;
  double before_block_ = 0.0;        // the logarithm there
  std::vector<double> blocks_ = {};  // growth per forcing period of each
  bool sign_is_certain_ = false;

  // Enters the length of the column in the sum, and goes on with length 1.
  void follow(const MotionState &from, Matrix column) {
    const double length = length_of(column);
    logarithm_ += std::log(length);
    if (length > 0.0)
      for (double &value : column.values) value /= length;
    tangents_.emplace(scene_, from, column);
  }

  void end_block(const Instant &now) {
    const double periods = elapsed(block_begin_, now, clock_) / clock_.period;
    blocks_.push_back((logarithm_ - before_block_) / periods);
    block_begin_ = now;
    before_block_ = logarithm_;
    sign_is_certain_ = is_certain(blocks_);
  }
};

}  // namespace

Growth mean_growth(const Scene &scene, const MotionState &start, int longest,
                   const RunOptions &options) {
  const double until = time_after(scene, start, longest);
  GrowthRecorder growth(scene, start);
  const Outcome end = simulate_from(scene, start, until, options, growth);
  return growth.finish(require_complete(end).state.instant);
}

}  // namespace vibro_impact
