// The bifurcations of the paper's scenes as curves over the atlas.
//
// atlas_curves.csv            in frequency and restitution: points of every curve, in the order
//                             along it; `checked`, at ten points of each at random: the distance,
//                             in units of the box, of the change of a count
// atlas_curves_omega_A1.csv   in frequency and amplitude
// atlas_curves_5a.csv, _5b, _5c  in the positions of the stops, at the frequencies of Figure 5
// atlas_curves_5b_omega_r.csv in frequency and restitution, at the stops of Figure 5(b)
// atlas_codimension_two.csv   points of codimension two that two curves lead to
// atlas_curve_ends.csv        where they end or have a corner, and what is zero there if it is
// known;
//                             `beyond`: 1 where the curve goes on
#include "curves.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "figures/driver.hpp"
#include "figures/parallel.hpp"

namespace {

using namespace vibro_impact;
using figures::CurvePlane;

struct WholeEnd {
  std::string what;
  PlanePoint at;
  double error, value;   // NaN where what is zero is not known
  bool goes_on = false;  // the curve is followed beyond
};

struct WholeCurve {
  std::string name;
  const CurvePlane *plane = nullptr;
  BifurcationCurve curve;
  std::vector<CurvePoint> points;
  std::vector<WholeEnd> ends;
  std::vector<double> checked, multiplier;  // one per point; NaN where not asked
};

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double distance(const PlanePoint &a, const PlanePoint &b, const PlaneBox &box) {
  return std::hypot((a.x - b.x) / (box.x_to - box.x_from), (a.y - b.y) / (box.y_to - box.y_from));
}

// The curve from a point on, through the ends beyond which it goes on: a few at most, since towards
// some meetings they are without number.
struct WayOut {
  std::vector<CurvePoint> points;
  std::vector<WholeEnd> ends;
};

WayOut way_out(const WholeCurve &whole, const CurvePoint &start, int direction) {
  constexpr int pieces = 16;
  const BifurcationCurve &curve = whole.curve;
  const PlaneBox &box = whole.plane->box;
  const Corrector corrector = corrector_of(curve);
  const EndConditions conditions = end_conditions(curve);
  // Nearer to their ends the chatters of border orbits are lost in rounding.
  const bool border = curve.what == Bifurcation::border_orbit;
  const FollowOptions options{
      .step = whole.plane->step, .least_step = border ? 1e-5 : 1e-6, .turn = 0.3, .most = 250};
  WayOut way{{start}, {}};
  for (int piece = 0; piece < pieces; ++piece) {
    const FollowedCurve followed =
        follow_curve(corrector, way.points.back(), box, direction, options, conditions);
    way.points.insert(way.points.end(), followed.points.begin() + 1, followed.points.end());
    const CurvePoint last = way.points.back();
    std::optional<LocatedEnd> end;
    if (followed.end == CurveEnd::lost && followed.points.size() >= 2)
      end = end_of(corrector, conditions, followed, box);
    way.ends.push_back(end ? WholeEnd{end->condition, end->at, end->error, end->value}
                           : WholeEnd{name(followed.end), last.at, nan, nan});
    const auto next = end ? beyond(curve, *end, last, box) : std::nullopt;
    if (!next || std::any_of(way.points.begin(), way.points.end(), [&](const CurvePoint &known) {
          return distance(known.at, next->point.at, box) <
                 0.5 * distance(end->at, next->point.at, box);
        }))
      return way;
    way.ends.back().goes_on = true;
    direction = next->direction;
    // What lies between, and no more.
    FollowedCurve back = follow_curve(corrector, next->point, box, -direction, options, conditions);
    const double near = 1.5 * distance(end->at, next->point.at, box);
    back.points.erase(
        std::find_if(back.points.begin(), back.points.end(),
                     [&](const auto &point) { return distance(end->at, point.at, box) > near; }),
        back.points.end());
    way.points.insert(way.points.end(), back.points.rbegin(), back.points.rend());
  }
  way.ends.push_back({"given up", way.points.back().at, nan, nan});
  return way;
}

WholeCurve whole(const std::string &name, const CurvePlane &plane,
                 const figures::StartedCurve &started, unsigned seed) {
  WholeCurve found{name, &plane, started.curve, {}, {}, {}, {}};
  const WayOut back = way_out(found, started.point, -1), forth = way_out(found, started.point, 1);
  found.points.assign(back.points.rbegin(), back.points.rend() - 1);
  found.points.insert(found.points.end(), forth.points.begin(), forth.points.end());
  found.ends.assign(back.ends.rbegin(), back.ends.rend());
  found.ends.insert(found.ends.end(), forth.ends.begin(), forth.ends.end());
  const std::size_t size = found.points.size();
  found.checked.assign(size, nan);
  for (const CurvePoint &point : found.points)
    found.multiplier.push_back(figures::multiplier_at(found.curve, point, plane.box));
  std::mt19937 random(seed);
  std::vector<std::size_t> asked;
  while (asked.size() < std::min<std::size_t>(10, size)) {
    const std::size_t k = random() % size;
    if (std::find(asked.begin(), asked.end(), k) != asked.end()) continue;
    asked.push_back(k);
    found.checked[k] =
        figures::distance_by_counting(found.curve, found.points[k], plane.box).value_or(nan);
  }
  return found;
}

// Ends of two curves that are one point, found in two ways.
struct Meeting {
  const WholeCurve *one, *other;
  const WholeEnd *end, *same;
};

std::vector<Meeting> meetings(const std::vector<WholeCurve> &curves) {
  constexpr double one_point = 1e-6;
  std::vector<Meeting> found;
  for (std::size_t i = 0; i < curves.size(); ++i)
    for (std::size_t j = i + 1; j < curves.size(); ++j)
      for (const WholeEnd &end : curves[i].ends)
        for (const WholeEnd &same : curves[j].ends)
          if (curves[i].plane == curves[j].plane && end.error < one_point &&
              same.error < one_point && distance(end.at, same.at, curves[i].plane->box) < one_point)
            found.push_back({&curves[i], &curves[j], &end, &same});
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
  const auto add_one = [&](const CurvePlane &plane, const std::string &name, const auto &start) {
    work.push_back({name, &plane, start});
  };
  std::vector<figures::CurveStart> starts = figures::curve_starts();
  // Further starts on two of the curves.
  std::erase_if(starts, [](const auto &start) {
    return start.name == "border_mass_1_3" || start.name == "border_mass_2_3";
  });
  const CurvePlane &omega_r = planes[0], &omega_A1 = planes[1], &at_5a = planes[2],
                   &at_5b = planes[3], &at_5c = planes[4], &omega_r_5b = planes[5];
  add(omega_r, starts);
  add(omega_r, figures::high_frequency_starts());
  for (const figures::FamilyStart &start : figures::family_starts())
    add_one(omega_r, start.name, [start] { return figures::started(start); });
  add(omega_A1, figures::amplitude_starts());
  add(at_5a, figures::stops_starts());
  add_one(at_5b, "grazing_mass_2", [&] { return figures::started_grazing(at_5b, {0.0, 1.0}); });
  add(at_5c, figures::dual_sticking_starts());
  add_one(omega_r_5b, "grazing_mass_2", [&] {
    return figures::started_grazing(omega_r_5b, {-1.0, 0.0});
  });
  add_one(omega_r_5b, "fold_2", figures::started_end_of_impacts);
  return work;
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
  Progress progress("curves", static_cast<double>(work.size()));
  figures::in_parallel(work.size(), [&](std::size_t k) {
    curves[k] = whole(work[k].name, *work[k].plane, work[k].start(), static_cast<unsigned>(k));
#pragma omp critical
    progress.advance();
  });
  Table ends("plane,curve,x,y,end,error,value,beyond");
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
      for (const WholeEnd &end : curve.ends)
        ends.row(std::string_view(plane.name), std::string_view(curve.name), end.at.x, end.at.y,
                 std::string_view(end.what), end.error, end.value, end.goes_on ? 1 : 0);
    }
    const bool main = &plane == &planes.front();
    write(points, output / (main ? "atlas_curves.csv" : "atlas_curves_" + plane.name + ".csv"));
  }
  Table two("plane,one,end,other,other_end,x,y,other_x,other_y");
  for (const auto &[one, other, end, same] : meetings(curves))
    two.row(std::string_view(one->plane->name), std::string_view(one->name),
            std::string_view(end->what), std::string_view(other->name),
            std::string_view(same->what), end->at.x, end->at.y, same->at.x, same->at.y);
  write(two, output / "atlas_codimension_two.csv");
  write(ends, output / "atlas_curve_ends.csv");
}

}  // namespace

int main(int argc, char **argv) {
  return figures::drive(argc, argv, "Bifurcations of the paper's scenes as curves over the atlas",
                        draw);
}
