// Figure 1 in motion: the table of its frames against the true events, and the words that are drawn
// in every frame against the table.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "tests/support/panels.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

// Each mass is said to do what the true events say. The last impacts of
// a chatter, slower than 1e-4, are not resolved, so that only sticking is compared to the frame.
TEST(Figure1, ItsTableSaysWhatTheMassesDo) {
  const std::string folder = folder_of("figure1_table");
  run(std::string(PROGRAM_DIR "/figure1 --output ") + folder);
  const Scene scene = paper::figure2();
  const std::vector<Event> events = true_events("figure2");
  std::set<std::string> actions[2];
  double last = paper::panel("figure2a").to - 2 * Clock(scene.omega).period;
  for (const auto &cells : truth::read_rows(folder + "/figure1_motion.csv", 5)) {
    const double time = std::stod(cells[0]);
    const auto next = std::find_if(events.begin(), events.end(),
                                   [time](const Event &event) { return event.time > time; });
    ASSERT_NE(next, events.begin());
    EXPECT_LT(time - last, 0.65) << "frames are 0.2 or 0.6 apart";
    last = time;
    for (const std::size_t i : {0u, 1u}) {
      const std::string &action = cells[3 + i];
      actions[i].insert(action);
      const int mass = static_cast<int>(i) + 1;
      EXPECT_EQ(action == "sticks", holds(std::prev(next)->held, mass)) << time;
      if (action == "sticks") {
        EXPECT_EQ(std::stod(cells[1 + i]), scene.stops[i].position) << time;
      }
    }
  }
  EXPECT_NEAR(last, paper::panel("figure2a").to, 0.65);
  for (const auto &of_mass : actions)
    EXPECT_EQ(of_mass, (std::set<std::string>{"-", "impact", "chatters", "sticks", "released"}));
}

void draw_motion(const std::string &folder, const std::string &kind) {
  run("cd " SOURCE_DIR " && gnuplot -e \"data='" + folder + "'; kind='" + kind +
      "'\" figures/figure1.gp 2>/dev/null");
}

// All that a frame says beside what the masses do: the scene, the time, the names of masses and
// stops, the key, and the labels of the ticks.
std::multiset<std::string> words_of_every_frame(const Scene &scene, const figures::Range &window,
                                                const std::string &time) {
  std::multiset<std::string> words{
      fmt::format("Figure 2 in motion:  Ω = {:g} (inferred),  r = {:g},  force {:g} cos Ωt on "
                  "mass 1",
                  scene.omega, scene.restitution, scene.amplitude[0]),
      fmt::format("t = {:.2f}", std::stod(time)),
      "Time",
      "Displacement",
      "sticks",
      "mass 1",
      "mass 2"};
  for (const Stop &stop : scene.stops) {
    words.insert(fmt::format("m{}", stop.mass));
    words.insert(fmt::format("s{}", stop.mass));
    words.insert(fmt::format("s{} = {:g}", stop.mass, stop.position));
  }
  for (const char *tick : {"-0.4", "-0.2", "0", "0.2", "0.4"}) words.insert(tick);
  for (double tick = 5.0 * std::ceil(window.lowest / 5.0); tick <= window.highest; tick += 5.0)
    words.insert(fmt::format("{:g}", tick));
  return words;
}

// A mass that does nothing has no word above it.
TEST(Figure1, EveryFrameShowsTheWordsOfItsTableAndNoOthers) {
  const std::string folder = folder_of("figure1_frames");
  run(std::string(PROGRAM_DIR "/figure1 --output ") + folder);
  draw_motion(folder, "frames");
  const Scene scene = paper::figure2();
  const auto rows = truth::read_rows(folder + "/figure1_motion.csv", 5);
  ASSERT_GT(rows.size(), 100u);
  const figures::Range window{std::stod(rows.front()[0]), std::stod(rows.back()[0])};
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const auto texts = texts_of(folder + fmt::format("/motion{:04}.svg", k + 1));
    std::multiset<std::string> words, expected = words_of_every_frame(scene, window, rows[k][0]);
    for (const auto &[text, x] : texts) words.insert(text);
    for (const std::size_t i : {3u, 4u})
      if (rows[k][i] != "-") expected.insert(rows[k][i]);
    ASSERT_EQ(words, expected) << "frame " << k + 1;
    // The words of a mass stand above it: nearer to its name than half the distance of the masses.
    for (const int mass : {1, 2}) {
      const std::string &action = rows[k][static_cast<std::size_t>(mass) + 2];
      if (action == "-") continue;
      const double place = texts.find(fmt::format("m{}", mass))->second,
                   distance = std::abs(texts.find("m2")->second - texts.find("m1")->second);
      const auto [first, last] = texts.equal_range(action);
      EXPECT_TRUE(std::any_of(
          first, last,
          [=](const auto &text) { return std::abs(text.second - place) < distance / 2; }))
          << action << " above mass " << mass << ", frame " << k + 1;
    }
  }
}

TEST(Figure1, MovesInAFileThatAPageCanShow) {
  const std::string folder = folder_of("figure1_gif");
  run(std::string(PROGRAM_DIR "/figure1 --output ") + folder);
  draw_motion(folder, "gif");
  std::ifstream gif = truth::opened(folder + "/motion.gif");
  const std::string bytes{std::istreambuf_iterator<char>(gif), {}};
  EXPECT_EQ(bytes.substr(0, 6), "GIF89a");
  EXPECT_LT(bytes.size(), 1000000u);
}

}  // namespace
