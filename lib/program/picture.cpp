#include "picture.hpp"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <regex>

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

// The script stands beside the program, in the build folder as where it is installed.
std::string script() {
  return fs::read_symlink("/proc/self/exe").parent_path() / "../share/vibro-impact/plot.gp";
}

// A word of a command of the shell.
std::string quoted(const std::string &word) {
  return fmt::format(" '{}'", std::regex_replace(word, std::regex("'"), "'\\''"));
}

struct Drawing {
  std::string output, messages;
  bool succeeded;
};

// Runs gnuplot without the settings of the user.
Drawing gnuplot(const std::string &arguments) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE *)> messages(std::tmpfile(), std::fclose);
  if (!messages) throw std::runtime_error("no temporary file can be made");
  const std::string command = fmt::format("gnuplot -d {} 2>&{}", arguments, fileno(messages.get()));
  std::FILE *output = popen(command.c_str(), "r");
  if (output == nullptr) throw std::runtime_error("gnuplot cannot be started");
  const std::string bytes = contents(path_of(output));
  const bool succeeded = pclose(output) == 0;
  return {bytes, contents(path_of(messages.get())), succeeded};
}

}  // namespace

void check_picture(const Output &picture, const Output &table) {
  const std::string terminal = terminal_of(picture);
  if (!table.is_file())
    refuse("{}: is drawn from the table of {}, which must be a file", picture.given(),
           table.option);
  if (!fs::exists(script()))
    refuse("{}: needs its script {}, which is not there", picture.given(), script());
  if (!gnuplot("-e 'set terminal " + terminal + "'").succeeded)
    refuse("{}: needs gnuplot with its terminal {}, not found", picture.given(), terminal);
}

void draw(const Output &picture, const std::string &kind, const std::vector<Output> &tables,
          const std::vector<std::string> &words) {
  std::string arguments = "-c" + quoted(script()) + quoted(terminal_of(picture)) + quoted(kind);
  for (const Output &table : tables)
    arguments += quoted(table.is_file() ? fs::absolute(table.path).string() : "/dev/null");
  for (const std::string &word : words) arguments += quoted(word);
  const auto [output, messages, succeeded] = gnuplot(arguments);
  if (succeeded) return write_text(output, picture.path);
  std::string last;
  for (const std::string &line : split(messages, '\n'))
    if (!line.empty()) last = line;
  throw std::runtime_error(fmt::format("{}: gnuplot could not draw it: {}", picture.given(),
                                       shown(last.substr(last.find(": ") + 1))));
}

}  // namespace vibro_impact::runner
