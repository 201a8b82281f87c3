// Long flights without events, which are flown in closed form. A scene with stops within reach does
// without.
#pragma once

#include "simulation/chain/steady_response.hpp"

namespace vibro_impact::detail {

// A time during which no contact can come to zero. The amplitudes of the coordinates about their
// steady responses never grow and bound (3) for all times; the rigid-body mode drifts with a
// constant acceleration. The time is infinite when no event can follow. It is 0 where a response
// near resonance is far larger than the motion: the deviation from it would cancel digits.
double quiet_time(const Motion &motion, const std::vector<StopState> &stops, double omega);

}  // namespace vibro_impact::detail
