#include "one_impact.hpp"

namespace vibro_impact_reference {

std::vector<OneImpactCase> one_impact_cases() {
  const auto chain = [](int masses, double beta, double amplitude, double omega, double r,
                        double stop) {
    auto scene = vibro_impact::extremes::chain(masses, beta);
    scene.amplitude.assign(scene.mass.size(), 0.0);
    scene.amplitude.front() = amplitude;
    scene.omega = omega;
    scene.restitution = r;
    scene.stops = {{masses, Side::upper, stop}};
    return scene;
  };
  auto three = chain(3, 0.1, 0.5, 1.1, 0.7, 0.6);
  three.mass = {1.0, 2.0, 0.5};
  three.stiffness = {1.0, 3.0, 2.0};
  three.stops[0].mass = 2;
  std::vector<OneImpactCase> cases;
  for (const auto &[branch, name] : {std::pair{1, "_faster"}, {-1, "_slower"}, {0, "_fold"}}) {
    cases.push_back(
        {std::string("figure3") + name, vibro_impact::paper::figure3(2.4), 3, branch, 1});
    cases.push_back({std::string("two") + name, chain(2, 0.1, 0.5, 0.9, 0.7, 1.1), 1, branch});
    cases.push_back({std::string("three") + name, three, 2, branch});
    cases.push_back({std::string("five") + name, chain(5, 0.1, 0.5, 0.7, 0.7, 1.27), 2, branch});
  }
  for (const auto &[masses, omega] : {std::pair{2, 0.95}, {3, 0.7}, {5, 0.51}})
    cases.push_back({"free_" + std::to_string(masses), chain(masses, 0, 0, omega, 1, 1), 1, 0});
  return cases;
}

OneImpactOrbit one_impact_orbit(const OneImpactCase &given) {
  const Scene scene = in_digits(given.scene, 0.0);
  const std::size_t n = scene.masses(), hit = scene.stops[given.stop].mass;
  const Real two_pi = 2 * acos(Real(-1)), omega = scene[&Field::omega],
             r = scene.stops[given.stop].restitution;
  const Real period = two_pi * given.periods / omega, m = scene[&Field::mass][hit];
  Eigensystems known;
  const Flow flow = flow_from(scene, 0, Vector(n), Vector(n), std::vector<bool>(n), known);
  const Matrix &shapes = flow.eigen->vectors;
  Vector c(n), s(n), kick(n), kick_rate(n);  // c, s: damped cosine and sine / nu over the period
  Real g, b, x_cos, x_sin;                   // X = x_cos - i x_sin
  for (std::size_t j = 0; j < n; ++j) {
    const Mode &mode = flow.modes[j];
    const Real envelope = exp(-mode.decay * period), w = shapes[hit][j];
    c[j] = envelope * cos(mode.nu * period);
    s[j] = envelope * sin(mode.nu * period) / mode.nu;
    kick[j] = w * s[j] / (1 - 2 * c[j] + envelope * envelope);
    kick_rate[j] = w * (1 - c[j] - mode.decay * s[j]) / (1 - 2 * c[j] + envelope * envelope);
    g += w * kick[j];
    b += w * kick_rate[j];
    x_cos += w * mode.forced_cos;
    x_sin += w * mode.forced_sin;
  }

  const Real h = (b - r / (m * (1 + r))) / omega, square = x_cos * x_cos + x_sin * x_sin;
  Real d = scene.stops[given.stop].position, root = 0;
  if (given.branch == 0 && square > 0) d = sqrt(square * (1 + g * g / (h * h)));
  if (given.branch != 0) root = given.branch * sqrt(square * (g * g + h * h) - h * h * d * d);
  const Real p = (d * g - root) / (g * g + h * h), velocity = -p / (m * (1 + r));
  Real angle = 0;  // Omega t; any without forcing
  if (square > 0) angle = atan2(p * h, d - p * g) + atan2(x_sin, x_cos);
  if (angle < 0) angle += two_pi;

  // A displacement xi before the impact delays it by -xi / v. The derivative of the return map is
  // the transition of the modes, then the impact law and this delay.
  OneImpactOrbit orbit{d, angle / omega, velocity, 0, Vector(n), Vector(n)};
  Real acceleration, by_delay;  // of the mass before the impact; its share in the trace
  for (std::size_t j = 0; j < n; ++j) {
    const Mode &mode = flow.modes[j];
    const Real w = shapes[hit][j], jump = (1 + r) * m * w * w;
    const Real q = p * kick[j] + mode.forced_cos * cos(angle) + mode.forced_sin * sin(angle);
    const Real dq =
        p * kick_rate[j] + omega * (mode.forced_sin * cos(angle) - mode.forced_cos * sin(angle));
    for (std::size_t i = 0; i < n; ++i) {
      orbit.x[i] += shapes[i][j] * q;
      orbit.v[i] += shapes[i][j] * dq;
    }
    acceleration +=
        w * (mode.forcing * cos(angle) - 2 * mode.decay * (dq - p * w) - mode.lambda * q);
    by_delay += jump * s[j];
    orbit.trace += 2 * (c[j] * (1 - jump) + mode.decay * jump * s[j]);
  }
  orbit.trace += by_delay * acceleration / velocity;
  return orbit;
}

std::string one_impact_table() {
  std::string table = "orbit,stop,time,velocity_before,trace,x1.. v1..\n";
  for (const auto &given : one_impact_cases()) {
    const auto [stop, time, velocity, trace, x, v] = one_impact_orbit(given);
    table += given.name;
    for (const Vector &numbers : {Vector{stop, time, velocity, trace}, x, v})
      for (const Real &number : numbers)
        (table += ',') += (abs(number) < Real("1e-40") ? Real(0) : number).str(30, std::ios::fixed);
    table += '\n';
  }
  return table;
}

}  // namespace vibro_impact_reference
