// The files that the program writes: refused before any work is done, and written whole at the end.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "vibro_impact/analysis/table.hpp"

namespace vibro_impact::runner {

// The refusal of a command line or a file: throws std::invalid_argument with one line that names
// the value and the rule it breaks.
template <class... Values>
[[noreturn]] void refuse(fmt::format_string<Values...> line, Values &&...values) {
  throw std::invalid_argument(fmt::format(line, std::forward<Values>(values)...));
}

// The columns of a list behind others: ,name1,name2,... with a further word behind each number.
std::string numbered_columns(const std::string &name, std::size_t count,
                             const std::string &behind = "");

// A file that a command writes, and the option that names it. An empty path means that the file is
// not wanted; `-` is standard output, and a pipe may have a name.
struct Output {
  std::string option, path = {};

  bool wanted() const {
    return !path.empty();
  }
  bool is_file() const;  // not a stream
  std::string given() const {
    return option + " " + path;
  }
};

// Refuses these outputs unless all can be written: in a folder that exists and is not
// write-protected, in place of nothing but a file, and each under another name, which is not that
// of the file of the scene.
void check_outputs(const std::vector<Output> &outputs, const std::string &scene_file);

// The bytes of a file. A file that cannot be read has none.
std::string contents(const std::string &path);

// A path of the open file or pipe itself, whatever has become of its name (in Linux).
std::string path_of(std::FILE *file);

// An output to which text is appended. A file takes its name when it is finished; what is appended
// to a stream stands there at once. The functions throw std::runtime_error with one line when they
// fail.
class OpenOutput {
 public:
  explicit OpenOutput(const std::string &path);
  void append(std::string_view text);
  void finish();

 private:
  std::optional<TableFile> file_ = {};  // empty: standard output
};

// A file without a name, for gnuplot.
class TemporaryFile {
 public:
  void append(std::string_view text) const;
  Output output() const {
    return {"", path_of(file_.get())};
  }

 private:
  std::unique_ptr<std::FILE, int (*)(std::FILE *)> file_{std::tmpfile(), std::fclose};
};

// Writes the whole text to an output.
void write_text(std::string_view text, const std::string &path);

}  // namespace vibro_impact::runner
