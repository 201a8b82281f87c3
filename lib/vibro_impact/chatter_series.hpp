// What is left of a chatter, as a series in the flight that follows to leading order.
//
// After an impact the gap is v t + c2 t^2 + c3 t^3 + ..., and t + s2 t^2 + s3 t^3 + ... what a unit
// jump of its speed adds to it. With x = -v / c2 and e, f, h = c3, c4, c5 / c2, the time left to
// the limit is
//   T = x / (1 - r) + a2 x^2 + a3 x^3 + a4 x^4 + O(x^5),
// a2, a3, a4 of weight 1, 2, 3 in (e; f; h; s2; s3; s4), of weights 1, 2, 3, 1, 2, 3. They follow
// order by order from that T is the flight to the next impact and what is left after that. So do
// the moments of the later impacts,
//   sum_k J_k (T - t_k)^n = J T^n r^(n + 1) / (1 - r^(n + 1)) (1 + b1 T + b2 T^2 + ...)
// of which the first two orders that matter are set here as well.
#pragma once

#include "polynomial.hpp"

namespace vibro_impact {

// After a unit jump of the gap speed: t + second t^2 + third t^3 + fourth t^4 + ...
struct Response {
  double second = 0.0, third = 0.0, fourth = 0.0;
};

// The shape of a gap after an impact: c3, c4, c5 / c2.
struct Shape {
  double e = 0.0, f = 0.0, h = 0.0;
};

// The constants of one coefficient of restitution.
struct RestitutionSeries {
  double restitution = -1.0, flights = 0.0;  // all those to come in terms of the next: 1 / (1 - r)
  std::array<double, 5> third{};             // of e^2, f, s2^2, e s2, s3
  std::array<double, 10> fourth{};  // of e^3, e f, h, e^2 s2, f s2, e s2^2, s2^3, e s3, s2 s3, s4
  detail::Powers moments{};         // r^(n + 1) / (1 - r^(n + 1))

  void set(double r) {
    if (r == restitution) return;
    restitution = r;
    flights = 1.0 / (1.0 - r);
    const double r2 = r * r, r3 = r2 * r, r4 = r2 * r2, r5 = r4 * r, r6 = r3 * r3;
    third = {2.0 + 3.0 * r + 2.0 * r2, -1.0 - 2.0 * r - r2, r + r2 + r3 + r4,
             -4.0 * r - 3.0 * r2 - 3.0 * r3, r2 + r3};
    for (double &term : third) term *= flights * flights / (1.0 - r3);
    fourth = {-5.0 - 13.0 * r - 6.0 * r2 - 13.0 * r3 - 5.0 * r4,
              5.0 + 16.0 * r + 4.0 * r2 + 16.0 * r3 + 5.0 * r4,
              -1.0 - 4.0 * r - 4.0 * r3 - r4,
              18.0 * r + 9.0 * r2 + 28.0 * r3 + 15.0 * r4 + 10.0 * r5,
              -8.0 * r - 4.0 * r2 - 12.0 * r3 - 8.0 * r4 - 4.0 * r5,
              -6.0 * r - 6.0 * r2 - 12.0 * r3 - 16.0 * r4 - 6.0 * r5 - 6.0 * r6,
              r + r2 + 2.0 * r3 + 4.0 * r4 + 2.0 * r5 + r6 + r6 * r,
              -(6.0 * r2 + 4.0 * r3) * (1.0 + r2),
              3.0 * r2 + 3.0 * r3 + 4.0 * r4 + 3.0 * r5 + 3.0 * r6,
              r3 + 2.0 * r4 + r5};
    for (double &term : fourth) term *= flights * flights * flights / ((1.0 - r3) * (1.0 + r2));
    double power = r;
    for (double &moment : moments) {
      moment = power / (1.0 - power);
      power *= r;
    }
  }
};

// The series for one response: polynomials in the shape of the gap.
struct ChatterSeries {
  RestitutionSeries of;
  Response response;
  double third_e = 0.0, third_1 = 0.0, fourth_ee = 0.0, fourth_e = 0.0, fourth_f = 0.0,
         fourth_1 = 0.0;

  void set(double restitution, const Response &to_jump) {
    of.set(restitution);
    response = to_jump;
    const auto [s2, s3, s4] = response;
    third_e = of.third[3] * s2;
    third_1 = of.third[2] * s2 * s2 + of.third[4] * s3;
    fourth_ee = of.fourth[3] * s2;
    fourth_e = of.fourth[5] * s2 * s2 + of.fourth[7] * s3;
    fourth_f = of.fourth[4] * s2;
    fourth_1 = s2 * (of.fourth[6] * s2 * s2 + of.fourth[8] * s3) + of.fourth[9] * s4;
  }

  // a3 x + a4 x^2
  double higher_orders(double x, const Shape &shape) const {
    const auto [e, f, h] = shape;
    const double third = e * (of.third[0] * e + third_e) + of.third[1] * f + third_1;
    const double fourth = e * (e * (of.fourth[0] * e + fourth_ee) + of.fourth[1] * f + fourth_e) +
                          of.fourth[2] * h + fourth_f * f + fourth_1;
    return x * (third + x * fourth);
  }

  // b1 T + b2 T^2 of the moment of order one, b1 T of that of order two.
  std::array<double, 2> rise_of_moments(double time_left, const Shape &shape) const {
    const auto [e, f, h] = shape;
    const double r = of.restitution, s2 = response.second, rr = 1.0 + r * r;
    const double bend =
        e * e - f + (s2 * ((1.0 - r) * (1.0 - r) * s2 - (rr - r) * e) + r * response.third) / rr;
    return {time_left * (s2 + time_left * bend) / (rr + r),
            time_left * (2.0 * s2 - e) / ((1.0 + r) * rr)};
  }
};

}  // namespace vibro_impact
