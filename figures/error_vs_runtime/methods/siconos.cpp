// The chain of two masses in Siconos, by its time stepping: a LagrangianLinearTIDS with the forcing
// as external force, and one NewtonImpactNSL on the gap of each mass.
#include <array>
#include <cmath>
#include <memory>

// The headers of Siconos instantiate uBLAS of Boost 1.74 for this pointer. uBLAS calls `construct`
// and `destroy`, which the allocator of C++20 no longer has.
class NonSmoothLaw;
template <>
struct std::allocator<std::shared_ptr<NonSmoothLaw>> {
  using value_type = std::shared_ptr<NonSmoothLaw>;
  using pointer = value_type *;
  using const_pointer = const value_type *;
  using size_type = std::size_t;
  using difference_type = std::ptrdiff_t;

  pointer allocate(size_type n) {
    return static_cast<pointer>(::operator new(n * sizeof(value_type)));
  }
  void deallocate(pointer at, size_type) {
    ::operator delete(at);
  }
  template <class... Arguments>
  void construct(pointer at, Arguments &&...arguments) {
    std::construct_at(at, std::forward<Arguments>(arguments)...);
  }
  void destroy(pointer at) {
    std::destroy_at(at);
  }
};

#include <SiconosKernel.hpp>

#include "two_masses.hpp"

namespace vibro_impact::comparison {

namespace {

struct SiconosModel {
  SP::LagrangianLinearTIDS chain;
  std::array<SP::Interaction, 2> contact;
  SP::NonSmoothDynamicalSystem system;
};

// The external force as Siconos calls it; z holds A_1, A_2, Omega.
void forcing(double time, unsigned int size, double *force, unsigned int, double *z) {
  for (unsigned int i = 0; i < size; ++i) force[i] = z[i] * std::cos(z[2] * time);
}

SiconosModel siconos_model(const Problem &problem) {
  const Scene &scene = problem.scene;
  require_two_masses(scene);
  auto position = std::make_shared<SiconosVector>(2), velocity = std::make_shared<SiconosVector>(2);
  auto mass = std::make_shared<SimpleMatrix>(2, 2),
       stiffness = std::make_shared<SimpleMatrix>(2, 2),
       damping = std::make_shared<SimpleMatrix>(2, 2);
  mass->zero();
  const double k[2][2] = {{scene.stiffness[0] + scene.stiffness[1], -scene.stiffness[1]},
                          {-scene.stiffness[1], scene.stiffness[1]}};
  for (unsigned int i = 0; i < 2; ++i) {
    position->setValue(i, problem.start.displacement[i]);
    velocity->setValue(i, problem.start.velocity[i]);
    mass->setValue(i, i, scene.mass[i]);
    for (unsigned int j = 0; j < 2; ++j) {
      stiffness->setValue(i, j, k[i][j]);
      damping->setValue(i, j, scene.beta * k[i][j]);
    }
  }
  SiconosModel model;
  model.chain =
      std::make_shared<LagrangianLinearTIDS>(position, velocity, mass, stiffness, damping);
  auto amplitudes = std::make_shared<SiconosVector>(3);
  for (unsigned int i = 0; i < 2; ++i) amplitudes->setValue(i, scene.amplitude[i]);
  amplitudes->setValue(2, scene.omega);
  model.chain->setzPtr(amplitudes);
  model.chain->setComputeFExtFunction(&forcing);

  model.system = std::make_shared<NonSmoothDynamicalSystem>(problem.start.time, problem.until);
  model.system->insertDynamicalSystem(model.chain);
  for (unsigned int i = 0; i < 2; ++i) {
    // gap = side (s - x) = H x + b
    const double side = sign(scene.stops[i].side);
    auto direction = std::make_shared<SimpleMatrix>(1, 2);
    direction->zero();
    direction->setValue(0, i, -side);
    auto offset = std::make_shared<SiconosVector>(1);
    offset->setValue(0, side * scene.stops[i].position);
    model.contact[i] =
        std::make_shared<Interaction>(std::make_shared<NewtonImpactNSL>(scene.restitution),
                                      std::make_shared<LagrangianLinearTIR>(direction, offset));
    model.system->link(model.contact[i], model.chain);
  }
  return model;
}

// Shorter runs of steps with an impulse are impacts that took more than one step.
constexpr int steps_of_a_stick = 8;

// Moreau-Jean time stepping: theta = 1/2 (no numerical damping), and in each step one LCP for the
// impulses of the active contacts, by Lemke's algorithm. The scheme has no events; the impulses
// give them. A step with an impulse behind a step without one is an impact. A run of steps with an
// impulse in each is a contact: its first step is the stick, and the step behind its last one the
// release.
Result time_stepping(const Problem &problem, double step) {
  const SiconosModel model = siconos_model(problem);
  const auto steps = static_cast<long long>(std::ceil((problem.until - problem.start.time) / step));
  const double h = (problem.until - problem.start.time) / static_cast<double>(steps);
  auto discretisation = std::make_shared<TimeDiscretisation>(problem.start.time, h);
  auto integrator = std::make_shared<MoreauJeanOSI>(0.5);
  auto impulses = std::make_shared<LCP>();
  const auto simulation =
      std::make_shared<TimeStepping>(model.system, discretisation, integrator, impulses);
  // A contact at rest stays one when its gap speed comes out as a rounding above zero.
  integrator->setConstraintActivationThreshold(1e-10);

  Result result;
  std::array<int, 2> in_contact{};  // steps in a row with an impulse
  for (std::size_t i = 0; i < 2; ++i)
    if (problem.start.held[i]) in_contact[i] = steps_of_a_stick;
  for (long long n = 1; n <= steps; ++n) {
    simulation->computeOneStep();
    const double time = problem.start.time + h * static_cast<double>(n);
    for (std::size_t i = 0; i < 2; ++i) {
      const int mass = static_cast<int>(i) + 1;
      if ((*model.contact[i]->lambda(1))(0) > 0.0) {
        if (++in_contact[i] == 1) {
          // The impulse of the step from time - h to time stands for one at its middle.
          result.events.push_back(event_at(time - 0.5 * h, mass, EventKind::impact));
          ++result.impacts;
        } else if (in_contact[i] == steps_of_a_stick) {
          result.events.push_back(
              event_at(time - (steps_of_a_stick - 0.5) * h, mass, EventKind::stick));
        }
      } else {
        if (in_contact[i] >= steps_of_a_stick)
          result.events.push_back(event_at(time - 0.5 * h, mass, EventKind::release));
        in_contact[i] = 0;
      }
    }
    simulation->nextStep();
  }
  result.work = steps;
  const auto &q = *model.chain->q(), &v = *model.chain->velocity();
  result.end = {problem.until, {q(0), q(1)}, {v(0), v(1)}, {}};
  return result;
}

}  // namespace

std::vector<Method> siconos() {
  return {{"Siconos Moreau-Jean", {2e-2, 1e-2, 5e-3, 2e-3}, time_stepping}};
}

}  // namespace vibro_impact::comparison
