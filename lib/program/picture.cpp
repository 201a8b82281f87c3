#include "picture.hpp"

#include <CLI/StringTools.hpp>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "scene_text.hpp"

namespace vibro_impact::runner {

namespace {

namespace fs = std::filesystem;

// The name of gnuplot's terminal for a file.
std::string terminal_of(const Output &picture) {
  if (picture.path.ends_with(".png")) return "pngcairo";
  if (picture.path.ends_with(".pdf")) return "pdfcairo";
  if (picture.path.ends_with(".svg")) return "svg";
  refuse("{}: must end in .png, .pdf or .svg", picture.given());
}

// The script stands beside the program, in the build folder as where it is installed, so that both
// may be moved. Linux says where the program is; argv[0] has no folder if the shell found it.
std::string script() {
  return fs::read_symlink("/proc/self/exe").parent_path() / "../share/vibro-impact/plot.gp";
}

// A word of a command of the shell.
std::string quoted(const std::string &word) {
  return fmt::format(" '{}'", CLI::detail::find_and_replace(word, "'", "'\\''"));
}

// Runs gnuplot without the settings of the user. Returns its output, or nothing if it fails.
std::optional<std::string> gnuplot(const std::string &arguments) {
  std::FILE *output = popen(("gnuplot -d " + arguments).c_str(), "r");
  if (output == nullptr) throw std::runtime_error("gnuplot cannot be started");
  const std::string bytes = contents(path_of(output));
  return pclose(output) == 0 ? std::optional(bytes) : std::nullopt;
}

}  // namespace

void check_picture(const Output &picture, const Output &table) {
  const std::string terminal = terminal_of(picture);
  if (!table.is_file())
    refuse("{}: is drawn from the table of {}, which must be a file", picture.given(),
           table.option);
  if (!fs::exists(script()))
    refuse("{}: needs its script {}, which is not there", picture.given(), script());
  if (!gnuplot("-e 'set terminal " + terminal + "' 2>&1"))
    refuse("{}: needs gnuplot with its terminal {}, not found", picture.given(), terminal);
}

void draw(const Output &picture, const std::string &kind, const std::string &content,
          const std::vector<Output> &tables, const std::vector<std::string> &words) {
  std::string arguments =
      "-c" + quoted(script()) + quoted(terminal_of(picture)) + quoted(kind) + quoted(content);
  for (const Output &table : tables)
    arguments += quoted(table.is_file() ? fs::absolute(table.path).string() : "/dev/null");
  for (const std::string &word : words) arguments += quoted(word);
  if (const auto bytes = gnuplot(arguments + " 2>/dev/null"))
    return write_text(*bytes, picture.path);
  // The same once more, for its last line about what is wrong.
  std::string messages = gnuplot(arguments + " 2>&1 >/dev/null; true").value_or("");
  CLI::detail::rtrim(messages);
  const std::string last = messages.substr(messages.rfind('\n') + 1),
                    reason = CLI::detail::trim_copy(last.substr(last.find(": ") + 1));
  throw std::runtime_error(
      fmt::format("{}: gnuplot could not draw it: {}", picture.given(), shown(reason)));
}

}  // namespace vibro_impact::runner
