// SUNDIALS CVODE: Adams with fixed-point iteration, the manual's choice for problems that are not
// stiff, and CVODE's own root finding on the gaps and hold forces (CVodeRootInit). After every
// event the solver is initialised again, as its manual asks for discontinuities.
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <type_traits>

#include "two_masses.hpp"

namespace vibro_impact::comparison {

namespace {

struct Model {
  TwoMasses chain;
  GapState now;
  long long evaluations = 0;
};

int derivative(double t, N_Vector y, N_Vector dydt, void *user) {
  Model &model = *static_cast<Model *>(user);
  ++model.evaluations;
  double *slope = NV_DATA_S(dydt);
  right_hand_side(model.chain, model.now.held, NV_DATA_S(y), slope, t);
  return 0;
}

int guards(double t, N_Vector y, double *values, void *user) {
  const Model &model = *static_cast<Model *>(user);
  for (std::size_t i = 0; i < 2; ++i)
    values[i] = guard(model.chain, model.now.held, i, NV_DATA_S(y), t);
  return 0;
}

void require(bool holds, const char *call) {
  if (!holds) throw std::runtime_error(fmt::format("{} failed", call));
}

// A pointer of SUNDIALS that is freed with its last copy.
template <class Pointer, class Free>
std::shared_ptr<std::remove_pointer_t<Pointer>> owned(Pointer pointer, Free free) {
  require(pointer != nullptr, "allocation by SUNDIALS");
  return {pointer, free};
}

// Makes the absolute tolerances of the coming flight of a mass that has just hit its stop relative
// to the height and speed of that flight. With one absolute tolerance for all, flights lower than
// it would be taken in one step of order one whatever their error, and the end of a chatter would
// be wrong by 1e-5.
void set_tolerances(const Model &model, double tolerance, N_Vector absolute) {
  const double cosine = std::cos(model.chain.omega * model.now.time);
  for (std::size_t i = 0; i < 2; ++i) {
    const double speed = model.now.y[2 * i + 1];
    const double falling = -model.chain.acceleration(i, model.now.y, cosine);
    const bool has_hit = !model.now.held[i] && model.now.y[2 * i] == 0.0 && speed > 0.0;
    const double height = has_hit && falling > 0.0 ? 0.5 * speed * speed / falling : 1.0;
    NV_Ith_S(absolute, static_cast<sunindextype>(2 * i)) = tolerance * std::min(1.0, height);
    NV_Ith_S(absolute, static_cast<sunindextype>(2 * i + 1)) =
        tolerance * (has_hit ? std::min(1.0, speed) : 1.0);
  }
}

// CVODE's memory and what it refers to.
struct Solver {
  std::shared_ptr<_SUNContext> context;
  std::shared_ptr<_generic_N_Vector> y, absolute;
  std::shared_ptr<_generic_SUNNonlinearSolver> fixed_point;
  std::shared_ptr<void> memory;

  void tolerate(const Model &model, double tolerance) const {
    set_tolerances(model, tolerance, absolute.get());
    require(CVodeSVtolerances(memory.get(), tolerance, absolute.get()) == CV_SUCCESS,
            "CVodeSVtolerances");
  }
};

Solver solver_for(Model &model, double tolerance, double until) {
  Solver solver;
  SUNContext context = nullptr;
  require(SUNContext_Create(nullptr, &context) == 0, "SUNContext_Create");
  solver.context = owned(context, [](SUNContext c) { SUNContext_Free(&c); });
  solver.y = owned(N_VMake_Serial(4, model.now.y.data(), context), N_VDestroy);
  solver.absolute = owned(N_VNew_Serial(4, context), N_VDestroy);
  solver.fixed_point = owned(SUNNonlinSol_FixedPoint(solver.y.get(), 0, context), SUNNonlinSolFree);
  solver.memory = owned(CVodeCreate(CV_ADAMS, context), [](void *m) { CVodeFree(&m); });
  void *const memory = solver.memory.get();
  require(CVodeInit(memory, derivative, model.now.time, solver.y.get()) == CV_SUCCESS, "CVodeInit");
  CVodeSetErrHandlerFn(
      memory, [](int, const char *, const char *, char *, void *) {}, nullptr);
  solver.tolerate(model, tolerance);
  CVodeSetUserData(memory, &model);
  CVodeSetMaxNumSteps(memory, 1'000'000);
  CVodeSetMaxStep(memory, longest_unseen);
  CVodeSetStopTime(memory, until);
  require(CVodeRootInit(memory, 2, guards) == CV_SUCCESS, "CVodeRootInit");
  std::array<int, 2> falling{-1, -1};
  CVodeSetRootDirection(memory, falling.data());
  require(CVodeSetNonlinearSolver(memory, solver.fixed_point.get()) == CV_SUCCESS,
          "CVodeSetNonlinearSolver");
  return solver;
}

Result adams(const Problem &problem, double tolerance) try {
  Model model{two_masses(problem.scene), {}};
  GapState &now = model.now;
  now = gap_state(model.chain, problem.start);
  const Solver solver = solver_for(model, tolerance, problem.until);
  void *const memory = solver.memory.get();
  Result result;
  while (result.failure.empty()) {
    const int flag = CVode(memory, problem.until, solver.y.get(), &now.time, CV_NORMAL);
    if (flag < 0) {
      const std::unique_ptr<char, decltype(&std::free)> reason(CVodeGetReturnFlagName(flag),
                                                               &std::free);
      result.failure = fmt::format("{} at t = {:.6f}", reason.get(), now.time);
    }
    if (flag != CV_ROOT_RETURN) break;
    std::array<int, 2> found{};
    CVodeGetRootInfo(memory, found.data());
    for (std::size_t i = 0; i < 2; ++i)
      if (found[i] < 0) apply_event(model.chain, now, i, stick_below(tolerance), result);
    solver.tolerate(model, tolerance);
    CVodeReInit(memory, now.time, solver.y.get());
    // The first step is not longer than the flight ahead; without one, CVODE chooses.
    const double flight = flight_ahead(model.chain, now);
    CVodeSetInitStep(memory, flight < longest_unseen ? 0.1 * flight : 0.0);
  }
  result.work = model.evaluations;
  result.end = physical_state(model.chain, now);
  return result;
} catch (const std::runtime_error &error) {
  Result failed;
  failed.failure = error.what();
  return failed;
}

}  // namespace

std::vector<Method> cvode() {
  return {{"CVODE Adams", {1e-4, 1e-6, 1e-8, 1e-10, 1e-12}, adams}};
}

}  // namespace vibro_impact::comparison
