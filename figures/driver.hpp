// The command line and the error exit of all figure drivers.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "program/progress.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "vibro_impact/analysis/table.hpp"

namespace vibro_impact::figures {

// An option of the command line. `value` points to the default, which what the user gives replaces.
struct Option {
  std::string name, meaning;
  std::string *value;
};

// The main function of a program: reads the options and calls `run`. Returns the exit status: that
// of `run`, 0 after --help, or 2 after one line on standard error for a wrong command line and for
// whatever `run` throws.
int run_program(int argc, char **argv, const std::string &purpose,
                const std::vector<Option> &options, const std::function<int()> &run);

// The main function of a driver: `run_program` with the option --output and further ones. Creates
// the folder the tables go to, makes sure before any work that they can be written, and calls
// draw(folder).
int main_of_driver(int argc, char **argv, const std::string &purpose,
                   const std::function<void(const std::filesystem::path &)> &draw,
                   std::vector<Option> options = {});

}  // namespace vibro_impact::figures
