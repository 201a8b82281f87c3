// A picture of a run, drawn by gnuplot: the displacement of each mass over time, its stops, impacts
// and the phases in which it sticks. How it looks stands in plot.gp, which is installed.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "output.hpp"
#include "vibro_impact/record.hpp"

namespace vibro_impact::runner {

// A recorder of what the picture shows.
class Plot {
 public:
  // From `from` to `to`. Throws std::invalid_argument when there are more periods than can be
  // drawn, and when gnuplot is not there or does not draw this kind of file.
  Plot(const std::string &path, const Scene &scene, double from, double to);

  double next_time() const {
    return sample_time(from_, to_, every_, taken_);
  }
  void sample(const Moment &moment);
  void event(const Event &event, const Moment &moment);

  // Has gnuplot draw the run, which came to its end at `time`. Throws std::runtime_error.
  void draw(double time);

 private:
  std::string path_, terminal_;
  Output file_;
  const Scene &scene_;
  double from_, to_, every_ = 0.0;
  std::size_t taken_ = 0;
  bool sticks_ = false;
  std::vector<int> masses_ = {};         // drawn
  std::vector<double> last_impact_;      // per stop
  std::string displacements_, impacts_;  // rows for gnuplot
};

}  // namespace vibro_impact::runner
