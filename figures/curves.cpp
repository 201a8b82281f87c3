// The bifurcations of the paper's scenes as curves over the atlas.
//
// atlas_curves.csv            in frequency and restitution: points of every curve, in the order
//                             along it; `checked`, at ten points of each at random: the distance,
//                             in units of the box, of the change of a count
// atlas_curves_omega_A1.csv   in frequency and amplitude
// atlas_curves_5a.csv, _5b    in the positions of the stops, at the frequencies of Figure 5(a), (b)
// atlas_codimension_two.csv   where two in frequency and restitution cross on one orbit
// atlas_curve_ends.csv        where they end, and what is zero there, as far as it is known
#include "curves.hpp"

#include <algorithm>
#include <functional>
#include <random>

#include "driver.hpp"
#include "parallel.hpp"

namespace {

using namespace vibro_impact;
using figures::CurvePlane;

struct WholeEnd {
  std::string what;
  PlanePoint at;
  double error, value;  // NaN where what is zero is not known
};

struct WholeCurve {
  std::string name;
  const CurvePlane *plane = nullptr;
  BifurcationCurve curve;
  std::vector<CurvePoint> points;
  WholeEnd first, last;
  std::vector<double> checked, multiplier;  // one per point; NaN where not asked
};

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

WholeEnd end_of(const BifurcationCurve &curve, const FollowedCurve &followed, const PlaneBox &box) {
  const PlanePoint &last = followed.points.back().at;
  if (followed.end == CurveEnd::lost && followed.points.size() >= 3) {
    const auto end = end_of(corrector_of(curve), end_conditions(curve), followed.points, box);
    if (end) return {end->condition, end->at, end->error, end->value};
  }
  return {name(followed.end), last, nan, nan};
}

WholeCurve whole(const std::string &name, const CurvePlane &plane,
                 const figures::StartedCurve &started, unsigned seed) {
  const Corrector corrector = corrector_of(started.curve);
  // A border orbit, on which the orbit is no differentiable function of the parameters, is given up
  // earlier than others.
  const bool border = started.curve.what == Bifurcation::border_orbit;
  const FollowOptions options{
      .step = plane.step, .least_step = border ? 5e-5 : 1e-7, .turn = 0.3, .most = 200};
  const PlaneBox &box = plane.box;
  const FollowedCurve back = follow_curve(corrector, started.point, box, -1, options),
                      forth = follow_curve(corrector, started.point, box, 1, options);
  WholeCurve found{name,
                   &plane,
                   started.curve,
                   {back.points.rbegin(), back.points.rend() - 1},
                   end_of(started.curve, back, box),
                   end_of(started.curve, forth, box),
                   {},
                   {}};
  found.points.insert(found.points.end(), forth.points.begin(), forth.points.end());
  const std::size_t size = found.points.size();
  found.checked.assign(size, nan);
  for (const CurvePoint &point : found.points)
    found.multiplier.push_back(figures::multiplier_at(found.curve, point, box));
  std::mt19937 random(seed);
  std::vector<std::size_t> asked;
  while (asked.size() < std::min<std::size_t>(10, size)) {
    const std::size_t k = random() % size;
    if (std::find(asked.begin(), asked.end(), k) != asked.end()) continue;
    asked.push_back(k);
    found.checked[k] =
        figures::distance_by_counting(found.curve, found.points[k], box).value_or(nan);
  }
  return found;
}

// Where two curves cross on one orbit.
struct Meeting {
  std::string one, other;
  const CurvePlane *plane;
  Crossing crossing;
};

// True where the ways from a to b and from c to d cross.
bool cross(const PlanePoint &a, const PlanePoint &b, const PlanePoint &c, const PlanePoint &d) {
  const auto left = [](const PlanePoint &p, const PlanePoint &q, const PlanePoint &r) {
    return (q.x - p.x) * (r.y - p.y) > (q.y - p.y) * (r.x - p.x);
  };
  return left(a, b, c) != left(a, b, d) && left(c, d, a) != left(c, d, b);
}

// The motion of one reaches the section of the other in the state of the other.
bool same_orbit(const WholeCurve &one, const Crossing &crossing) {
  const Scene scene = one.curve.at(crossing.one.at);
  const MotionState &from = crossing.one.state, &to = crossing.other.state;
  const Clock clock(scene.omega);
  double until = time_of(to.instant, clock);
  if (until < time_of(from.instant, clock)) until += clock.period;
  const MotionState there = simulate_from(scene, from, until).state;
  if (there.held != to.held) return false;
  const std::vector<double> a = coordinates(there), b = coordinates(to);
  for (std::size_t i = 0; i < a.size(); ++i)
    if (std::abs(a[i] - b[i]) > 1e-6) return false;
  return true;
}

std::vector<Meeting> meetings(const std::vector<WholeCurve> &curves) {
  std::vector<Meeting> found;
  for (std::size_t i = 0; i < curves.size(); ++i)
    for (std::size_t j = i + 1; j < curves.size(); ++j) {
      // Two chatters of one mass are often one and the same, met from two sides.
      if (curves[i].plane != curves[j].plane || (curves[i].curve.what == curves[j].curve.what &&
                                                 curves[i].curve.stop == curves[j].curve.stop))
        continue;
      const auto &a = curves[i].points, &b = curves[j].points;
      for (std::size_t k = 0; k + 1 < a.size(); ++k)
        for (std::size_t l = 0; l + 1 < b.size(); ++l) {
          if (!cross(a[k].at, a[k + 1].at, b[l].at, b[l + 1].at)) continue;
          const auto crossing =
              crossing_of(corrector_of(curves[i].curve), corrector_of(curves[j].curve), a[k], b[l],
                          curves[i].plane->box);
          if (crossing && same_orbit(curves[i], *crossing))
            found.push_back({curves[i].name, curves[j].name, curves[i].plane, *crossing});
        }
    }
  return found;
}

struct Work {
  std::string name;
  const CurvePlane *plane;
  std::function<figures::StartedCurve()> start;
};

// All curves of the planes, which outlive them.
std::vector<Work> work_on(const std::vector<CurvePlane> &planes) {
  std::vector<Work> work;
  const auto add = [&](const CurvePlane &plane, const auto &starts) {
    for (const auto &start : starts)
      work.push_back(
          {start.name, &plane, [start, &plane] { return figures::started(start, plane); }});
  };
  std::vector<figures::CurveStart> starts = figures::curve_starts();
  // Further starts on two of the curves.
  std::erase_if(starts, [](const auto &start) {
    return start.name == "border_mass_1_3" || start.name == "border_mass_2_3";
  });
  add(planes[0], starts);
  for (const figures::FamilyStart &start : figures::family_starts())
    work.push_back({start.name, &planes[0], [start] { return figures::started(start); }});
  add(planes[1], figures::amplitude_starts());
  add(planes[2], figures::stops_starts());
  work.push_back({"grazing_mass_2", &planes[3],
                  [&plane = planes[3]] { return figures::started_grazing(plane); }});
  return work;
}

void draw(const std::filesystem::path &output) {
  const std::vector<CurvePlane> planes{figures::omega_r_plane(), figures::omega_A1_plane(),
                                       figures::stops_plane("5a", paper::figure5a()),
                                       figures::stops_plane("5b", paper::figure5b())};
  const std::vector<Work> work = work_on(planes);
  std::vector<WholeCurve> curves(work.size());
  Progress progress("curves", static_cast<double>(work.size()));
  figures::in_parallel(work.size(), [&](std::size_t k) {
    curves[k] = whole(work[k].name, *work[k].plane, work[k].start(), static_cast<unsigned>(k));
#pragma omp critical
    progress.advance();
  });
  Table ends("plane,curve,x,y,end,error,value");
  for (const CurvePlane &plane : planes) {
    Table points("curve,bifurcation,mass,period," + name(plane.x) + "," + name(plane.y) +
                 ",error,time,multiplier,checked");
    for (const WholeCurve &curve : curves) {
      if (curve.plane != &plane) continue;
      for (std::size_t k = 0; k < curve.points.size(); ++k)
        points.row(std::string_view(curve.name), std::string_view(name(curve.curve.what)),
                   static_cast<int>(curve.curve.stop) + 1, curve.curve.periods,
                   curve.points[k].at.x, curve.points[k].at.y, curve.points[k].error,
                   curve.points[k].time, curve.multiplier[k], curve.checked[k]);
      for (const WholeEnd *end : {&curve.first, &curve.last})
        ends.row(std::string_view(plane.name), std::string_view(curve.name), end->at.x, end->at.y,
                 std::string_view(end->what), end->error, end->value);
    }
    const bool main = &plane == &planes.front();
    write(points, output / (main ? "atlas_curves.csv" : "atlas_curves_" + plane.name + ".csv"));
  }
  Table two("one,other,omega,restitution,other_omega,other_restitution,error");
  for (const Meeting &meeting : meetings(curves))
    if (meeting.plane == &planes.front())
      two.row(std::string_view(meeting.one), std::string_view(meeting.other),
              meeting.crossing.one.at.x, meeting.crossing.one.at.y, meeting.crossing.other.at.x,
              meeting.crossing.other.at.y, meeting.crossing.error);
  write(two, output / "atlas_codimension_two.csv");
  write(ends, output / "atlas_curve_ends.csv");
}

}  // namespace

int main(int argc, char **argv) {
  return figures::drive(argc, argv, "Bifurcations of the paper's scenes as curves over the atlas",
                        draw);
}
