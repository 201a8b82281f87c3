// A sweep over the forcing frequency: how often per period does each mass of the paper's Figure 3
// stick, once the motion from rest has settled?
#include <cstdio>

#include "vibro_impact/vibro_impact.hpp"

int main() {
  using namespace vibro_impact;
  Scene scene;
  scene.mass = {1.0, 1.0};
  scene.stiffness = {1.0, 1.0};
  scene.beta = 0.1;
  scene.amplitude = {0.5, 0.0};
  scene.restitution = 0.7;
  scene.stops = {{1, Side::lower, -0.3}, {2, Side::upper, 0.1}};

  constexpr int settling = 100, counted = 20;
  int least = counted, most = 0;
  std::printf("omega,sticks1,sticks2\n");
  for (int k = 0; k <= 18; ++k) {
    scene.omega = 0.25 + 0.025 * k;
    const int first = sticking_phases(scene, 1, settling, counted);
    const int second = sticking_phases(scene, 2, settling, counted);
    std::printf("%g,%g,%g\n", scene.omega, first / double{counted}, second / double{counted});
    least = first < least ? first : least;
    most = first > most ? first : most;
  }
  return !(least == 0 && most >= counted);  // Section 3.2: sticking below about 0.5, none above
}
