// ERKStep of ARKODE (SUNDIALS) with its default method of order 5, that of Cash and Karp, and its
// Hermite interpolation, in the common event loop. CVODE's Adams method starts again at order 1
// behind every impact, and took two to four times as long. With order 8, the interpolation is of
// too low an order.
#include <arkode/arkode_erkstep.h>
#include <nvector/nvector_serial.h>

#include <fmt/format.h>
#include <algorithm>
#include <memory>
#include <stdexcept>
#include <type_traits>

#include "event_loop.hpp"

namespace vibro_impact::comparison {

namespace {

void require(bool holds, const char *call) {
  if (!holds) throw std::runtime_error(fmt::format("{} failed", call));
}

// A pointer of SUNDIALS that is freed with its last copy.
template <class Pointer, class Free>
std::shared_ptr<std::remove_pointer_t<Pointer>> owned(Pointer pointer, Free free) {
  require(pointer != nullptr, "allocation by SUNDIALS");
  return {pointer, free};
}

int derivative(double tau, N_Vector y, N_Vector dydt, void *user) {
  const System &system = *static_cast<System *>(user);
  double *slope = NV_DATA_S(dydt);
  right_hand_side(system.chain, system.now.held, NV_DATA_S(y), slope, system.now.time + tau);
  return 0;
}

struct RungeKutta {
  System system;
  double tolerance;
  std::shared_ptr<_SUNContext> context = {};
  std::shared_ptr<_generic_N_Vector> y = {};
  std::shared_ptr<void> memory = {};
  double reached = 0.0;
  StepLength length = {};

  void create() {
    SUNContext created = nullptr;
    require(SUNContext_Create(nullptr, &created) == 0, "SUNContext_Create");
    context = owned(created, [](SUNContext c) { SUNContext_Free(&c); });
    y = owned(N_VNew_Serial(4, created), N_VDestroy);
    memory =
        owned(ERKStepCreate(derivative, 0.0, y.get(), created), [](void *m) { ERKStepFree(&m); });
    ERKStepSetOrder(memory.get(), 5);
    ERKStepSetUserData(memory.get(), &system);
    ERKStepSetErrHandlerFn(
        memory.get(), [](int, const char *, const char *, char *, void *) {}, nullptr);
    require(ERKStepSStolerances(memory.get(), tolerance, tolerance) == ARK_SUCCESS,
            "ERKStepSStolerances");
  }

  void restart(double longest_first) {
    if (!memory) create();
    std::ranges::copy(system.now.y, NV_DATA_S(y.get()));
    require(ERKStepReInit(memory.get(), derivative, 0.0, y.get()) == ARK_SUCCESS, "ERKStepReInit");
    ERKStepSetInitStep(memory.get(), length.first(longest_first));
    reached = 0.0;
  }

  std::pair<double, double> next() {
    constexpr double far = 1e3;  // a time beyond the end of the step, which gives the direction
    const double from = reached;
    require(ERKStepEvolve(memory.get(), far, y.get(), &reached, ARK_ONE_STEP) >= 0,
            "ERKStepEvolve");
    double step = 0.0;
    ERKStepGetCurrentStep(memory.get(), &step);
    length.chosen(step);
    return {from, reached};
  }

  Vec at(double tau) {
    Vec state;
    if (tau == reached) {
      std::copy_n(NV_DATA_S(y.get()), state.size(), state.begin());
      return state;
    }
    const auto vector = owned(N_VMake_Serial(4, state.data(), context.get()), N_VDestroy);
    require(ERKStepGetDky(memory.get(), tau, 0, vector.get()) == ARK_SUCCESS, "ERKStepGetDky");
    return state;
  }
};

Result run_erkstep(const Problem &problem, double tolerance) {
  return with_events(problem, stick_below(tolerance), [&](const System &system) {
    return RungeKutta{system, tolerance};
  });
}

}  // namespace

std::vector<Method> arkode() {
  return {{"ARKODE ERKStep", {1e-4, 1e-6, 1e-8, 1e-10, 1e-12}, run_erkstep}};
}

}  // namespace vibro_impact::comparison
