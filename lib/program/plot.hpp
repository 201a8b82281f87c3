// A picture of a run, drawn by gnuplot: the displacement of each mass over time, its stops, impacts
// and the phases in which it sticks. How it looks stands in plot.gp, which is installed.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "vibro_impact/record.hpp"

namespace vibro_impact::runner {

// At most so many masses are drawn: those with stops before the others.
constexpr std::size_t most_masses_drawn = 8;

// A recorder of what the picture shows and no more: two events of a kind at a stop that fall on the
// same place of the paper are one.
class Plot {
 public:
  // From `from` to `to`; `held`: the contact mode at the start. Throws BadInput when there are more
  // periods than can be drawn, and when gnuplot is not there or does not draw this kind of file.
  Plot(const std::string &path, const Scene &scene, const Held &held, double from, double to);

  double next_time() const {
    return sample_time(from_, to_, every_, taken_);
  }
  void sample(const Moment &moment);
  void event(const Event &event, const Moment &moment);

  // Has gnuplot draw the run, which came to its end at `time`. Throws std::runtime_error.
  void draw(double time);

 private:
  // What a panel consists of, as rows of gnuplot.
  enum Layer { stop, sticking, displacement, impact, layers };
  struct Panel {
    int mass;
    std::array<std::string, layers> data = {};
    double held_since = 0.0;        // where it sticks now
    const Stop *held_at = nullptr;  // none: it is free
  };

  std::string path_, temporary_;
  const Scene &scene_;
  double from_, to_, every_ = 0.0;
  std::size_t taken_ = 0;
  std::vector<Panel> panels_ = {};
  std::vector<double> last_impact_;  // drawn, per stop
  double last_corner_ = -1.0;        // event at which the lines have a point

  void add_point(const Moment &moment);
  void end_sticking(Panel &panel, double time);
  std::string script(double time) const;
};

}  // namespace vibro_impact::runner
