/// \file
/// The response of a chain: how far each mass moves.
#pragma once

#include <vector>

#include "vibro_impact/simulate.hpp"

namespace vibro_impact {

/// The displacement x of a mass over a time: its extremes, and the root of the mean of x^2.
struct Response {
  double lowest = 0.0, highest = 0.0, rms = 0.0;
};

/// Records the response of each mass from time `from` to time `to` of a run of this scene. The
/// motion is sampled 128 times in the shortest of the forcing period and the local periods of the
/// masses, and is a cubic between samples and impacts: x is right to 3e-8 of its amplitude, unless
/// a stiff link has a frequency 32 times that of the forcing.
struct ResponseRecorder : Recorder {
  double from, to;

  ResponseRecorder(const Scene &scene, double from_time, double to_time);
  double next_time() const override;
  void sample(const Moment &moment) override;
  void event(const Event &event, const Moment &moment) override;
  std::vector<Response> responses() const;  ///< of each mass up to the latest sample

 private:
  struct Node {  ///< of the curve x(t)
    double time, x, v;
  };
  Scene scene_;
  double interval_, latest_sample_;
  std::vector<Node> latest_ = {};    ///< of each mass; empty before `from`
  std::vector<Response> sums_ = {};  ///< with the integral of x^2 in the place of `rms`

  void add(int mass, const Node &node);
};

/// The response of each mass over so many forcing periods from a state, by a ResponseRecorder.
/// Throws as `stroboscopic_map` does.
std::vector<Response> response_of(const Scene &scene, const MotionState &start, int periods,
                                  const RunOptions &options = {});

}  // namespace vibro_impact
