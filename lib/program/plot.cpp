#include "plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "bad_input.hpp"
#include "output.hpp"

namespace vibro_impact::runner {

namespace {

namespace fs = std::filesystem;

constexpr double least_samples = 4000.0, samples_per_period = 40.0, most_samples = 400'000.0;

// Events closer than that, in parts of the width, fall on the same place.
constexpr double resolution = 1.0 / 8000.0;

// The name of gnuplot's terminal for a file.
std::string terminal_of(const std::string &path) {
  if (path.ends_with(".png")) return "pngcairo";
  if (path.ends_with(".pdf")) return "pdfcairo";
  if (path.ends_with(".svg")) return "svg";
  throw BadInput(fmt::format("--plot {}: must end in .png, .pdf or .svg", path));
}

// True when gnuplot, without the settings of the user, takes the script.
bool taken_by_gnuplot(const std::string &script) {
  std::FILE *pipe = popen("gnuplot -d - >/dev/null 2>&1", "w");
  if (pipe == nullptr) return false;
  const bool written = std::fwrite(script.data(), 1, script.size(), pipe) == script.size();
  return pclose(pipe) == 0 && written;
}

// A file name as gnuplot reads it, whatever it consists of. From the root, where neither ~ nor |
// means something.
std::string in_quotes(const fs::path &path) {
  std::string text = "\"";
  for (const char c : fs::absolute(path).string()) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0 || c == '/' || c == '.' || c == '-' || c == '_')
      text.push_back(c);
    else
      fmt::format_to(std::back_inserter(text), "\\{:03o}", byte);
  }
  return text + "\"";
}

// Beside the program, in the build as where it is installed.
fs::path installed_script() {
  return fs::read_symlink("/proc/self/exe").parent_path().parent_path() /
         "share/vibro-impact/plot.gp";
}

double period_of(const Scene &scene) {
  const double fastest = std::sqrt(largest_eigenvalue_bound(scene));
  return 2.0 * std::numbers::pi / (scene.omega > 0.0 ? scene.omega : fastest);
}

}  // namespace

Plot::Plot(const std::string &path, const Scene &scene, const Held &held, double from, double to)
    : scene_(scene),
      from_(from),
      to_(to),
      last_impact_(scene.stops.size(), -std::numeric_limits<double>::infinity()) {
  const std::string terminal = terminal_of(path);
  const Destination file({"--plot", path});
  if (file.direct) throw BadInput(fmt::format("--plot {}: must be a file", path));
  path_ = file.path;
  temporary_ = path_ + ".part";
  if (!(to > from))
    throw BadInput(fmt::format("--plot {}: nothing to be drawn from t = {} to {}", path, from, to));
  const double periods = (to - from) / period_of(scene);
  const double samples = std::max(least_samples, samples_per_period * periods);
  if (!(samples <= most_samples))
    throw BadInput(
        fmt::format("--plot {}: {:.0f} periods, of which no more than {} can be drawn; "
                    "give a later --from",
                    path, periods, most_samples / samples_per_period));
  every_ = (to - from) / std::ceil(samples);
  if (!taken_by_gnuplot(fmt::format("set terminal {}\n", terminal)))
    throw BadInput(
        fmt::format("--plot {}: needs gnuplot with its terminal {}, not found", path, terminal));
  Output({"--plot", path});  // it can be written

  for (int mass = 1; mass <= scene.masses(); ++mass) panels_.push_back({mass});
  for (const Stop &at : scene.stops) {
    Panel &panel = panels_[static_cast<std::size_t>(at.mass - 1)];
    fmt::format_to(std::back_inserter(panel.data[stop]), "0 {:.9g}\n", at.position);
    if (held[static_cast<std::size_t>(at.mass - 1)] == static_cast<signed char>(at.side))
      panel.held_at = &at;
    panel.held_since = from;
  }
  std::ranges::stable_sort(panels_, {},
                           [](const Panel &panel) { return panel.data[stop].empty(); });
  panels_.resize(std::min(panels_.size(), most_masses_drawn), Panel{0});
  std::ranges::sort(panels_, {}, &Panel::mass);
}

void Plot::sample(const Moment &moment) {
  ++taken_;
  add_point(moment);
}

void Plot::add_point(const Moment &moment) {
  for (Panel &panel : panels_)
    fmt::format_to(std::back_inserter(panel.data[displacement]), "{:.9g} {:.6g}\n", moment.time,
                   moment.displacement(panel.mass));
}

void Plot::end_sticking(Panel &panel, double time) {
  if (panel.held_at == nullptr || time < from_) return;
  fmt::format_to(std::back_inserter(panel.data[sticking]), "\n{:.9g} {:.9g}\n{:.9g} {:.9g}\n",
                 std::max(panel.held_since, from_), panel.held_at->position, time,
                 panel.held_at->position);
}

void Plot::event(const Event &event, const Moment &moment) {
  const double apart = (to_ - from_) * resolution;
  const bool seen = event.time >= from_;
  // The lines have their corners where they are.
  if (seen && event.time - last_corner_ > apart) {
    add_point(moment);
    last_corner_ = event.time;
  }
  const auto panel = std::ranges::find(panels_, event.mass, &Panel::mass);
  if (panel == panels_.end()) return;
  const Stop &at = scene_.stops[event.stop];
  if (event.kind == EventKind::impact) {
    if (!seen || event.time - last_impact_[event.stop] < apart) return;
    last_impact_[event.stop] = event.time;
    fmt::format_to(std::back_inserter(panel->data[impact]), "{:.9g} {:.9g}\n", event.time,
                   at.position);
    return;
  }
  if (event.kind == EventKind::release) end_sticking(*panel, event.time);
  panel->held_at = event.kind == EventKind::stick ? &at : nullptr;
  panel->held_since = event.time;
}

// The data, then plot.gp: a block for each layer, with a part for each mass, which begins with a
// row that is not drawn, for it must not be empty.
std::string Plot::script(double time) const {
  static constexpr std::array<const char *, layers> names = {"stop", "sticking", "displacement",
                                                             "impact"};
  std::string text, masses, shown;
  for (const Panel &panel : panels_) masses += fmt::format("{} ", panel.mass);
  for (std::size_t k = 0; k < layers; ++k) {
    bool any = false;
    fmt::format_to(std::back_inserter(text), "${} << END\n", names[k]);
    for (const Panel &panel : panels_) {
      text += "NaN NaN\n" + panel.data[k] + "\n\n";
      any = any || !panel.data[k].empty();
    }
    text += "END\n";
    if (any) shown += fmt::format("{} ", names[k]);
  }
  const double end = std::max(time, from_ + (to_ - from_) * resolution);
  return text + fmt::format(
                    "masses = '{}'\nshown = '{}'\nfrom = {:.17g}\nto = {:.17g}\n"
                    "kind = '{}'\nfile = {}\nload {}\n",
                    masses, shown, from_, end, terminal_of(path_), in_quotes(temporary_),
                    in_quotes(installed_script()));
}

void Plot::draw(double time) {
  for (Panel &panel : panels_) end_sticking(panel, time);
  std::error_code error;
  const bool drawn =
      taken_by_gnuplot(script(time)) && fs::file_size(temporary_, error) > 0 && !error;
  if (drawn) fs::rename(temporary_, path_, error);
  if (drawn && !error) return;
  fs::remove(temporary_, error);
  throw std::runtime_error(fmt::format("--plot {}: gnuplot could not draw it", path_));
}

}  // namespace vibro_impact::runner
