// The plain event-driven scheme: closed-form solution of each contact mode, sampled for gaps that
// have closed and hold forces that have turned, a root between two samples, sticking below a
// speed threshold. The threshold is swept; the sampling is fine enough not to matter.
//
// The natural modes are the library's, found once per contact mode. The closed form gives a gap as
// s - x, which has the rounding of x. With a threshold near 1e-8 or below, the flights of a chatter
// are smaller than this rounding.
#include <complex>
#include <map>
#include <stdexcept>

#include "event_loop.hpp"
#include "vibro_impact/analysis/natural_modes.hpp"

namespace vibro_impact::comparison {

namespace {

using Complex = std::complex<double>;

// A hundredth of a cycle of the fastest mode (w = 1.618); the samples behind an impact begin with
// an eighth of the flight ahead and grow by two.
constexpr double longest_sample = 0.04;
constexpr double samples_per_flight = 8.0;

// The closed form of one contact mode (Eqs. 7, 21 and 24). The motion about the place of rest is
// the sum of the underdamped modes, each the real part of a multiple of e^(exponent tau), and of
// the steady response to the forcing, the real part of steady e^(i Omega t).
struct ClosedForm {
  struct Mode {
    std::array<double, 2> shape;
    Complex exponent;
  };
  std::array<double, 2> equilibrium = {};  // of the masses
  std::array<Complex, 2> steady = {};
  std::vector<Mode> modes = {};
};

// Throws std::invalid_argument for a mode that is not underdamped.
ClosedForm closed_form(const Scene &scene, const std::array<bool, 2> &held) {
  ClosedForm form;
  Held sides(2, 0);
  std::array<double, 2> pull{};  // of a held neighbour on a free mass
  for (std::size_t i = 0; i < 2; ++i) {
    if (!held[i]) continue;
    form.equilibrium[i] = scene.stops[i].position;
    sides[i] = static_cast<signed char>(scene.stops[i].side);
    pull[1 - i] = scene.stiffness[1] * form.equilibrium[i];
  }
  const NaturalModes natural = natural_modes(scene, sides);
  for (std::size_t j = 0; j < natural.lambda.size(); ++j) {
    const double lambda = natural.lambda[j], decay = scene.beta * lambda / 2;
    if (!(decay * decay < lambda))
      throw std::invalid_argument("plain event-driven: a mode is not underdamped");
    const std::array<double, 2> shape{natural.shape(0, j), natural.shape(1, j)};
    double force = 0.0, constant = 0.0;
    for (std::size_t i = 0; i < 2; ++i) {
      if (!scene.amplitude.empty()) force += shape[i] * scene.amplitude[i];
      constant += shape[i] * pull[i];
    }
    const Complex response =
        force / Complex(lambda - scene.omega * scene.omega, 2 * decay * scene.omega);
    for (std::size_t i = 0; i < 2; ++i) {
      form.equilibrium[i] += shape[i] * constant / lambda;
      form.steady[i] += shape[i] * response;
    }
    form.modes.push_back({shape, {-decay, std::sqrt(lambda - decay * decay)}});
  }
  return form;
}

// The samples of the motion from one event to the next.
struct Samples {
  const Scene &scene;
  System system;
  const TwoMasses &chain = system.chain;
  const GapState &now = system.now;
  std::map<std::array<bool, 2>, ClosedForm> forms = {};  // of the contact modes met
  const ClosedForm *form = nullptr;
  double time = 0.0, step = 0.0;
  std::array<Complex, 2> factor = {};  // of the modes

  void restart(double longest_first) {
    auto known = forms.find(now.held);
    if (known == forms.end()) known = forms.emplace(now.held, closed_form(scene, now.held)).first;
    form = &known->second;
    time = 0.0;
    step = std::min(longest_sample, longest_first / samples_per_flight);
    const Complex turn = std::polar(1.0, chain.omega * now.time);
    for (std::size_t j = 0; j < form->modes.size(); ++j) {
      const auto &[shape, exponent] = form->modes[j];
      double q = 0.0, rate = 0.0;  // of the free motion in this mode
      for (std::size_t i = 0; i < 2; ++i) {
        const Complex steady = form->steady[i] * turn;
        const double x =
            chain.stop[i] - chain.side[i] * now.y[2 * i] - form->equilibrium[i] - steady.real();
        const double v = chain.omega * steady.imag() - chain.side[i] * now.y[2 * i + 1];
        q += shape[i] * scene.mass[i] * x;
        rate += shape[i] * scene.mass[i] * v;
      }
      // Re factor = q and Re (exponent factor) = rate.
      factor[j] = {q, (exponent.real() * q - rate) / exponent.imag()};
    }
  }

  std::pair<double, double> next() {
    const double from = time;
    time += step;
    step = std::min(2.0 * step, longest_sample);
    return {from, time};
  }

  Vec at(double tau) {
    const Complex turn = std::polar(1.0, chain.omega * (now.time + tau));
    std::array<double, 2> x{}, v{};
    for (std::size_t j = 0; j < form->modes.size(); ++j) {
      const auto &[shape, exponent] = form->modes[j];
      const Complex q = factor[j] * std::exp(exponent * tau), rate = exponent * q;
      for (std::size_t i = 0; i < 2; ++i) {
        x[i] += shape[i] * q.real();
        v[i] += shape[i] * rate.real();
      }
    }
    Vec y{};
    for (std::size_t i = 0; i < 2; ++i) {
      if (now.held[i]) continue;
      const Complex steady = form->steady[i] * turn;
      y[2 * i] = chain.side[i] * (chain.stop[i] - x[i] - form->equilibrium[i] - steady.real());
      y[2 * i + 1] = -chain.side[i] * (v[i] - chain.omega * steady.imag());
    }
    return y;
  }
};

Result plain_scheme(const Problem &problem, double threshold) {
  return with_events(problem, threshold, [&](const System &system) {
    return Samples{problem.scene, system};
  });
}

}  // namespace

std::vector<Method> plain_event_driven() {
  return {{"plain event-driven", {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9}, plain_scheme}};
}

}  // namespace vibro_impact::comparison
