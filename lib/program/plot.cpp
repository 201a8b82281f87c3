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

// True when gnuplot, without the settings of the user, does what it is told.
bool gnuplot(const std::string &arguments) {
  return std::system(fmt::format("gnuplot -d {} 2>/dev/null", arguments).c_str()) == 0;
}

// The table as gnuplot finds it; one that cannot be read again is empty.
std::string table_at(const std::string &name) {
  const Destination to(name);
  return quoted(name.empty() || to.direct ? "/dev/null" : fs::absolute(to.path).string());
}

}  // namespace

void check_plot(const Request &request) {
  const std::string terminal = terminal_of(request.plot);
  if (request.samples.empty() || Destination(request.samples).direct ||
      Destination(request.plot).direct)
    refuse("--plot {}: is drawn from the table of --samples; both must be files", request.plot);
  if (!gnuplot(fmt::format("-e 'set terminal {}'", terminal)))
    refuse("--plot {}: needs gnuplot with its terminal {}, not found", request.plot, terminal);
}

void draw(const Request &request, const Scene &scene, Output &picture) {
  std::vector<std::string> lower(static_cast<std::size_t>(scene.masses()), "NaN"), upper = lower;
  for (const Stop &stop : scene.stops)
    (stop.side == Side::lower ? lower : upper)[static_cast<std::size_t>(stop.mass) - 1] =
        fmt::format("{:.17g}", stop.position);
  // Beside the program, in the build as where it is installed.
  const fs::path script =
      fs::read_symlink("/proc/self/exe").parent_path() / "../share/vibro-impact/plot.gp";
  if (!gnuplot(fmt::format("-c {} {} {} {} '{}' '{}' >{}", quoted(script),
                           terminal_of(request.plot), table_at(request.samples),
                           table_at(request.events), fmt::join(lower, " "), fmt::join(upper, " "),
                           quoted(picture.temporary()))))
    throw std::runtime_error(fmt::format("--plot {}: gnuplot could not draw it", request.plot));
  picture.complete();
  picture.put_in_place();
}

}  // namespace vibro_impact::runner
