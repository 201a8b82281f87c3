// The border orbits unfolded: impacts added one by one as the border comes nearer.
//
// border_cascade.csv             where each impact is added on the orbit of every border orbit;
//                                `beyond`: how far, in units of the distance, the orbit with the
//                                impact goes on beside the one without (some impacts; empty: not
//                                asked, or nowhere)
// border_cascade_factors.csv     the factor of the distances, measured and predicted
// border_cascade_attractors.csv  from rest beyond border_mass_1_4: period (0: none up to 8) and the
//                                impacts of the chatters of mass 1 on it, different ones once
#include "cascade_factors.hpp"
#include "figures/driver.hpp"
#include "vibro_impact/analysis/settle.hpp"

namespace {

using namespace vibro_impact;
using figures::AddedImpact;
using figures::LastImpacts;

constexpr double farthest = 1e-2;  // from the border, in omega

struct Cascade {
  figures::Unfolding of;
  std::vector<AddedImpact> added;
  std::vector<std::optional<double>> beyond;  // one per impact
};

Cascade cascade(const figures::CurveStart &border) {
  Cascade found{figures::unfolding(border.name, border.mass, border.x, border.side), {}, {}};
  const auto orbits = figures::followed(found.of, farthest);
  found.added = figures::added_impacts(found.of, orbits);
  for (const AddedImpact &one : found.added) {
    found.beyond.emplace_back();
    // Nearer to the border the folds lie within the rounding of omega.
    if (one.impact % 4 != 0 || one.distance < 1e-8) continue;
    const auto inside = std::find_if(orbits.rbegin(), orbits.rend(), [&](const auto &orbit) {
      return orbit.impacts == one.impact && orbit.distance < one.distance;
    });
    if (inside != orbits.rend()) found.beyond.back() = figures::fold_beyond(found.of, one, *inside);
  }
  return found;
}

// The chatter sequences of mass 1 on the attractor that the motion from rest comes to.
struct Attractor {
  int period = 0;  // in forcing periods; 0: none up to 8
  struct Chatter {
    int impacts;
    bool complete;
    auto operator<=>(const Chatter &) const = default;
  };
  std::vector<Chatter> chatters;  // of one period of it, or of 8 forcing periods; different ones
};

Attractor attractor_from_rest(double omega) {
  const Scene scene = paper::stops_of_different_sign(omega);
  const SettledMotion motion =
      settle(scene, at_quiet_phase(scene, settled(scene, 1)));  // a section that no chatter crosses
  Attractor found{motion.period, {}};
  LastImpacts impacts{1};
  stroboscopic_map(scene, motion.state, found.period == 0 ? 8 : found.period, {}, impacts);
  for (const LastImpacts::Sequence &one : impacts.sequences)
    found.chatters.push_back({one.complete ? 0 : one.impacts, one.complete});
  std::sort(found.chatters.begin(), found.chatters.end());
  const auto last = std::unique(found.chatters.begin(), found.chatters.end());
  found.chatters.erase(last, found.chatters.end());
  return found;
}

// The border orbit of which only every other chatter becomes incomplete.
constexpr std::string_view every_other = "border_mass_1_4";

std::vector<std::pair<double, Attractor>> attractors_beyond(const figures::Unfolding &of) {
  constexpr std::size_t per_decade = 200, decades = 8;
  std::vector<std::pair<double, Attractor>> attractors(decades * per_decade);
  figures::in_parallel(attractors.size(), [&](std::size_t k) {
    const double distance =
        farthest * std::pow(10.0, static_cast<double>(k) / per_decade - double{decades});
    attractors[k] = {distance, attractor_from_rest(of.omega_at(distance))};
  });
  return attractors;
}

void cell_or_empty(Table &table, const std::optional<double> &value) {
  if (value)
    table.cell(*value);
  else
    table.cell(std::string_view());
}

// The factor from the impact before; nothing where that is not known.
std::optional<double> ratio(const std::vector<AddedImpact> &added, std::size_t k) {
  if (k == 0 || added[k - 1].impact + 1 != added[k].impact) return std::nullopt;
  return added[k].distance / added[k - 1].distance;
}

void add_rows(Table &impacts, Table &factors, const Cascade &cascade) {
  const std::string_view name = cascade.of.name;
  const std::vector<AddedImpact> &added = cascade.added;
  for (std::size_t k = 0; k < added.size(); ++k) {
    impacts.cell(name);
    impacts.cell(added[k].impact);
    impacts.cell(cascade.of.omega_at(added[k].distance));
    impacts.cell(added[k].distance);
    cell_or_empty(impacts, ratio(added, k));
    impacts.cell(added[k].error);
    cell_or_empty(impacts, cascade.beyond[k]);
    impacts.end_row();
  }
  const auto predicted = figures::predicted_cascade(cascade.of.scene_at(0.0).restitution);
  const auto measured = figures::measured_factor(added, predicted);
  factors.cell(name);
  factors.cell(cascade.of.border);
  factors.cell(cascade.of.periods);
  cell_or_empty(factors, added.empty() ? std::nullopt : ratio(added, added.size() - 1));
  cell_or_empty(factors, measured ? std::optional(measured->value) : std::nullopt);
  cell_or_empty(factors, measured ? std::optional(measured->uncertainty) : std::nullopt);
  factors.cell(predicted.factor);
  factors.cell(predicted.correction);
  factors.end_row();
}

void draw(const std::filesystem::path &output) {
  const auto borders = figures::borders_to_unfold();
  std::vector<std::optional<Cascade>> cascades(borders.size());
  Progress progress("border cascade", static_cast<double>(borders.size()) + 1.0);
  figures::in_parallel(borders.size(), [&](std::size_t k) {
    cascades[k] = cascade(borders[k]);
#pragma omp critical(progress)
    progress.advance();
  });
  Table impacts("orbit,impact,omega,distance,ratio,error,beyond");
  Table factors("orbit,omega,periods,last_ratio,measured,uncertainty,predicted,correction");
  Table attractors("omega,distance,period,impacts,complete");
  for (const auto &cascade : cascades) {
    add_rows(impacts, factors, *cascade);
    if (cascade->of.name != every_other) continue;
    for (const auto &[distance, attractor] : attractors_beyond(cascade->of))
      for (const auto &chatter : attractor.chatters)
        attractors.row(cascade->of.omega_at(distance), distance, attractor.period, chatter.impacts,
                       chatter.complete ? 1 : 0);
  }
  progress.advance();
  write(impacts, output / "border_cascade.csv");
  write(factors, output / "border_cascade_factors.csv");
  write(attractors, output / "border_cascade_attractors.csv");
}

}  // namespace

int main(int argc, char **argv) {
  return figures::drive(argc, argv, "Impacts added one by one beyond the border orbits", draw);
}
