// The plain event-driven scheme: closed-form solution of each contact mode, sampled for gaps that
// have closed and hold forces that have turned, bisection between two samples, sticking below a
// speed threshold. What is swept is the threshold; the sampling is fine enough not to matter.
//
// The natural modes are the library's, found once per contact mode. Gaps are read off the closed
// form as s - x, where nothing smaller than the rounding of x can be seen: with a threshold near
// 1e-8 or below a chatter is lost in it.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <vector>

#include "two_masses.hpp"
#include "vibro_impact/analysis/hold_force.hpp"

namespace vibro_impact::comparison {

namespace {

// A hundredth of a cycle of the fastest mode (w = 1.618); the samples behind an impact begin with
// an eighth of the flight ahead and grow by two.
constexpr double longest_sample = 0.04;
constexpr double samples_per_flight = 8.0;

// The closed form of one contact mode (Eqs. 7, 21 and 24): underdamped modes about the place of
// rest and the steady response to the forcing.
struct ClosedForm {
  struct Mode {
    std::array<double, 2> shape;
    double decay, frequency;
  };
  std::array<double, 2> rest = {}, in_phase = {}, quadrature = {};  // of the masses
  std::vector<Mode> modes = {};
};

// Throws std::invalid_argument for a mode that is not underdamped.
ClosedForm closed_form(const Scene &scene, const std::array<bool, 2> &held) {
  ClosedForm form;
  Held sides(2, 0);
  std::array<double, 2> pull{};  // of a held neighbour on a free mass
  for (std::size_t i = 0; i < 2; ++i) {
    if (!held[i]) continue;
    form.rest[i] = scene.stops[i].position;
    sides[i] = static_cast<signed char>(scene.stops[i].side);
    pull[1 - i] = scene.stiffness[1] * form.rest[i];
  }
  const NaturalModes natural = natural_modes(scene, sides);
  for (std::size_t j = 0; j < natural.lambda.size(); ++j) {
    const double lambda = natural.lambda[j], decay = scene.beta * lambda / 2;
    if (!(decay * decay < lambda))
      throw std::invalid_argument("plain event-driven: a mode is not underdamped");
    const ClosedForm::Mode mode{
        {natural.shape(0, j), natural.shape(1, j)}, decay, std::sqrt(lambda - decay * decay)};
    double force = 0.0, constant = 0.0;
    for (std::size_t i = 0; i < 2; ++i) {
      if (!scene.amplitude.empty()) force += mode.shape[i] * scene.amplitude[i];
      constant += mode.shape[i] * pull[i];
    }
    const double detuning = lambda - scene.omega * scene.omega, loss = 2 * decay * scene.omega;
    const double squared = detuning * detuning + loss * loss;
    for (std::size_t i = 0; i < 2; ++i) {
      form.rest[i] += mode.shape[i] * constant / lambda;
      form.in_phase[i] += mode.shape[i] * force * detuning / squared;
      form.quadrature[i] += mode.shape[i] * force * loss / squared;
    }
    form.modes.push_back(mode);
  }
  return form;
}

// Gaps and gap speeds at one time, read off the closed form.
struct Sample {
  Vec y;
  std::array<bool, 2> due;  // the gap has closed or the hold force turned
};

// The free motion from one event to the next.
struct Stretch {
  const TwoMasses &chain;
  const ClosedForm &form;
  std::array<bool, 2> held;
  std::array<double, 2> a = {}, b = {};  // per mode: of the cosine and the sine
  double cosine, sine;                   // of the forcing at the start
  long long *evaluations;

  Stretch(const Scene &scene, const TwoMasses &chain_of_it, const ClosedForm &form_of_it,
          const GapState &now, long long *evaluations_of_it)
      : chain(chain_of_it),
        form(form_of_it),
        held(now.held),
        cosine(std::cos(chain.omega * now.time)),
        sine(std::sin(chain.omega * now.time)),
        evaluations(evaluations_of_it) {
    const TwoMassState state = physical_state(chain, now);
    for (std::size_t j = 0; j < form.modes.size(); ++j) {
      const auto &[shape, decay, frequency] = form.modes[j];
      double rate = 0.0;
      for (std::size_t i = 0; i < 2; ++i) {
        const double steady = form.in_phase[i] * cosine + form.quadrature[i] * sine;
        const double steady_rate =
            chain.omega * (form.quadrature[i] * cosine - form.in_phase[i] * sine);
        a[j] += shape[i] * scene.mass[i] * (state.displacement[i] - form.rest[i] - steady);
        rate += shape[i] * scene.mass[i] * (state.velocity[i] - steady_rate);
      }
      b[j] = (rate + decay * a[j]) / frequency;
    }
  }

  Sample at(double tau) const {
    ++*evaluations;
    const double c = std::cos(chain.omega * tau), s = std::sin(chain.omega * tau);
    const double cos_now = cosine * c - sine * s, sin_now = sine * c + cosine * s;
    std::array<double, 2> x{}, v{};
    for (std::size_t j = 0; j < form.modes.size(); ++j) {
      const auto &[shape, decay, frequency] = form.modes[j];
      const double e = std::exp(-decay * tau);
      const double cj = e * std::cos(frequency * tau), sj = e * std::sin(frequency * tau);
      const double q = a[j] * cj + b[j] * sj;
      const double rate =
          (frequency * b[j] - decay * a[j]) * cj - (frequency * a[j] + decay * b[j]) * sj;
      for (std::size_t i = 0; i < 2; ++i) {
        x[i] += shape[i] * q;
        v[i] += shape[i] * rate;
      }
    }
    for (std::size_t i = 0; i < 2; ++i) {
      x[i] += form.rest[i] + form.in_phase[i] * cos_now + form.quadrature[i] * sin_now;
      v[i] += chain.omega * (form.quadrature[i] * cos_now - form.in_phase[i] * sin_now);
    }
    Sample sample{};
    for (std::size_t i = 0; i < 2; ++i) {
      if (held[i]) continue;
      sample.y[2 * i] = chain.side[i] * (chain.stop[i] - x[i]);
      sample.y[2 * i + 1] = -chain.side[i] * v[i];
      sample.due[i] = sample.y[2 * i] <= 0.0 && sample.y[2 * i + 1] < 0.0;
    }
    for (std::size_t i = 0; i < 2; ++i)
      if (held[i]) sample.due[i] = -chain.acceleration(i, sample.y, cos_now) <= 0.0;
    return sample;
  }
};

Result plain_scheme(const Problem &problem, double threshold) {
  const TwoMasses chain = two_masses(problem.scene);
  GapState now = gap_state(chain, problem.start);
  std::map<std::array<bool, 2>, ClosedForm> forms;
  Result result;
  while (result.failure.empty()) {
    auto form = forms.find(now.held);
    if (form == forms.end())
      form = forms.emplace(now.held, closed_form(problem.scene, now.held)).first;
    const Stretch stretch(problem.scene, chain, form->second, now, &result.work);
    const double horizon = problem.until - now.time;
    double before = 0.0, after = 0.0;
    double step = std::min(longest_sample, flight_ahead(chain, now) / samples_per_flight);
    Sample sample{};
    std::size_t who = 2;
    while (who == 2 && after < horizon) {
      before = after;
      after = std::min(after + step, horizon);
      step = std::min(2.0 * step, longest_sample);
      sample = stretch.at(after);
      for (std::size_t i = 2; i-- > 0;)
        if (sample.due[i]) who = i;
    }
    if (who != 2) {  // bisect for the first instant at which anything is due
      while (true) {
        const double middle = 0.5 * (before + after);
        if (middle <= before || middle >= after || now.time + middle == now.time) break;
        const Sample at_middle = stretch.at(middle);
        const bool due = at_middle.due[0] || at_middle.due[1];
        (due ? after : before) = middle;
        if (due) sample = at_middle;
      }
      who = sample.due[0] ? 0 : 1;
    }
    now.time = who == 2 ? problem.until : now.time + after;
    now.y = sample.y;
    if (who == 2) break;
    happen(chain, now, who, threshold, result);
  }
  result.end = physical_state(chain, now);
  return result;
}

}  // namespace

std::vector<Method> plain_event_driven() {
  return {{"plain event-driven",
           "speed threshold",
           "closed-form evaluations",
           {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9},
           plain_scheme}};
}

}  // namespace vibro_impact::comparison
