#include "placement.hpp"

#include <algorithm>
#include <cmath>

#include "tolerances.hpp"

namespace vibro_impact::detail {

namespace {

// Adds factor a_j to y_j + low_j.
void add(double factor, const PerCoordinate &a, PerCoordinate &y, PerCoordinate &low) {
  for (Eigen::Index j = 0; j < y.size(); j += 2)
    store(twofold(y, low, j) + factor * pair(a.data() + j), y, low, j);
}

// Changes the coordinates so that (3) gives this gap, up to rounding, and this gap speed, up to the
// rounding of its jump. Returns the jump.
double change(const Contact &contact, const Gap &gap, const PerCoordinate &displacement,
              const SpeedChange &by, Motion &motion) {
  const Gap before = gap_at(contact, motion);
  const double jump = gap.speed - before.speed;
  add(gap.value - before.value, displacement, motion.y, motion.y_low);
  add(jump, by.slope, motion.dy, motion.dy_low);
  if (by.value.size() > 0) add(jump, by.value, motion.y, motion.y_low);
  complete_change(motion);
  return jump;
}

}  // namespace

void hit(const Contact &contact, double speed, Motion &motion) {
  const Gap gap{0.0, speed};
  const double jump = change(contact, gap, contact.placement, contact.impulse, motion);
  // A speed far below the jump gets its digits from a second one.
  if (std::abs(speed) < resolved_ratio * std::abs(jump))
    change(contact, gap, contact.placement, contact.impulse, motion);
}

void place(const Contact &contact, const Gap &gap, Motion &motion) {
  change(contact, gap, contact.placement, contact.drift, motion);
}

void Placement::clear() {
  size_ = 0;
}

void Placement::add(const Contact &contact, const Gap &gap) {
  if (size_ == parts_.size()) parts_.emplace_back();
  parts_[size_].contact = &contact;
  parts_[size_++].gap = gap;
}

// Takes from the changes of a part what they do to the gap of one before it.
void Placement::keep(const Part &before, Part &part) {
  const double factor = dot(before.contact->row, part.displacement);
  part.displacement -= factor * before.displacement;
  part.drift.slope -= factor * before.drift.slope;
  part.drift.value -= factor * before.drift.value;
}

void Placement::apply(Motion &motion) {
  const auto end = parts_.begin() + static_cast<std::ptrdiff_t>(size_);
  std::sort(parts_.begin(), end,
            [](const Part &a, const Part &b) { return a.gap.value < b.gap.value; });
  for (auto part = parts_.begin(); part != end; ++part) {
    part->displacement = part->contact->placement;
    part->drift = part->contact->drift;
    for (auto before = parts_.begin(); before != part; ++before)
      if (!before->moves_along) keep(*before, *part);
    const double widening = dot(part->contact->row, part->displacement);
    part->moves_along = widening < resolved_ratio;
    if (part->moves_along) continue;
    for (PerCoordinate *change : {&part->displacement, &part->drift.slope, &part->drift.value})
      *change /= widening;
    change(*part->contact, part->gap, part->displacement, part->drift, motion);
  }
}

}  // namespace vibro_impact::detail
