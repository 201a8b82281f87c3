#include "plot.hpp"

#include <fmt/ranges.h>

#include <cstdlib>
#include <filesystem>
#include <regex>
#include <vector>

#include "refuse.hpp"

namespace vibro_impact::runner {

namespace {

namespace fs = std::filesystem;

// The name of gnuplot's terminal for a file.
std::string terminal_of(const std::string &path) {
  if (path.ends_with(".png")) return "pngcairo";
  if (path.ends_with(".pdf")) return "pdfcairo";
  if (path.ends_with(".svg")) return "svg";
  refuse("--plot {}: must end in .png, .pdf or .svg", path);
}

// A word of a command of the shell.
std::string quoted(const std::string &word) {
  return fmt::format("'{}'", std::regex_replace(word, std::regex("'"), "'\\''"));
}

// Runs gnuplot without the settings of the user; true when it does what it is told.
bool gnuplot(const std::string &arguments) {
  return std::system(fmt::format("gnuplot -d {} 2>/dev/null", arguments).c_str()) == 0;
}

bool is_file(const std::string &path) {
  return !path.empty() && path != "-";
}

}  // namespace

void check_plot(const RunRequest &request) {
  const std::string terminal = terminal_of(request.plot);
  if (!is_file(request.samples))
    refuse("--plot {}: is drawn from the table of --samples, which must be a file", request.plot);
  if (!gnuplot(fmt::format("-e 'set terminal {}'", terminal)))
    refuse("--plot {}: needs gnuplot with its terminal {}, not found", request.plot, terminal);
}

void draw(const RunRequest &request) {
  const Scene &scene = request.scene;
  std::vector<std::string> lower(static_cast<std::size_t>(scene.masses()), "NaN"), upper = lower;
  for (const Stop &stop : scene.stops)
    (stop.side == Side::lower ? lower : upper)[static_cast<std::size_t>(stop.mass) - 1] =
        fmt::format("{:.17g}", stop.position);
  // Beside the program, in the build folder as where it is installed.
  const fs::path script =
      fs::read_symlink("/proc/self/exe").parent_path() / "../share/vibro-impact/plot.gp";
  const std::string samples = fs::absolute(request.samples).string(),
                    events = is_file(request.events) ? fs::absolute(request.events).string()
                                                     : "/dev/null",
                    temporary = request.plot + ".part";
  const bool drawn = gnuplot(fmt::format(
      "-c {} {} {} {} '{}' '{}' >{}", quoted(script), terminal_of(request.plot), quoted(samples),
      quoted(events), fmt::join(lower, " "), fmt::join(upper, " "), quoted(temporary)));
  std::error_code failed;
  if (drawn) fs::rename(temporary, request.plot, failed);
  if (drawn && !failed) return;
  fs::remove(temporary, failed);
  throw std::runtime_error(fmt::format("--plot {}: gnuplot could not draw it", request.plot));
}

}  // namespace vibro_impact::runner
