// What to say of a word on the command line that means nothing.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace vibro_impact::runner {

// One line: what is wrong, and what may have been meant.
std::string explain(const CLI::App &app, const CLI::ParseError &error);

}  // namespace vibro_impact::runner
