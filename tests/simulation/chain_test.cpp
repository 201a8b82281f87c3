// Scenes and contact modes.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <random>

#include "reference/scenes/paper_scenes.hpp"
#include "simulation/chain/contact_mode.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;

Scene random_chain(std::mt19937 &generator, int masses) {
  std::uniform_real_distribution<double> uniform(0.2, 5.0);
  Scene scene;
  for (int i = 1; i <= masses; ++i) {
    scene.mass.push_back(uniform(generator));
    scene.stiffness.push_back(uniform(generator));
    scene.amplitude.push_back(uniform(generator) - 2.5);
    scene.stops.push_back({i, Side::upper, uniform(generator)});
    scene.stops.push_back({i, Side::lower, -uniform(generator)});
  }
  scene.beta = 0.1;
  scene.omega = 0.7;
  return scene;
}

Eigen::MatrixXd stiffness_matrix(const Scene &scene) {
  const auto n = static_cast<Eigen::Index>(scene.mass.size());
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double link = scene.stiffness[static_cast<std::size_t>(i)];
    k(i, i) += link;
    if (i > 0) {
      k(i - 1, i - 1) += link;
      k(i, i - 1) -= link;
      k(i - 1, i) -= link;
    }
  }
  return k;
}

// 1e-14: rounding of the eigensolver on numbers of order one.
TEST(ContactMode, EigenvaluesAndEigenvectorsOfThePaper) {
  const NaturalModes modes = natural_modes(paper::figure2(), Held{0, 0});
  ASSERT_EQ(modes.lambda.size(), 2u);
  const double root5 = std::sqrt(5.0);
  EXPECT_NEAR(modes.lambda[0], (3.0 - root5) / 2.0, 1e-14);
  EXPECT_NEAR(modes.lambda[1], (3.0 + root5) / 2.0, 1e-14);
  EXPECT_NEAR(modes.shape(0, 0), std::sqrt((5.0 - root5) / 10.0), 1e-14);
  EXPECT_NEAR(modes.shape(1, 0), std::sqrt((5.0 + root5) / 10.0), 1e-14);
  EXPECT_NEAR(modes.shape(0, 1), -std::sqrt((5.0 + root5) / 10.0), 1e-14);
  EXPECT_NEAR(modes.shape(1, 1), std::sqrt((5.0 - root5) / 10.0), 1e-14);
}

// Every contact mode of random chains: the modes decouple M and K on the free rows, the static
// positions balance them. 1e-12: rounding times the condition of the chains tried (below 1e3).
TEST(ContactMode, EveryModeDecouplesItsFreeMasses) {
  std::mt19937 generator(7);
  for (int masses = 1; masses <= 4; ++masses) {
    const Scene scene = random_chain(generator, masses);
    const Eigen::MatrixXd k = stiffness_matrix(scene);
    int combinations = 1;
    for (int i = 0; i < masses; ++i) combinations *= 3;
    for (int code = 0; code < combinations; ++code) {
      Held held;
      for (int i = 0, rest = code; i < masses; ++i, rest /= 3)
        held.push_back(static_cast<signed char>(rest % 3 - 1));
      const auto mode = build_contact_mode<Eigen::Dynamic>(scene, held);
      const Eigen::Index modes = mode.lanes() - mode.forcing_lanes;
      const Eigen::MatrixXd shape = mode.shape.leftCols(modes);
      const Eigen::MatrixXd identity = shape * mode.to_modal.topRows(modes);
      const Eigen::VectorXd residual = k * mode.equilibrium;
      for (int i = 0; i < masses; ++i) {
        const bool is_free = held[static_cast<std::size_t>(i)] == 0;
        EXPECT_NEAR(identity(i, i), is_free ? 1.0 : 0.0, 1e-12);
        if (is_free) {
          EXPECT_NEAR(residual(i), 0.0, 1e-12);
          for (Eigen::Index j = 0; j < modes; ++j)
            EXPECT_NEAR((k * shape.col(j))(i),
                        mode.lambda(j) * scene.mass[static_cast<std::size_t>(i)] * shape(i, j),
                        1e-12);
        } else {
          EXPECT_EQ(shape.row(i).cwiseAbs().sum(), 0.0);
        }
      }
    }
  }
}

// Eq. 24, corrected: with mass 2 stuck, mass 1 rests at + s2 / 2 (2 k x1 = k s2).
TEST(ContactMode, StaticPositionOfMassOneIsHalfOfS2) {
  const auto mode = build_contact_mode<Eigen::Dynamic>(paper::figure2(), Held{0, 1});
  EXPECT_DOUBLE_EQ(mode.equilibrium(0), 0.05);
}

// What makes the zero hold force of Figure 5(c) exactly zero.
TEST(ContactMode, EqualAnchorsGiveExactlyTheirPosition) {
  Scene scene = paper::figure5c();
  scene.stiffness = {1.3, 0.7};
  for (double s : {0.3, 0.1, 1.0 / 3.0}) {
    scene.stops = {{1, Side::upper, s}, {2, Side::upper, s}};
    const auto mode = build_contact_mode<Eigen::Dynamic>(scene, Held{1, 0});
    EXPECT_EQ(mode.equilibrium(1), s);
    ASSERT_EQ(mode.contacts.size(), 2u);
    EXPECT_FALSE(mode.contacts[1].held);
    EXPECT_EQ(mode.contacts[1].press.offset, 0.0);
  }
}

TEST(Scene, BadValuesAreNamed) {
  const auto message = [](auto change) -> std::string {
    Scene scene = paper::figure2();
    change(scene);
    try {
      check(scene);
    } catch (const std::invalid_argument &bad) {
      return bad.what();
    }
    return "accepted";
  };
  EXPECT_EQ(message([](Scene &) {}), "accepted");
  EXPECT_EQ(message([](Scene &s) { s.mass[1] = -2.5; }),
            "mass = -2.5: must be positive and finite");
  EXPECT_EQ(message([](Scene &s) { s.stiffness[0] = 0.0; }), "accepted") << "a free chain";
  EXPECT_EQ(message([](Scene &s) { s.stiffness[0] = -1.0; }),
            "stiffness of link 1 = -1: must be non-negative and finite");
  EXPECT_EQ(message([](Scene &s) { s.stiffness[1] = 0.0; }),
            "stiffness of link 2 = 0: must be positive and finite");
  EXPECT_EQ(message([](Scene &s) { s.restitution = 1.25; }),
            "restitution = 1.25: must lie in [0, 1]");
  EXPECT_EQ(message([](Scene &s) { s.restitution = std::nan(""); }),
            "restitution = nan: must lie in [0, 1]");
  EXPECT_EQ(message([](Scene &s) { s.stops[1].restitution = 1.25; }),
            "restitution = 1.25: must lie in [0, 1]");
  EXPECT_EQ(message([](Scene &s) { s.stops[1].restitution = 0.25; }), "accepted");
  EXPECT_NE(message([](Scene &s) {
              s.displacement = {0.0, 0.2};
            }).find("beyond its upper stop"),
            std::string::npos);
  EXPECT_NE(message([](Scene &s) { s.stops.push_back({1, Side::upper, -0.4}); }), "accepted");
  EXPECT_NE(message([](Scene &s) { s.stops.push_back({5, Side::upper, 1.0}); }), "accepted");
  EXPECT_NE(message([](Scene &s) { s.amplitude = {1.0}; }), "accepted");
}

}  // namespace
