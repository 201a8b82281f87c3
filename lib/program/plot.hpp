// A picture of a run, drawn by gnuplot: the displacement of each mass over time, its stops, impacts
// and the phases in which it sticks.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "destination.hpp"
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
  Plot(const Destination &file, const Scene &scene, const Held &held, double from, double to);

  double next_time() const;
  void sample(const Moment &moment);
  void event(const Event &event, const Moment &moment);

  // Has gnuplot draw the run, which came to its end at `time`. Throws std::runtime_error.
  void draw(double time);

 private:
  struct Panel {
    int mass;
    std::string stops;              // their positions, one per line
    std::string line = {};          // time and displacement
    std::string impacts = {};       // time and position
    std::string sticking = {};      // both ends of each phase
    double held_since = 0.0;        // where it sticks now
    const Stop *held_at = nullptr;  // none: it is free
  };

  struct Layer;

  const Destination &file_;
  const Scene &scene_;
  double from_, to_, every_;
  std::size_t taken_ = 0;
  std::vector<Panel> panels_ = {};
  std::map<std::size_t, double> last_impact_ = {};  // drawn, by stop
  double last_event_ = -1.0;                        // at which the lines have a point

  void add_point(const Moment &moment);
  void end_sticking(Panel &panel, double time);
  std::string script(double time) const;
};

}  // namespace vibro_impact::runner
