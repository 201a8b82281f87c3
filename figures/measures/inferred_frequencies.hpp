// The forcing frequencies of Figures 2, 5(a) and 5(b), which the paper's text does not give, and
// that of Figure 5(c), which it gives.
//
// figures/README.md, What is inferred, has the rule of choice and what it assumes of the axes. Each
// end of a printed axis says between which two ticks the extreme of the data lies. A mass reaches
// its stop in every impact.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "runs.hpp"

namespace vibro_impact::figures {

// Whether data fill an axis of this range: at each end they lie within one tick of it. An extreme
// on a tick counts for either side of it, to within the rounding of the data.
bool fills(const Range &data, const Range &axis, double tick);

bool fills_ordinate(const Range &data, const paper::AxisBox &box);

// A figure at one trial frequency: which of its conditions the motion meets, in their order.
struct Trial {
  double omega = 0.0;
  std::vector<bool> met = {};

  bool fits() const {
    return std::all_of(met.begin(), met.end(), [](bool condition) { return condition; });
  }
};

// The displacements of these masses that a window shows: their samples, and their stops if they hit
// them there.
Range shown(const Scene &scene, const std::vector<int> &masses, const SampleRecorder &samples,
            const std::vector<Event> &events);

constexpr double never = std::numeric_limits<double>::quiet_NaN();

// A chatter that ends in sticking. All times are `never` if there is none.
struct Chatter {
  double first_impact = never;      // since the mass was released
  double last_bounce_ends = never;  // of the flights higher than `height`
  double stick = never;
};

// The first chatter of a mass that ends in sticking after `from`, with its flights higher than
// `height`. A flight of duration T that begins at speed v rises by v T / 4, because the
// acceleration is nearly constant over a late flight of a chatter.
Chatter chatter_after(std::vector<Event> events, int mass, double from, double height = 0.0);

// A plot does not show a height below a thousandth of its ordinate.
double invisible(const paper::AxisBox &box);

// Figure 2. The text: each mass has one complete chatter and sticking period in every forcing
// period, and (b) is a close-up of the chatter of mass 2. So the window of (b) has to show the
// chatter from its first impact to the end of its last visible bounce. We assume that the author
// set its right end to the first tick beyond that bounce.
Trial try_figure2(double omega);

// Figure 5(a). The text: mass 1 has a complete chatter and sticking sequence, mass 2 has two
// impacts during its sticking phase. The window shows a bounce of that chatter, the stick and both
// impacts. Earlier impacts of mass 1 may lie before the window.
Trial try_figure5a(double omega);

// Figure 5(b). The text: at t of about 920 mass 2 grazes its stop while mass 1 is stuck. Grazing is
// to come so close that a plot does not show the gap. About 920 is nearer to 920 than to 919 or
// 921. A mass that sticks stands exactly where its stop is.
Trial try_figure5b(double omega);

// Figure 5(c), whose frequency is printed, as a trial of the rule. The text: mass 1 is stuck, mass
// 2 still chatters at the end of that sticking phase. So mass 1 is released in the window, and mass
// 2 has an impact in the ten time units before.
Trial try_figure5c(double omega);

// A figure whose frequency is inferred, the names of its conditions, of which the first is that of
// the axes, the scene drawn, and the frequencies that are tried.
struct InferredFigure {
  const char *name;
  Trial (*attempt)(double omega);
  std::vector<const char *> conditions;
  Scene drawn;
  double from = 0.02, to = 0.7;  // printed: the lowest and the highest frequency of the paper
};

std::vector<InferredFigure> inferred_figures();

// The number of decimals of a multiple of 1e-4.
int decimals(double omega);

// Whether the paper prints this frequency, of Figure 4 or of Figure 5(c).
bool is_printed(double omega);

// The rule of choice among the frequencies that fit. Throws std::runtime_error if none does, or if
// the rule leaves several.
double choice_among(std::vector<double> fitting);

// Tries every multiple of 1e-4 from `from` to `to`, in order.
std::vector<Trial> scan(double from, double to, Trial (*attempt)(double omega));

}  // namespace vibro_impact::figures
