#include "closed_form.hpp"

#include <limits>
#include <stdexcept>
#include <utility>

namespace vibro_impact_reference {

Matrix stiffness_matrix(const Scene &scene) {
  const std::size_t n = scene.masses();
  const Vector &link = scene.stiffness;
  Matrix k(n, Vector(n));
  for (std::size_t i = 0; i < n; ++i) {
    k[i][i] += link[i] + scene.ground[i];
    if (i == 0) continue;
    k[i - 1][i - 1] += link[i];
    k[i - 1][i] -= link[i];
    k[i][i - 1] -= link[i];
  }
  return k;
}

namespace {

/// Cyclic Jacobi rotations, until what is off the diagonal is below rounding.
Eigensystem jacobi_eigensystem(Matrix a) {
  const std::size_t n = a.size();
  Matrix v(n, Vector(n));
  for (std::size_t i = 0; i < n; ++i) v[i][i] = 1;
  const Real epsilon = std::numeric_limits<Real>::epsilon();
  for (int sweep = 0; sweep < 100; ++sweep) {
    bool diagonal = true;
    for (std::size_t p = 0; p + 1 < n; ++p) {
      for (std::size_t q = p + 1; q < n; ++q) {
        if (abs(a[p][q]) <= epsilon * epsilon * (abs(a[p][p]) + abs(a[q][q]))) continue;
        diagonal = false;
        const Real theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
        const Real t = (theta < 0 ? -1 : 1) / (abs(theta) + sqrt(theta * theta + 1));
        const Real c = 1 / sqrt(t * t + 1);
        const Real s = t * c;
        const auto rotate = [&](Real &x, Real &y) {
          const Real before = x;
          x = c * before - s * y;
          y = s * before + c * y;
        };
        for (std::size_t i = 0; i < n; ++i) rotate(a[i][p], a[i][q]);
        for (std::size_t i = 0; i < n; ++i) rotate(a[p][i], a[q][i]);
        for (std::size_t i = 0; i < n; ++i) rotate(v[i][p], v[i][q]);
        a[p][q] = 0;
        a[q][p] = 0;
      }
    }
    if (diagonal) break;
  }
  Eigensystem result{Vector(n), std::move(v)};
  for (std::size_t i = 0; i < n; ++i) result.values[i] = a[i][i];
  return result;
}

}  // namespace

Eigensystem free_eigensystem(const Scene &scene, const Matrix &k,
                             const std::vector<std::size_t> &free) {
  const Vector &m = scene.mass;
  const std::size_t size = free.size();
  Matrix scaled(size, Vector(size));
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) {
      scaled[i][j] = k[free[i]][free[j]] / sqrt(m[free[i]] * m[free[j]]);
    }
  }
  Eigensystem eigen = jacobi_eigensystem(std::move(scaled));
  for (std::size_t i = 0; i < size; ++i) {
    for (Real &entry : eigen.vectors[i]) entry /= sqrt(m[free[i]]);
  }
  return eigen;
}

Flow flow_from(const Scene &scene, const Real &t, const Vector &x, const Vector &v,
               const std::vector<bool> &resting, Eigensystems &known) {
  const std::size_t n = scene.masses();
  Flow flow{t, scene.omega, x, {}, {}, {}};
  for (std::size_t p = 0; p < n; ++p) {
    if (!resting[p]) flow.free.push_back(p);
  }
  const std::size_t size = flow.free.size();
  const Matrix k = stiffness_matrix(scene);

  // The resting neighbours act as the constant load -K_FS s_S, in addition to the constant forces.
  Vector load(size);
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t p = flow.free[i];
    load[i] = scene.constant[p];
    for (std::size_t s = 0; s < n; ++s) {
      if (resting[s]) load[i] -= k[p][s] * x[s];
    }
  }
  flow.eigen = known[resting];
  if (!flow.eigen)
    known[resting] = flow.eigen =
        std::make_shared<Eigensystem>(free_eigensystem(scene, k, flow.free));
  const Matrix &shapes = flow.eigen->vectors;

  const Real phase = scene.omega * t;
  const Real cosine = cos(phase);
  const Real sine = sin(phase);
  const Real critical = Real("1e-40");
  for (std::size_t j = 0; j < size; ++j) {
    Mode mode;
    mode.lambda = flow.eigen->values[j];
    mode.decay = scene.beta * mode.lambda / 2;
    const Real discriminant = mode.lambda - mode.decay * mode.decay;
    // Within 1e-40 of critical the two forms differ from the critical one by less than the working
    // precision.
    mode.damping = abs(discriminant) <= critical * mode.lambda ? Mode::Damping::critical
                   : discriminant > 0                          ? Mode::Damping::under
                                                               : Mode::Damping::over;
    mode.nu = sqrt(abs(discriminant));
    Real q, dq, constant;
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t p = flow.free[i];
      mode.forcing += shapes[i][j] * scene.amplitude[p];
      mode.sine_forcing += shapes[i][j] * scene.sine[p];
      constant += shapes[i][j] * load[i];
      q += shapes[i][j] * scene.mass[p] * x[p];
      dq += shapes[i][j] * scene.mass[p] * v[p];
    }
    const Real &omega = scene.omega;
    const Real detuning = mode.lambda - omega * omega;
    const Real drag = 2 * mode.decay * omega;
    const Real denominator = detuning * detuning + drag * drag;
    mode.static_value = constant / mode.lambda;
    if (denominator == 0) {
      // (tau sin(Omega t))'' + Omega^2 tau sin(Omega t) = 2 Omega cos(Omega t).
      if (mode.sine_forcing != 0) throw std::runtime_error("a sine at resonance is not solved");
      mode.secular = mode.forcing / (2 * omega);
    } else {
      mode.forced_cos = (mode.forcing * detuning - mode.sine_forcing * drag) / denominator;
      mode.forced_sin = (mode.forcing * drag + mode.sine_forcing * detuning) / denominator;
    }
    mode.u = q - mode.static_value - mode.forced_cos * cosine - mode.forced_sin * sine;
    mode.w = dq - omega * (mode.forced_sin * cosine - mode.forced_cos * sine) -
             mode.secular * sine + mode.decay * mode.u;
    flow.modes.push_back(mode);
  }
  return flow;
}

Real fastest_rate_at(const Flow &flow, const Real &tau) {
  const Real spent = 138 * std::numeric_limits<Real>::digits10 / 50;  // -log of it
  Real fastest = flow.frequency;
  for (const Mode &mode : flow.modes) {
    Real rate = sqrt(mode.lambda);
    if (2 * mode.decay > rate) rate = 2 * mode.decay;
    if (mode.damping == Mode::Damping::over && (mode.decay + mode.nu) * tau > spent)
      rate = mode.lambda / (mode.decay + mode.nu);  // of the slow decay
    if (rate > fastest) fastest = rate;
  }
  return fastest;
}

Real sampling_step(const Flow &flow, const Real &tau) {
  return 2 * acos(Real(-1)) / fastest_rate_at(flow, tau) / 128;
}

Motion motion_at(const Flow &flow, const Real &tau) {
  const std::size_t n = flow.rest_positions.size();
  Motion motion{flow.rest_positions, Vector(n), Vector(n), Vector(n), Real(), Real()};
  for (const std::size_t p : flow.free) motion.x[p] = 0;
  const Real omega = flow.frequency;
  const Real phase = omega * (flow.start_time + tau);
  motion.cosine = cos(phase);
  motion.sine = sin(phase);
  for (std::size_t j = 0; j < flow.modes.size(); ++j) {
    const Mode &mode = flow.modes[j];
    // S = sin(nu tau)/nu or its like, C = S'; S'' = -(lambda - a^2) S gives the velocity.
    Real c = 1;
    Real s = tau;
    Real bend = 0;  // C'/S
    if (mode.damping == Mode::Damping::under) {
      const Real angle = mode.nu * tau;
      c = cos(angle);
      s = sin(angle) / mode.nu;
      bend = -mode.nu * mode.nu;
    } else if (mode.damping == Mode::Damping::over) {
      const Real sh = sinh(mode.nu * tau);
      c = sqrt(1 + sh * sh);
      s = sh / mode.nu;
      bend = mode.nu * mode.nu;
    }
    Real envelope = exp(-mode.decay * tau);
    if (mode.damping == Mode::Damping::over && mode.nu * tau > 1) {
      // The two decays one by one: e^(nu tau) may not be finite.
      const Real slow = exp(-mode.lambda / (mode.decay + mode.nu) * tau),
                 fast = exp(-(mode.decay + mode.nu) * tau);
      c = (slow + fast) / 2;
      s = (slow - fast) / (2 * mode.nu);
      envelope = 1;
    }
    const Real ringing = envelope * (mode.u * c + mode.w * s);
    const Real ringing_rate = envelope * (mode.u * bend * s + mode.w * c) - mode.decay * ringing;
    const Real q = ringing + mode.static_value + mode.forced_cos * motion.cosine +
                   mode.forced_sin * motion.sine + mode.secular * tau * motion.sine;
    const Real dq = ringing_rate +
                    omega * (mode.forced_sin * motion.cosine - mode.forced_cos * motion.sine) +
                    mode.secular * (motion.sine + omega * tau * motion.cosine);
    // Higher derivatives from the equation of motion itself.
    const Real ddq = mode.forcing * motion.cosine + mode.sine_forcing * motion.sine -
                     2 * mode.decay * dq - mode.lambda * (q - mode.static_value);
    const Real dddq = omega * (mode.sine_forcing * motion.cosine - mode.forcing * motion.sine) -
                      2 * mode.decay * ddq - mode.lambda * dq;
    for (std::size_t i = 0; i < flow.free.size(); ++i) {
      const std::size_t p = flow.free[i];
      motion.x[p] += flow.eigen->vectors[i][j] * q;
      motion.v[p] += flow.eigen->vectors[i][j] * dq;
      motion.a[p] += flow.eigen->vectors[i][j] * ddq;
      motion.jerk[p] += flow.eigen->vectors[i][j] * dddq;
    }
  }
  return motion;
}

}  // namespace vibro_impact_reference
