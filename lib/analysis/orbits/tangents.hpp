// What a TangentRecorder keeps: the changes, carried from event to event (tangent.cpp), and what
// becomes of them at events (saltation.cpp).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "change_flow.hpp"
#include "vibro_impact/analysis/tangent.hpp"

namespace vibro_impact {

using Row = Eigen::RowVectorXd;

struct TangentRecorder::Tangents {
  // An impact of a chatter: how the time of the limit changes as it predicts it, and the changes
  // just after it with the mass held from then on; where they are changes by parameters, with the
  // motion that they depend on.
  struct Node {
    Instant instant;
    Eigen::MatrixXd changes;
    Row time;
    PlainMotion motion;
  };

  // Consecutive impacts at one stop, each slower than the one before, nothing else in between.
  struct Sequence {
    std::size_t stop = 0;
    long long impacts = 0;
    std::vector<Node> nodes = {};
  };

  Scene scene;
  TangentOptions options;
  Clock clock;
  Instant started, now;
  Held held;  // up to the events of `group`
  Eigen::MatrixXd changes;
  PlainMotion motion;  // now; kept up for changes by parameters only
  // What changes by the start alone go by: the chain without forcing, and its contact modes; stops
  // shift the static positions, not the changes.
  Scene unforced;
  Modes<Eigen::Dynamic> modes = {};
  Counters counters = {};
  bool differentiable = true;
  double chatter_error = 0.0;
  std::vector<EventChange> told = {};
  // The events of one instant, gathered until a later one shows that they are all.
  std::vector<Event> group = {};
  MotionState at = {};  // after them; before: with
  std::vector<double> velocity_before = {};
  Sequence sequence = {};

  void event(const Event &event, const Moment &moment);
  void finish(const Instant &end);
  void hold(Eigen::MatrixXd &columns, const Held &mode) const;

 private:
  Eigen::Index masses() const {
    return changes.rows() / 2;
  }
  Eigen::Index parameters() const {
    return static_cast<Eigen::Index>(options.by.size());
  }
  Row ones(Parameter::Kind kind, std::size_t index) const;
  void carry_all(const Held &mode, const Instant &from, double tau, PlainMotion &with,
                 Eigen::MatrixXd &columns);
  void carry_to(const Instant &instant);
  Eigen::VectorXd vector_field(const Held &mode, const std::vector<double> &v) const;
  void tell(const Event &event, const Row &dt, const Row &speed);
  void close();
  void saltation(const std::vector<const Event *> &impacts, const Held &after);
  void releases();
  void extend_sequence(const Event &impact, const Row &dt);
  Row time_left(const Event &impact, const PlainMotion &at_rest, const Eigen::MatrixXd &moved,
                const Row &dt) const;
  void chatter_limit(const Held &after);
};

}  // namespace vibro_impact
