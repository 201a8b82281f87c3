// Shared by the tests of the figures: the true events, the comparison of a drawn panel with its
// axes and its table, and the tables in documents.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <string>
#include <vector>

#include "drawn.hpp"
#include "events.hpp"
#include "figures/inferred_frequencies.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "reference/truth/event_reader.hpp"

namespace vibro_impact::testing {

// The folder of a figure's tables, one per figure: several tests run at once.
inline std::string folder_of(const std::string &figure) {
  return ::testing::TempDir() + "vibro_impact_" + figure;
}

inline std::vector<Event> true_events(const std::string &scene) {
  return truth::read_event_table(REFERENCE_DIR "/" + scene + "_events.csv");
}

// Each mass of the paper's scenes has one stop.
inline double stop_position(const Scene &scene, int mass) {
  return scene.stops[static_cast<std::size_t>(mass - 1)].position;
}

// The stops at which these masses have an impact within the window, mostly between two samples.
inline figures::Range stops_hit(const std::string &truth, const paper::AxisBox &box,
                                const std::vector<int> &masses) {
  figures::Range stops;
  for (const int mass : masses)
    for (const Event &event : select(true_events(truth), EventKind::impact, mass))
      if (event.time >= box.from && event.time <= box.to)
        stops.include(stop_position(paper::scene_named(truth).scene, mass));
  return stops;
}

// The rows of the tables in a document, without the blanks around their cells.
inline truth::Rows rows_in_document(const std::string &path) {
  const std::regex cell(R"(\| *([^|]*?) *(?=\|))");
  truth::Rows rows;
  std::ifstream document = truth::opened(SOURCE_DIR "/" + path);
  for (std::string line; std::getline(document, line);) {
    if (!line.starts_with("| ")) continue;
    rows.emplace_back();
    for (std::sregex_iterator found(line.begin(), line.end(), cell), end; found != end; ++found)
      rows.back().push_back((*found)[1]);
  }
  return rows;
}

inline bool holds(const Held &held, int mass) {
  const auto i = static_cast<std::size_t>(mass - 1);
  return i < held.size() && held[i] != 0;
}

// The labels of the ticks are those of the printed axes, from end to end, and the panel has its
// letter. What is drawn from curve `first` on, with the heights `reached` between its points, fills
// the ordinate, as data do in the paper's plots.
inline void expect_axes(const Panel &panel, char letter, const paper::AxisBox &box,
                        std::size_t first, const figures::Range &reached = {}) {
  std::vector<double> printed, labels;
  for (const std::string &text : panel.texts)
    if (const auto label = truth::as_number(text)) labels.push_back(*label);
  for (int k = 0; k <= std::lround((box.to - box.from) / box.tick_across); ++k)
    printed.push_back(box.from + k * box.tick_across);
  for (int k = 0; k <= std::lround((box.highest - box.lowest) / box.tick); ++k)
    printed.push_back(box.lowest + k * box.tick);
  std::sort(printed.begin(), printed.end());
  std::sort(labels.begin(), labels.end());
  ASSERT_EQ(labels.size(), printed.size());
  for (std::size_t i = 0; i < labels.size(); ++i) EXPECT_NEAR(labels[i], printed[i], 1e-9);
  const std::string name = {'(', letter, ')'};
  EXPECT_EQ(std::count(panel.texts.begin(), panel.texts.end(), name), 1) << name;
  figures::Range data = reached;
  for (std::size_t i = first; i < panel.curves.size(); ++i)
    for (const Point &point : panel.curves[i].points) data.include(point[1]);
  EXPECT_TRUE(figures::fills_ordinate(data, box)) << data.lowest << " to " << data.highest;
}

// Six digits are written of every number; zero may be written of what is far below the others.
inline void expect_points(const Curve &curve, const std::vector<double> &x,
                          const std::vector<double> &y) {
  ASSERT_EQ(curve.points.size(), x.size()) << curve.title;
  for (std::size_t i = 0; i < x.size(); ++i) {
    ASSERT_NEAR(curve.points[i][0], x[i], 1e-5 * std::abs(x[i])) << curve.title;
    ASSERT_NEAR(curve.points[i][1], y[i], 1e-5 * std::abs(y[i]) + 1e-15) << curve.title;
  }
}

}  // namespace vibro_impact::testing
