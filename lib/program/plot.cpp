#include "plot.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <numbers>
#include <numeric>
#include <sstream>
#include <stdexcept>

#include "refuse.hpp"

namespace vibro_impact::runner {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_masses = 8;
constexpr double least_samples = 4000.0, samples_per_period = 40.0, most_samples = 400'000.0;

// Impacts at a stop closer than that, in parts of the width, fall on the same place.
constexpr double resolution = 1.0 / 8000.0;

// The name of gnuplot's terminal for a file.
std::string terminal_of(const std::string &path) {
  if (path.ends_with(".png")) return "pngcairo";
  if (path.ends_with(".pdf")) return "pdfcairo";
  if (path.ends_with(".svg")) return "svg";
  refuse("--plot {}: must end in .png, .pdf or .svg", path);
}

// True when gnuplot, without the settings of the user, takes the script and draws to `path`, a name
// that the shell need not quote.
bool taken_by_gnuplot(const std::string &script, const std::string &path) {
  setenv("VIBRO_IMPACT_PLOT", path.c_str(), 1);
  std::FILE *pipe = popen("gnuplot -d - >\"$VIBRO_IMPACT_PLOT\" 2>/dev/null", "w");
  if (pipe == nullptr) return false;
  const bool written = std::fwrite(script.data(), 1, script.size(), pipe) == script.size();
  return pclose(pipe) == 0 && written;
}

// Beside the program, in the build as where it is installed.
std::string installed_script() {
  std::ostringstream text;
  text << std::ifstream(fs::read_symlink("/proc/self/exe").parent_path().parent_path() /
                        "share/vibro-impact/plot.gp")
              .rdbuf();
  return text.str();
}

double period_of(const Scene &scene) {
  const double fastest = std::sqrt(largest_eigenvalue_bound(scene));
  return 2.0 * std::numbers::pi / (scene.omega > 0.0 ? scene.omega : fastest);
}

// Those with stops before the others.
std::vector<int> masses_drawn(const Scene &scene) {
  std::vector<int> masses(static_cast<std::size_t>(scene.masses()));
  std::iota(masses.begin(), masses.end(), 1);
  std::ranges::stable_partition(masses, [&scene](int mass) {
    return std::ranges::count(scene.stops, mass, &Stop::mass) > 0;
  });
  masses.resize(std::min(masses.size(), most_masses));
  std::ranges::sort(masses);
  return masses;
}

}  // namespace

Plot::Plot(const std::string &path, const Scene &scene, double from, double to)
    : path_(path),
      terminal_(terminal_of(path)),
      file_(path),
      scene_(scene),
      from_(from),
      to_(to),
      masses_(masses_drawn(scene)),
      last_impact_(scene.stops.size(), -std::numeric_limits<double>::infinity()) {
  if (file_.temporary().empty()) refuse("--plot {}: must be a file", path);
  if (!(to > from)) refuse("--plot {}: nothing to be drawn from t = {} to {}", path, from, to);
  const double periods = (to - from) / period_of(scene);
  const double samples = std::max(least_samples, samples_per_period * periods);
  if (!(samples <= most_samples))
    refuse("--plot {}: {:.0f} periods, of which no more than {} can be drawn; give a later --from",
           path, periods, most_samples / samples_per_period);
  every_ = (to - from) / std::ceil(samples);
  if (!taken_by_gnuplot(fmt::format("set terminal {}\n", terminal_), "/dev/null"))
    refuse("--plot {}: needs gnuplot with its terminal {}, not found", path, terminal_);
}

void Plot::sample(const Moment &moment) {
  ++taken_;
  auto row = std::back_inserter(displacements_);
  fmt::format_to(row, "{:.9g}", moment.time);
  for (const int mass : masses_) {
    const double x = moment.displacement(mass);
    const bool held = !std::isnan(moment.hold_force(mass));
    fmt::format_to(row, " {:.6g} {}", x, held ? fmt::format("{:.6g}", x) : "NaN");
    sticks_ = sticks_ || held;
  }
  displacements_ += "\n";
}

void Plot::event(const Event &event, const Moment &) {
  double &last = last_impact_[event.stop];
  if (event.kind != EventKind::impact || event.time < from_ ||
      event.time - last < (to_ - from_) * resolution)
    return;
  last = event.time;
  fmt::format_to(std::back_inserter(impacts_), "{:.9g} {} {:.9g}\n", event.time, event.mass,
                 scene_.stops[event.stop].position);
}

void Plot::draw(double time) {
  std::string stops;
  for (const Stop &stop : scene_.stops)
    stops += fmt::format("{} {:.9g}\n", stop.mass, stop.position);
  std::string script, layers;
  for (const auto &[name, rows] :
       {std::pair{"stop", &stops}, {"displacement", &displacements_}, {"impact", &impacts_}}) {
    script += fmt::format("${} << END\nNaN NaN NaN\n{}END\n", name, *rows);
    if (!rows->empty()) layers += fmt::format("{} ", name);
  }
  if (sticks_) layers += "sticking";
  script += fmt::format("masses = '{}'\nlayers = '{}'\nfrom = {:.17g}\nto = {:.17g}\nkind = '{}'\n",
                        fmt::join(masses_, " "), layers, from_,
                        std::max(time, from_ + (to_ - from_) * resolution), terminal_);
  if (!taken_by_gnuplot(script + installed_script(), file_.temporary()) ||
      fs::file_size(file_.temporary()) == 0)
    throw std::runtime_error(fmt::format("--plot {}: gnuplot could not draw it", path_));
  file_.complete();
  file_.put_in_place();
}

}  // namespace vibro_impact::runner
