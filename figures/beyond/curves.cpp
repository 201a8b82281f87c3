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

#include <functional>
#include <random>

#include "figures/driver.hpp"
#include "figures/parallel.hpp"

namespace {

using namespace vibro_impact;
using figures::CurvePlane;

struct WholeCurve {
  const CurvePlane *plane = nullptr;
  std::string name;
  BifurcationCurve curve;
  std::vector<CurvePoint> points;  // from one end to the other
  std::size_t start = 0;           // which of them it was followed from
  std::string ends[2];             // why the first is the first, the last the last
  std::string meets[2];            // a curve that is there, too
};

WholeCurve whole(const CurvePlane &plane, const figures::StartedCurve &started) {
  const FollowOptions options{.step = plane.step, .least_step = 1e-6, .turn = 0.3, .most = 1000};
  const Corrector corrector = corrector_of(started.curve);
  const FollowedCurve back = follow_curve(corrector, started.point, plane.box, -1, options),
                      forth = follow_curve(corrector, started.point, plane.box, 1, options);
  WholeCurve found{&plane, started.name, started.curve, {}, back.points.size() - 1, {}, {}};
  found.points.assign(back.points.rbegin(), back.points.rend() - 1);
  found.points.insert(found.points.end(), forth.points.begin(), forth.points.end());
  found.ends[0] = name(back.end);
  found.ends[1] = name(forth.end);
  return found;
}

// Ends a curve, on both sides of its start, where it comes to lie on one before it.
void cut(WholeCurve &curve, const WholeCurve &before) {
  constexpr double on_it = 1e-8;
  if (curve.plane != before.plane || curve.curve.what != before.curve.what ||
      curve.curve.stop != before.curve.stop)
    return;
  const auto lies_on_it = [&](const CurvePoint &point) {
    const auto away = figures::distance_to(before.curve, before.points, point.at, curve.plane->box,
                                           curve.plane->step);
    return away && *away < on_it;
  };
  const auto ends_there = [&](int side) {
    curve.ends[side] = "goes on as another";
    curve.meets[side] = before.name;
  };
  std::vector<CurvePoint> &points = curve.points;
  const auto start = points.begin() + static_cast<std::ptrdiff_t>(curve.start);
  const auto last = std::find_if(start, points.end(), lies_on_it);
  if (last != points.end()) ends_there(1);
  points.erase(last, points.end());
  if (points.size() <= curve.start) return points.clear();  // it is the other
  const auto reversed = std::find_if(points.rend() - static_cast<std::ptrdiff_t>(curve.start),
                                     points.rend(), lies_on_it);
  if (reversed == points.rend()) return;
  ends_there(0);
  curve.start -= static_cast<std::size_t>(reversed.base() - points.begin());
  points.erase(points.begin(), reversed.base());
}

// The curves that an end leads to: there to 1e-4.
void meet(WholeCurve &curve, const WholeCurve &other) {
  constexpr double there = 1e-4;
  if (&curve == &other || curve.plane != other.plane) return;
  for (const int side : {0, 1}) {
    const CurvePoint &end = side == 0 ? curve.points.front() : curve.points.back();
    if (!curve.meets[side].empty() || curve.ends[side] == name(CurveEnd::box)) continue;
    const PlaneBox &box = curve.plane->box;
    const bool ends_too = box.distance(end.at, other.points.front().at) < there ||
                          box.distance(end.at, other.points.back().at) < there;
    const auto away =
        ends_too ? std::optional(0.0)
                 : figures::distance_to(other.curve, other.points, end.at, box, curve.plane->step);
    if (away && *away < there) curve.meets[side] = other.name;
  }
}

struct Work {
  const CurvePlane *plane;
  std::function<figures::StartedCurve()> start;
};

// All curves of the planes, which outlive them.
std::vector<Work> work_on(const std::vector<CurvePlane> &planes) {
  std::vector<Work> work;
  for (const CurvePlane &plane : planes) {
    const auto add = [&](const auto &starts) {
      for (const auto &start : starts)
        work.push_back({&plane, [start, &plane] { return figures::started(start, plane); }});
    };
    const auto graze = [&](const PlanePoint &clear) {
      work.push_back({&plane, [clear, &plane] { return figures::started_grazing(plane, clear); }});
    };
    if (plane.name == "omega_r") add(figures::curve_starts());
    if (plane.name == "omega_r") add(figures::omega_r_edges());
    if (plane.name == "omega_A1") add(figures::amplitude_starts());
    if (plane.name == "5a") add(figures::stops_starts());
    if (plane.name == "5b") graze({0.0, 1.0});
    if (plane.name == "5c") add(figures::dual_sticking_starts());
    if (plane.name == "5b_omega_r") graze({-1.0, 0.0});
  }
  return work;
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
        figures::distance_by_counting(curve.curve, curve.points[k], curve.plane->box).value_or(1.0);
  return distances;
}

void draw(const std::filesystem::path &output) {
  const std::vector<CurvePlane> planes{figures::omega_r_plane(),
                                       figures::omega_A1_plane(),
                                       figures::stops_plane("5a", paper::figure5a()),
                                       figures::stops_plane("5b", paper::figure5b()),
                                       figures::stops_plane("5c", paper::figure5c()),
                                       figures::omega_r_plane_5b()};
  const std::vector<Work> work = work_on(planes);
  std::vector<WholeCurve> curves(work.size());
  std::vector<std::vector<double>> distances(work.size());
  Progress progress("curves", static_cast<double>(work.size()) + 1.0);
  figures::in_parallel(work.size(), [&](std::size_t k) {
    curves[k] = whole(*work[k].plane, work[k].start());
#pragma omp critical
    progress.advance();
  });
  for (std::size_t k = 0; k < curves.size(); ++k)
    for (std::size_t before = 0; before < k; ++before)
      if (!curves[k].points.empty()) cut(curves[k], curves[before]);
  std::erase_if(curves, [](const WholeCurve &curve) { return curve.points.empty(); });
  for (WholeCurve &curve : curves)
    for (const WholeCurve &other : curves) meet(curve, other);
  figures::in_parallel(curves.size(), [&](std::size_t k) {
    distances[k] = checked(curves[k], static_cast<unsigned>(k));
  });
  Table ends("plane,curve,x,y,end,meets");
  for (const CurvePlane &plane : planes) {
    Table points("curve,bifurcation,mass,period," + name(plane.x) + "," + name(plane.y) +
                 ",error,checked");
    for (std::size_t c = 0; c < curves.size(); ++c) {
      const WholeCurve &curve = curves[c];
      if (curve.plane != &plane) continue;
      for (std::size_t k = 0; k < curve.points.size(); ++k)
        points.row(curve.name, std::string(name(curve.curve.what)),
                   static_cast<int>(curve.curve.stop) + 1, curve.points[k].period,
                   curve.points[k].at.x, curve.points[k].at.y, curve.points[k].error,
                   distances[c][k]);
      for (const int side : {0, 1}) {
        const PlanePoint &at = side == 0 ? curve.points.front().at : curve.points.back().at;
        ends.row(plane.name, curve.name, at.x, at.y, curve.ends[side], curve.meets[side]);
      }
    }
    const bool main = &plane == &planes.front();
    write(points, output / (main ? "atlas_curves.csv" : "atlas_curves_" + plane.name + ".csv"));
  }
  write(ends, output / "atlas_curve_ends.csv");
}

}  // namespace

int main(int argc, char **argv) {
  return figures::drive(argc, argv, "Bifurcations of the paper's scenes as curves over the atlas",
                        draw);
}
