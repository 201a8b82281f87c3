// The bifurcations of the paper's scenes as curves over the atlas.
//
// atlas_curves.csv            in frequency and restitution: points of every curve, in the order
//                             along it; `period`: the least one of the orbit; `checked`, at ten
//                             points of each at random: the distance, in units of the box, of the
//                             change of a count
// atlas_curves_omega_A1.csv   in frequency and amplitude
// atlas_curves_5a.csv, _5b, _5c  in the positions of the stops, at the frequencies of Figure 5
// atlas_curves_5b_omega_r.csv in frequency and restitution, at the stops of Figure 5(b)
// atlas_curve_ends.csv        where they end and why; `meets`: another curve that is there
#include "curves.hpp"

#include <array>
#include <random>

#include "figures/driver.hpp"
#include "figures/parallel.hpp"

namespace {

using namespace vibro_impact;
using figures::CurvePlane;

// A curve to one side of its start.
struct Half {
  std::vector<CurvePoint> points;  // the start first
  std::string end;                 // why it ends
  std::string meets = {};          // a curve that is there, too
};

struct WholeCurve {
  figures::StartedCurve started;
  std::array<Half, 2> halves;
  std::vector<CurvePoint> points = {};  // of both, from one end to the other
};

WholeCurve whole(const figures::CurveStart &start) {
  const figures::StartedCurve started = figures::started(start);
  const FollowOptions options{
      .step = started.plane.step, .least_step = 1e-6, .turn = 0.3, .most = 1000};
  const auto half = [&](int direction) {
    const FollowedCurve followed = follow_curve(corrector_of(started.curve), started.point,
                                                started.plane.box, direction, options);
    return Half{followed.points, name(followed.end)};
  };
  return {started, {half(-1), half(1)}};
}

void join(WholeCurve &curve) {
  const auto &[back, forth] = curve.halves;
  curve.points.assign(back.points.rbegin(), back.points.rend());
  if (!forth.points.empty())
    curve.points.insert(curve.points.end(), forth.points.begin() + 1, forth.points.end());
}

// How far a place is from another curve of the plane.
std::optional<double> distance_to(const WholeCurve &other, const PlanePoint &at) {
  const auto &[start, plane, curve, point] = other.started;
  return figures::distance_to(curve, other.points, at, plane.box, plane.step);
}

// Ends a curve, on both sides of its start, where it comes to lie on one before it; nothing is left
// of one that is the other.
void cut(WholeCurve &curve, const WholeCurve &before) {
  constexpr double on_it = 1e-8;
  const figures::CurveStart &start = curve.started.start, &other = before.started.start;
  if (start.plane != other.plane || start.what != other.what || start.mass != other.mass) return;
  for (Half &half : curve.halves) {
    const auto last =
        std::find_if(half.points.begin(), half.points.end(), [&](const CurvePoint &point) {
          const auto away = distance_to(before, point.at);
          return away && *away < on_it;
        });
    if (last == half.points.end()) continue;
    half.end = "goes on as another";
    half.meets = other.name;
    half.points.erase(last, half.points.end());
  }
  join(curve);
}

// The curves that an end leads to: there to 1e-4.
void meet(WholeCurve &curve, const WholeCurve &other) {
  constexpr double there = 1e-4;
  if (&curve == &other || curve.started.start.plane != other.started.start.plane) return;
  for (Half &half : curve.halves) {
    if (!half.meets.empty() || half.end == name(CurveEnd::box)) continue;
    const PlanePoint &end = half.points.back().at;
    const auto is_there = [&](const Half &half_of_other) {
      return curve.started.plane.box.distance(end, half_of_other.points.back().at) < there;
    };
    const bool ends_too = std::any_of(other.halves.begin(), other.halves.end(), is_there);
    if (ends_too || distance_to(other, end).value_or(1.0) < there)
      half.meets = other.started.start.name;
  }
}

// At ten of the points, or all: by counting.
std::vector<double> checked(const WholeCurve &curve, unsigned seed) {
  constexpr std::size_t asked = 10;
  std::vector<std::size_t> order(curve.points.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::shuffle(order.begin(), order.end(), std::mt19937(seed));
  order.resize(std::min(order.size(), asked));
  std::vector<double> distances(curve.points.size(), std::nan(""));
  for (const std::size_t k : order)
    distances[k] =
        figures::distance_by_counting(curve.started.curve, curve.points[k], curve.started.plane.box)
            .value_or(1.0);
  return distances;
}

void draw(const std::filesystem::path &output) {
  const std::vector<figures::CurveStart> starts = figures::curve_starts();
  std::vector<WholeCurve> curves(starts.size());
  Progress progress("curves", static_cast<double>(starts.size()) + 1.0);
  figures::in_parallel(starts.size(), [&](std::size_t k) {
    curves[k] = whole(starts[k]);
    join(curves[k]);
    progress.advance();
  });
  for (std::size_t k = 0; k < curves.size(); ++k)
    for (std::size_t before = 0; before < k; ++before)
      if (!curves[k].points.empty()) cut(curves[k], curves[before]);
  std::erase_if(curves, [](const WholeCurve &curve) { return curve.points.empty(); });
  for (WholeCurve &curve : curves)
    for (const WholeCurve &other : curves) meet(curve, other);
  std::vector<std::vector<double>> distances(curves.size());
  figures::in_parallel(curves.size(), [&](std::size_t k) {
    distances[k] = checked(curves[k], static_cast<unsigned>(k));
  });
  Table ends("plane,curve,x,y,end,meets");
  for (const CurvePlane &plane : figures::curve_planes()) {
    Table points("curve,bifurcation,mass,period," + name(plane.x) + "," + name(plane.y) +
                 ",error,checked");
    for (std::size_t c = 0; c < curves.size(); ++c) {
      const WholeCurve &curve = curves[c];
      const figures::CurveStart &start = curve.started.start;
      if (start.plane != plane.name) continue;
      for (std::size_t k = 0; k < curve.points.size(); ++k) {
        const CurvePoint &point = curve.points[k];
        points.row(start.name, name(start.what), start.mass, point.period, point.at.x, point.at.y,
                   point.error, distances[c][k]);
      }
      for (const auto &[followed, end, meets] : curve.halves)
        ends.row(plane.name, start.name, followed.back().at.x, followed.back().at.y, end, meets);
    }
    const std::string of_plane = plane.name == "omega_r" ? "" : "_" + plane.name;
    write(points, output / ("atlas_curves" + of_plane + ".csv"));
  }
  write(ends, output / "atlas_curve_ends.csv");
}

}  // namespace

int main(int argc, char **argv) {
  return figures::drive(argc, argv, "Bifurcations of the paper's scenes as curves over the atlas",
                        draw);
}
