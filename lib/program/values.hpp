// What the words of the command line stand for: numbers, lists, ranges and stops.
//
// Every function throws std::invalid_argument with one line that names the option and what was
// given.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "vibro_impact/analysis/sweep.hpp"

namespace vibro_impact::runner {

// Longer chains are taken for a slip of the pen: the modes of a chain take cubic work.
constexpr int most_masses = 10000;

// A number as the user writes it, in full and in range.
double number(const std::string &option, const std::string &word);

// For an option that takes one: CLI11's own validators let NaN pass.
CLI::Validator number_from(double least);
CLI::Validator positive_number();
CLI::Validator whole_number(double most);  // from 1
CLI::Validator file_name();

// A list with one value per mass, or one value for all, separated by commas.
std::vector<double> per_mass(const std::string &option, const std::string &text,
                             std::size_t masses);

// from:to:count of a parameter.
Axis axis_of(const std::string &option, const Parameter &parameter, const std::string &text);

// mass:side:position, with a restitution of its own as a fourth part if it likes.
Stop stop_of(const std::string &text);

// beta of C = beta K from the dampers c_i of the links: c_i / k_i must agree for all of them, and a
// link without stiffness has no damper.
double beta_of(const std::string &text, const std::vector<double> &stiffness);

}  // namespace vibro_impact::runner
