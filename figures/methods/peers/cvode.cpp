// SUNDIALS CVODE with its own root finding on the gaps and hold forces (CVodeRootInit); after every
// event the solver is re-initialised, as its manual asks for discontinuities. Adams with
// fixed-point iteration (the manual's choice for non-stiff problems) and BDF with Newton iteration,
// a dense matrix and the exact Jacobian.
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>
#include <type_traits>

#include "figures/methods/error_vs_runtime/two_masses.hpp"

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

int jacobian(double, N_Vector, N_Vector, SUNMatrix matrix, void *user, N_Vector, N_Vector,
             N_Vector) {
  const Model &model = *static_cast<Model *>(user);
  SUNMatZero(matrix);
  set_jacobian(model.chain, model.now.held, [&](auto row, auto column, double value) {
    SM_ELEMENT_D(matrix, static_cast<sunindextype>(row), static_cast<sunindextype>(column)) = value;
  });
  return 0;
}

void require(bool holds, const char *call) {
  if (!holds) throw std::runtime_error(fmt::format("{} failed", call));
}

template <class Pointer, class Free>
auto owned(Pointer pointer, Free free) {
  require(pointer != nullptr, "allocation by SUNDIALS");
  return std::unique_ptr<std::remove_pointer_t<Pointer>, Free>(pointer, free);
}

// The absolute tolerances of the coming flights: relative to its height and speed for a mass that
// has just hit its stop. With one absolute tolerance for all, flights lower than it would be taken
// in one step of order one whatever their error, and the end of a chatter would come wrong by 1e-5.
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

Result integrate(const Problem &problem, int linear_multistep, double tolerance) {
  Model model{two_masses(problem.scene), {}};
  GapState &now = model.now;
  now = gap_state(model.chain, problem.start);
  Result result;

  SUNContext raw_context = nullptr;
  require(SUNContext_Create(nullptr, &raw_context) == 0, "SUNContext_Create");
  const auto context = owned(raw_context, [](SUNContext c) { SUNContext_Free(&c); });
  const auto y = owned(N_VMake_Serial(4, now.y.data(), raw_context), N_VDestroy);
  const auto solver =
      owned(CVodeCreate(linear_multistep, raw_context), [](void *memory) { CVodeFree(&memory); });
  require(CVodeInit(solver.get(), derivative, now.time, y.get()) == CV_SUCCESS, "CVodeInit");
  CVodeSetErrHandlerFn(
      solver.get(), [](int, const char *, const char *, char *, void *) {}, nullptr);
  const auto absolute = owned(N_VNew_Serial(4, raw_context), N_VDestroy);
  const auto tolerate = [&] {
    set_tolerances(model, tolerance, absolute.get());
    require(CVodeSVtolerances(solver.get(), tolerance, absolute.get()) == CV_SUCCESS,
            "CVodeSVtolerances");
  };
  tolerate();
  CVodeSetUserData(solver.get(), &model);
  CVodeSetMaxNumSteps(solver.get(), 1'000'000);
  CVodeSetMaxStep(solver.get(), longest_unseen);
  CVodeSetStopTime(solver.get(), problem.until);
  require(CVodeRootInit(solver.get(), 2, guards) == CV_SUCCESS, "CVodeRootInit");
  std::array<int, 2> falling{-1, -1};
  CVodeSetRootDirection(solver.get(), falling.data());

  const auto matrix = owned(SUNDenseMatrix(4, 4, raw_context), SUNMatDestroy);
  const auto linear = owned(SUNLinSol_Dense(y.get(), matrix.get(), raw_context),
                            [](SUNLinearSolver s) { SUNLinSolFree(s); });
  const auto fixed_point = owned(SUNNonlinSol_FixedPoint(y.get(), 0, raw_context),
                                 [](SUNNonlinearSolver s) { SUNNonlinSolFree(s); });
  if (linear_multistep == CV_ADAMS) {
    require(CVodeSetNonlinearSolver(solver.get(), fixed_point.get()) == CV_SUCCESS,
            "CVodeSetNonlinearSolver");
  } else {
    require(CVodeSetLinearSolver(solver.get(), linear.get(), matrix.get()) == CV_SUCCESS,
            "CVodeSetLinearSolver");
    require(CVodeSetJacFn(solver.get(), jacobian) == CV_SUCCESS, "CVodeSetJacFn");
  }

  while (result.failure.empty()) {
    const int flag = CVode(solver.get(), problem.until, y.get(), &now.time, CV_NORMAL);
    if (flag != CV_ROOT_RETURN && flag != CV_TSTOP_RETURN && flag != CV_SUCCESS) {
      const std::unique_ptr<char, decltype(&std::free)> reason(CVodeGetReturnFlagName(flag),
                                                               &std::free);
      result.failure = fmt::format("{} at t = {:.6f}", reason.get(), now.time);
      break;
    }
    if (flag != CV_ROOT_RETURN) break;
    std::array<int, 2> found{};
    CVodeGetRootInfo(solver.get(), found.data());
    for (std::size_t i = 0; i < 2; ++i)
      if (found[i] < 0) happen(model.chain, now, i, stick_below(tolerance), result);
    tolerate();
    CVodeReInit(solver.get(), now.time, y.get());
    // A first step that is not longer than the flight ahead, else one of the solver's own choice.
    const double flight = flight_ahead(model.chain, now);
    CVodeSetInitStep(solver.get(), flight < longest_unseen ? 0.1 * flight : 0.0);
  }
  result.work = model.evaluations;
  result.end = physical_state(model.chain, now);
  return result;
}

template <int linear_multistep>
Result run(const Problem &problem, double tolerance) try {
  return integrate(problem, linear_multistep, tolerance);
} catch (const std::runtime_error &error) {
  Result failed;
  failed.failure = error.what();
  return failed;
}

}  // namespace

std::vector<Method> cvode() {
  const std::vector<double> tolerances{1e-4, 1e-6, 1e-8, 1e-10, 1e-12};
  return {{"CVODE Adams", "tolerance", "right-hand sides", tolerances, run<CV_ADAMS>},
          {"CVODE BDF", "tolerance", "right-hand sides", tolerances, run<CV_BDF>}};
}

}  // namespace vibro_impact::comparison
