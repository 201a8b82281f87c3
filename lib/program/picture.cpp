#include "picture.hpp"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <regex>

#include "files.hpp"
#include "scene_options.hpp"

namespace vibro_impact::runner {

namespace {

namespace fs = std::filesystem;

// The name of gnuplot's terminal for a file.
std::string terminal_of(const Picture &picture) {
  if (picture.path.ends_with(".png")) return "pngcairo";
  if (picture.path.ends_with(".pdf")) return "pdfcairo";
  if (picture.path.ends_with(".svg")) return "svg";
  refuse("{} {}: must end in .png, .pdf or .svg", picture.option, picture.path);
}

// The script stands beside the program, in the build folder as where it is installed.
fs::path script() {
  return fs::read_symlink("/proc/self/exe").parent_path() / "../share/vibro-impact/plot.gp";
}

// A word of a command of the shell.
std::string quoted(const std::string &word) {
  return fmt::format("'{}'", std::regex_replace(word, std::regex("'"), "'\\''"));
}

struct Drawing {
  bool succeeded;
  std::string output, messages;
};

std::string contents(std::FILE *file) {
  std::string text;
  for (int c; (c = std::fgetc(file)) != EOF;) text.push_back(static_cast<char>(c));
  return text;
}

// Runs gnuplot without the settings of the user.
Drawing gnuplot(const std::string &arguments) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE *)> messages(std::tmpfile(), std::fclose);
  if (!messages) throw std::runtime_error("no temporary file can be made");
  const std::string command = fmt::format("gnuplot -d {} 2>&{}", arguments, fileno(messages.get()));
  std::FILE *output = popen(command.c_str(), "r");
  if (output == nullptr) throw std::runtime_error("gnuplot cannot be started");
  Drawing drawing{false, contents(output), ""};
  drawing.succeeded = pclose(output) == 0;
  std::rewind(messages.get());
  drawing.messages = contents(messages.get());
  return drawing;
}

}  // namespace

void check_picture(const Picture &picture, const std::string &of, const std::string &table) {
  const std::string terminal = terminal_of(picture);
  if (table.empty() || table == "-")
    refuse("{} {}: is drawn from the table of {}, which must be a file", picture.option,
           picture.path, of);
  if (!fs::exists(script()))
    refuse("{} {}: needs its script {}, which is not there", picture.option, picture.path,
           script().string());
  if (!gnuplot(fmt::format("-e 'set terminal {}'", terminal)).succeeded)
    refuse("{} {}: needs gnuplot with its terminal {}, not found", picture.option, picture.path,
           terminal);
}

void draw(const Picture &picture, const std::string &kind,
          const std::vector<std::string> &arguments) {
  std::string words =
      fmt::format("-c {} {} {}", quoted(script()), terminal_of(picture), quoted(kind));
  for (const std::string &argument : arguments) words += " " + quoted(argument);
  const Drawing drawing = gnuplot(words);
  if (drawing.succeeded) return write_text(drawing.output, picture.path);
  const auto lines = split(drawing.messages, '\n');
  std::string last;
  for (const std::string &line : lines)
    if (!line.empty()) last = line;
  throw std::runtime_error(fmt::format("{} {}: gnuplot could not draw it: {}", picture.option,
                                       picture.path, shown(last.substr(last.find(": ") + 1))));
}

}  // namespace vibro_impact::runner
