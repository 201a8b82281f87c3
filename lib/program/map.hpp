// The map of a sweep over two parameters: what its picture shows at each point.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "files.hpp"
#include "vibro_impact/analysis/sweep.hpp"

namespace vibro_impact::runner {

// A map shows the value of a continuous column at a point, or the class of the point. A class
// is a number, as a period, or has a name where there is none.
std::string map_word(const Column &column, const PointRecord &result);

// A map in a temporary file, so that its memory does not grow with the number of points.
class Map {
 public:
  void add(const std::vector<double> &parameters, const std::string &word);

  // The table for gnuplot: the parameters and the word of each point.
  Output table() const {
    return file_.output();
  }
  // The classes in words for gnuplot, empty for continuous values: the most frequent numbers in
  // their order, as many as there are colours, then `other` for the rest, then the names.
  std::string classes() const;

 private:
  TemporaryFile file_ = {};
  std::map<std::string, std::size_t> points_ = {};  // of each class
};

}  // namespace vibro_impact::runner
