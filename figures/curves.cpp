// The bifurcations of the Figure 2 scene as curves over the atlas, in the plane of forcing
// frequency and restitution.
//
// atlas_curves.csv            points of every curve, in the order along it; `checked`: the
// distance,
//                             in units of the box, of the change of a count of sticking phases
// atlas_codimension_two.csv   where two of them cross on one orbit
// atlas_curve_ends.csv        where they end
#include "curves.hpp"

#include <algorithm>
#include <exception>

#include "driver.hpp"

namespace {

using namespace vibro_impact;

struct WholeCurve {
  std::string name;
  BifurcationCurve curve;
  std::vector<CurvePoint> points;
  CurveEnd first = CurveEnd::lost, last = CurveEnd::lost;
  std::vector<double> checked, multiplier;  // one per point; NaN where not asked
};

WholeCurve whole(const figures::CurveStart &start) {
  const figures::StartedCurve started = figures::started(start);
  const Corrector corrector = corrector_of(started.curve);
  // An end is found by halving steps: to ten digits where a step costs a few runs; a border orbit,
  // on which the orbit is no differentiable function of the parameters, is given up earlier.
  const bool border = start.what == Bifurcation::border_orbit;
  const FollowOptions options{
      .step = 0.015, .least_step = border ? 5e-4 : 1e-10, .turn = 0.3, .most = 100};
  const PlaneBox &box = figures::omega_r_box;
  const FollowedCurve back = follow_curve(corrector, started.point, box, -1, options),
                      forth = follow_curve(corrector, started.point, box, 1, options);
  WholeCurve found{start.name, started.curve, {back.points.rbegin(), back.points.rend() - 1},
                   back.end,   forth.end,     {},
                   {}};
  found.points.insert(found.points.end(), forth.points.begin(), forth.points.end());
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  found.checked.assign(found.points.size(), nan);
  const std::size_t every = std::max<std::size_t>(1, found.points.size() / 10);
  for (std::size_t k = 0; k < found.points.size(); ++k) {
    found.multiplier.push_back(figures::multiplier_beside(found.curve, found.points[k], box));
    if (k % every == every / 2)
      found.checked[k] =
          figures::distance_by_counting(found.curve, found.points[k], box).value_or(nan);
  }
  return found;
}

// Where two curves cross on one orbit.
struct Meeting {
  std::string one, other;
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
      if (curves[i].curve.what == curves[j].curve.what &&
          curves[i].curve.stop == curves[j].curve.stop)
        continue;
      const auto &a = curves[i].points, &b = curves[j].points;
      for (std::size_t k = 0; k + 1 < a.size(); ++k)
        for (std::size_t l = 0; l + 1 < b.size(); ++l) {
          if (!cross(a[k].at, a[k + 1].at, b[l].at, b[l + 1].at)) continue;
          const auto crossing =
              crossing_of(corrector_of(curves[i].curve), corrector_of(curves[j].curve), a[k], b[l],
                          figures::omega_r_box);
          if (crossing && same_orbit(curves[i], *crossing))
            found.push_back({curves[i].name, curves[j].name, *crossing});
        }
    }
  return found;
}

void draw(const std::filesystem::path &output) {
  const auto starts = figures::curve_starts();
  std::vector<WholeCurve> curves(starts.size());
  Progress progress("curves", static_cast<double>(starts.size()));
  std::exception_ptr failure;
#pragma omp parallel for schedule(dynamic)
  for (std::size_t k = 0; k < starts.size(); ++k) {
    try {
      curves[k] = whole(starts[k]);
    } catch (...) {
#pragma omp critical
      failure = std::current_exception();
    }
#pragma omp critical
    progress.advance();
  }
  if (failure) std::rethrow_exception(failure);
  Table points("curve,bifurcation,mass,period,omega,restitution,error,time,multiplier,checked");
  Table ends("curve,omega,restitution,end");
  for (const WholeCurve &curve : curves) {
    for (std::size_t k = 0; k < curve.points.size(); ++k)
      points.row(std::string_view(curve.name), std::string_view(name(curve.curve.what)),
                 static_cast<int>(curve.curve.stop) + 1, curve.curve.periods, curve.points[k].at.x,
                 curve.points[k].at.y, curve.points[k].error, curve.points[k].time,
                 curve.multiplier[k], curve.checked[k]);
    ends.row(std::string_view(curve.name), curve.points.front().at.x, curve.points.front().at.y,
             std::string_view(name(curve.first)));
    ends.row(std::string_view(curve.name), curve.points.back().at.x, curve.points.back().at.y,
             std::string_view(name(curve.last)));
  }
  Table two("one,other,omega,restitution,other_omega,other_restitution,error");
  for (const Meeting &meeting : meetings(curves))
    two.row(std::string_view(meeting.one), std::string_view(meeting.other),
            meeting.crossing.one.at.x, meeting.crossing.one.at.y, meeting.crossing.other.at.x,
            meeting.crossing.other.at.y, meeting.crossing.error);
  write(points, output / "atlas_curves.csv");
  write(two, output / "atlas_codimension_two.csv");
  write(ends, output / "atlas_curve_ends.csv");
}

}  // namespace

int main(int argc, char **argv) {
  return figures::drive(
      argc, argv, "Multi-sliding and border orbits as curves in frequency and restitution", draw);
}
