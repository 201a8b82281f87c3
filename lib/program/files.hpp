// The files that the program writes: refused before any work is done, or written whole at the end.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "vibro_impact/table.hpp"

namespace vibro_impact::runner {

// Throws std::invalid_argument unless all these files, each with the option that names it, can be
// written: in a folder that exists, in place of nothing but a file, and each under another name. An
// empty path is no file.
void check_files(const std::vector<std::pair<std::string, std::string>> &files);

// Writes the table to the file, or for `-` to standard output. Throws std::runtime_error with one
// line when that fails; then no file is left.
void write_table(const Table &table, const std::string &path);

}  // namespace vibro_impact::runner
