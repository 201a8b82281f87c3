#include "ends.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace vibro_impact::branches {

namespace {

using Difference = std::ptrdiff_t;

// The part of a step at which a test function that falls from a to b, b < 0, is zero. Nothing if it
// was below zero before.
std::optional<double> zero_part(double a, double b) {
  return a > 0.0 ? std::optional(a / (a - b)) : std::nullopt;
}

End end_of(BranchPoint kind, Extra extra, size_t item, const Sequence &s, const Vector &u) {
  End end;
  end.kind = kind;
  end.condition.extra = extra;
  end.condition.item = item;
  end.sequence = s;
  end.u = u;
  return end;
}

// An end on the way from one orbit to another.
End end_on_the_way(BranchPoint kind, Extra extra, size_t item, const Place &from, const Vector &to,
                   std::optional<double> zero) {
  const double part = zero.value_or(0.5);
  End end = end_of(kind, extra, item, from.sequence, from.u + part * (to - from.u));
  end.part = part;
  if (!zero) end.guess = Guess::nearby;
  return end;
}

// Adds an item to the flight of an end.
void add_item(const Problem &problem, End &end, size_t flight, double offset, const Item &item) {
  auto &items = end.sequence.items;
  items.insert(items.begin() + static_cast<Difference>(flight + 1), item);
  end.condition.item = flight + 1;
  end.u = divided(problem, end.u, flight, offset);
}

// Makes impacts touches.
void make_touches(const Problem &problem, End &end, const std::vector<size_t> &impacts) {
  const Sequence before = end.sequence;
  for (const size_t k : impacts) end.sequence.items[k].what = Happening::touch;
  re_express(problem, before, end.sequence, end.u);
  end.replaces_impact = true;
}

// The value at the start of the step of the minimum that lies nearest to this one.
double value_before(const Minimum &least, const std::vector<Minimum> &before) {
  double value = -1.0, nearest = infinity;
  for (const Minimum &other : before) {
    if (other.stop != least.stop || other.is_press != least.is_press ||
        other.flight != least.flight || other.after_event != least.after_event ||
        !(std::abs(other.offset - least.offset) < nearest))
      continue;
    nearest = std::abs(other.offset - least.offset);
    value = other.value;
  }
  return value;
}

// The time from a hold to the release, and how fast the acceleration towards the stop falls there;
// 0 if something else happens to the mass before.
struct ToRelease {
  double time = 0.0, slope = 0.0;
};
ToRelease to_release(const Problem &problem, const Model &model, const Sequence &s, const Vector &u,
                     const Inspection &seen, size_t hold) {
  const size_t count = s.items.size(), mass = problem.mass_of(s.items[hold]);
  ToRelease result;
  for (size_t j = 0; j < count; ++j) {
    result.time += u(problem.time_at((hold + j) % count));
    const size_t at = (hold + j + 1) % count;
    if (s.items[at] == Item{Happening::release, s.items[hold].stop}) {
      result.slope = -seen.items[at].slope * model.inverse_mass[mass].value;
      return result;
    }
    if (s.items[at].what != Happening::start && problem.mass_of(s.items[at]) == mass) break;
  }
  return result;
}

// True if the last impact of a chatter lies beyond a border orbit.
bool is_past_border(const Problem &problem, const Model &model, const Sequence &s, const Vector &u,
                    const Inspection &seen) {
  for (size_t k = 0; k < s.items.size(); ++k) {
    if (s.items[k].what != Happening::start && u(problem.time_at(k)) < 0.0) return true;
    if (s.items[k].what != Happening::hold) continue;
    if (!(seen.items[k].press > 0.0)) return true;
    const ModelStop &stop = model.stop(s.items[k].stop);
    const auto [time, slope] = to_release(problem, model, s, u, seen, k);
    const double speed = rebound(stop, seen.items[k].speed).speed;
    if (slope > 0.0 &&
        speed > border_constant(stop.ratio_at_rest()).value * slope * time * std::abs(time))
      return true;
  }
  return false;
}

}  // namespace

std::vector<End> ends_between(const Problem &problem, const Place &from, const Vector &to,
                              const Inspection &seen_to) {
  const Sequence &s = from.sequence;
  const Inspection &a = from.seen, &b = seen_to;
  const size_t count = s.items.size();
  const Model model(problem.scene, problem.parameter, to(0));
  std::vector<End> ends;
  if (is_past_border(problem, model, s, to, b)) ends = border_ends(problem, from);
  const auto add = [&](BranchPoint kind, Extra extra, size_t item, double at_a, double at_b) {
    ends.push_back(end_on_the_way(kind, extra, item, from, to, zero_part(at_a, at_b)));
  };
  std::vector<size_t> without_speed;  // impacts
  for (size_t k = 0; k < count; ++k) {
    const Item &item = s.items[k], &next = s.items[(k + 1) % count];
    const double press_a = a.items[k].press, press_b = b.items[k].press;
    if (hits(item.what) && b.items[k].speed < 0.0) {
      const bool rebounds = item.what == Happening::impact;
      add(BranchPoint::graze, rebounds ? Extra::contact : Extra::speed, k, a.items[k].speed,
          b.items[k].speed);
      if (rebounds) {
        make_touches(problem, ends.back(), {k});
        without_speed.push_back(k);
      }
    }
    if (item.what == Happening::impact && press_b > 0.0)
      add(BranchPoint::border_orbit, Extra::press, k, -press_a, -press_b);
    if (item.what == Happening::hold && press_b < 0.0 && model.stop(item.stop).law.at_rest() == 0.0)
      add(BranchPoint::border_orbit, Extra::press, k, press_a, press_b);
    const Eigen::Index time = problem.time_at(k);
    if (to(time) < 0.0 && next.what != Happening::jump && item.what != Happening::start) {
      add(BranchPoint::coincidence, Extra::no_time, k, from.u(time), to(time));
      ends.back().is_unexplained = problem.mass_of(item) == problem.mass_of(next);
    }
    if (item.what == Happening::jump && press_b > 0.0) {
      add(BranchPoint::jump, Extra::press, k, -press_a, -press_b);
      ends.back().is_unexplained = true;
    }
  }
  // A symmetric orbit loses all its impacts at once. With the others as impacts without speed, the
  // equations would be singular.
  if (without_speed.size() > 1) {
    const size_t k = without_speed.front();
    add(BranchPoint::graze, Extra::contact, k, a.items[k].speed, b.items[k].speed);
    make_touches(problem, ends.back(), without_speed);
  }
  for (const Minimum &least : b.minima) {
    if (!(least.value < 0.0)) continue;
    const std::optional<double> part = zero_part(value_before(least, a.minima), least.value);
    const BranchPoint kind = least.is_press ? BranchPoint::multi_sliding : BranchPoint::graze;
    ends.push_back(end_on_the_way(kind, Extra::contact, 0, from, to, part));
    const double flight = std::max(ends.back().u(problem.time_at(least.flight)), 0.0);
    const Happening what = least.after_event ? Happening::pause
                           : least.is_press  ? Happening::dip
                                             : Happening::touch;
    add_item(problem, ends.back(), least.flight, std::clamp(least.offset, 0.0, flight),
             {what, least.stop});
  }
  return ends;
}

std::vector<End> border_ends(const Problem &problem, const Place &from) {
  const Sequence &s = from.sequence;
  const Vector &u = from.u;
  const Model model(problem.scene, problem.parameter, u(0));
  std::vector<End> ends;
  for (size_t k = 1; k < s.items.size(); ++k) {
    if (s.items[k].what != Happening::hold) continue;
    const ModelStop &stop = model.stop(s.items[k].stop);
    if (!(stop.law.at_rest() > 0.0)) continue;
    auto [left, slope] = to_release(problem, model, s, u, from.seen, k);
    if (!(slope > 0.0)) continue;
    const double c = border_constant(stop.ratio_at_rest()).value;
    // Back through the impacts of the chatter, to where they are about self-similar: the part is 1.
    std::vector<size_t> own;  // from the last impact on
    std::vector<double> parts;
    for (size_t j = k;; --j) {
      const Item &item = s.items[j];
      if (item.what != Happening::start && problem.mass_of(item) == stop.mass) {
        if (item.stop != s.items[k].stop || !hits(item.what)) break;
        own.push_back(j);
        parts.push_back(rebound(stop, from.seen.items[j].speed).speed / (slope * left * left) / c);
      }
      if (j == 1) break;
      left += u(problem.time_at(j - 1));
    }
    // Newton's method finds the orbit from afar at an early impact. More impacts follow later.
    size_t tried = own.size();
    for (const double least : {0.7, 0.3, 0.1, 0.02}) {
      const auto enough = std::ranges::find_if(parts, [least](double p) { return p > least; });
      const size_t at = std::min(static_cast<size_t>(enough - parts.begin()), own.size() - 1);
      if (at == tried) continue;
      tried = at;
      End end = end_of(BranchPoint::border_orbit, Extra::border, own[at], s, u);
      end.guess = Guess::nearby;
      end.group = k;
      for (size_t j = 0; j < at; ++j) {
        end.u = joined(problem, end.u, own[j]);
        end.sequence.items.erase(end.sequence.items.begin() + static_cast<Difference>(own[j]));
      }
      end.sequence.items[own[at]].what = Happening::hold;
      ends.push_back(std::move(end));
    }
  }
  return ends;
}

namespace {

// The items of an excursion from a release to the hold at the same stop; empty if the mass does
// something else.
std::vector<size_t> excursion_from(const Problem &problem, const Sequence &s, size_t release) {
  std::vector<size_t> own = {release};
  for (size_t j = 1; j < s.items.size(); ++j) {
    const size_t at = (release + j) % s.items.size();
    if (problem.mass_of(s.items[at]) != problem.mass_of(s.items[release])) continue;
    if (s.items[at].stop != s.items[release].stop || !hits(s.items[at].what)) return {};
    own.push_back(at);
    if (s.items[at].what == Happening::hold) return own;
  }
  return {};
}

// The orbit without an excursion: its release becomes a dip of the press.
End closed_excursion(const Problem &problem, const Sequence &s, const Vector &u,
                     std::vector<size_t> own) {
  const size_t count = s.items.size();
  End end = end_of(BranchPoint::multi_sliding, Extra::contact, 0, s, u);
  end.part = 1.0;
  end.guess = Guess::collapse;
  size_t first = 0;  // an item to start from that stays
  while (std::ranges::find(own, first) != own.end()) ++first;
  rotate(problem, end.sequence, end.u, first);
  for (size_t &item : own) item = (item + count - first) % count;
  const size_t release = own.front();
  std::ranges::sort(own);
  size_t at = release;
  for (const size_t item : own)
    if (item < release) --at;
  for (size_t j = own.size(); j-- > 0;) {
    if (own[j] == release) continue;
    end.u = joined(problem, end.u, own[j]);
    end.sequence.items.erase(end.sequence.items.begin() + static_cast<Difference>(own[j]));
  }
  const Item dip{Happening::dip, end.sequence.items[at].stop};
  end.sequence.items[at] = dip;
  end.condition.item = at;
  const size_t mass = problem.mass_of(dip);
  const bool leaves = std::ranges::any_of(end.sequence.items, [&](const Item &item) {
    return item.what == Happening::hold && problem.mass_of(item) == mass;
  });
  if (!leaves) end.sequence.always_held[mass] = dip.stop;
  return end;
}

}  // namespace

std::vector<End> collapses_between(const Problem &problem, const Sequence &s, const Vector &from,
                                   const Vector &to) {
  std::vector<End> ends;
  for (size_t k = 0; k < s.items.size() && from.size() == to.size(); ++k) {
    if (s.items[k].what != Happening::release) continue;
    const std::vector<size_t> own = excursion_from(problem, s, k);
    if (own.empty() || own.size() == s.items.size()) continue;
    double before = 0.0, after = 0.0;  // its length
    for (size_t j = k; j != own.back(); j = (j + 1) % s.items.size()) {
      before += from(problem.time_at(j));
      after += to(problem.time_at(j));
    }
    if (!(after < 0.95 * before)) continue;
    ends.push_back(closed_excursion(problem, s, to, own));
    // The square of the length is linear in the parameter next to the end.
    ends.back().expected =
        to(0) + (to(0) - from(0)) * after * after / (before * before - after * after);
  }
  return ends;
}

}  // namespace vibro_impact::branches
