// The chain of two masses in Siconos: a LagrangianLinearTIDS with the forcing as external force,
// and one NewtonImpactNSL on the gap of each mass.
#pragma once

#include <SiconosKernel.hpp>
#include <array>
#include <boost/exception/diagnostic_information.hpp>
#include <cmath>
#include <iostream>
#include <sstream>
#include <string>

#include "two_masses.hpp"

namespace vibro_impact::comparison {

struct SiconosModel {
  SP::LagrangianLinearTIDS chain;
  std::array<SP::Interaction, 2> contact;
  SP::NonSmoothDynamicalSystem system;
};

// The external force as Siconos calls it; z holds A_1, A_2, Omega.
inline void forcing(double time, unsigned int size, double *force, unsigned int, double *z) {
  for (unsigned int i = 0; i < size; ++i) force[i] = z[i] * std::cos(z[2] * time);
}

inline SiconosModel siconos_model(const Problem &problem) {
  const Scene &scene = problem.scene;
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

inline TwoMassState state_of(const SiconosModel &model, double time) {
  TwoMassState state{time, {}, {}, {}};
  for (unsigned int i = 0; i < 2; ++i) {
    state.displacement[i] = (*model.chain->q())(i);
    state.velocity[i] = (*model.chain->velocity())(i);
  }
  return state;
}

// Runs what calls Siconos, which tells of its failures at length on std::cout, quietly; returns the
// essence of the last thing it said when it throws, else nothing.
template <class Call>
std::string failure_of(const Call &call) {
  std::ostringstream said;
  std::streambuf *const before = std::cout.rdbuf(said.rdbuf());
  std::string failure;
  try {
    call();
  } catch (...) {
    failure = boost::current_exception_diagnostic_information();
    if (failure.empty()) failure = "Siconos gave up";
  }
  std::cout.rdbuf(before);
  // The diagnostic lists source line, exception type and error number; the sentence comes last.
  const std::string label = "[Siconos::message*] = ";
  if (const auto at = failure.find(label); at != std::string::npos)
    failure = failure.substr(at + label.size());
  failure = failure.substr(0, failure.find('\n'));
  return failure;
}

}  // namespace vibro_impact::comparison
