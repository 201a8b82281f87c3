#include "plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <memory>
#include <numbers>
#include <stdexcept>

#include "bad_input.hpp"

namespace vibro_impact::runner {

namespace {

constexpr double least_samples = 4000.0, samples_per_period = 40.0, most_samples = 400'000.0;

// Events closer than that, in parts of the width, fall on the same place.
constexpr double resolution = 1.0 / 8000.0;

struct Terminal {
  const char *ending, *name;
  const char *settings;  // with the place of the height of the paper
};

constexpr std::array terminals = {
    Terminal{".png", "pngcairo", "size 1400,{} font 'Liberation Serif,22' linewidth 2"},
    Terminal{".pdf", "pdfcairo", "size 14in,{}in font 'Liberation Serif,22' linewidth 2"},
    Terminal{".svg", "svg", "size 1400,{} font 'Liberation Serif,22' linewidth 2"},
};

const Terminal &terminal_of(const std::string &path) {
  for (const Terminal &terminal : terminals)
    if (path.ends_with(terminal.ending)) return terminal;
  throw BadInput(fmt::format("--plot {}: must end in .png, .pdf or .svg", path));
}

struct Close {
  void operator()(std::FILE *pipe) const {
    pclose(pipe);
  }
};

// True when gnuplot, without the settings of the user, takes the script.
bool taken_by_gnuplot(const std::string &script) {
  std::unique_ptr<std::FILE, Close> pipe(popen("gnuplot -d - >/dev/null 2>&1", "w"));
  if (!pipe) return false;
  const bool written = std::fwrite(script.data(), 1, script.size(), pipe.get()) == script.size();
  return pclose(pipe.release()) == 0 && written;
}

// A file name as gnuplot reads it, whatever it consists of. From the root, where neither ~ nor |
// means something.
std::string quoted(const std::string &path) {
  std::string text = "\"";
  for (const char c : std::filesystem::absolute(path).string()) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0 || c == '/' || c == '.' || c == '-' || c == '_')
      text.push_back(c);
    else
      fmt::format_to(std::back_inserter(text), "\\{:03o}", byte);
  }
  return text + "\"";
}

double period_of(const Scene &scene) {
  const double fastest = std::sqrt(largest_eigenvalue_bound(scene));
  return 2.0 * std::numbers::pi / (scene.omega > 0.0 ? scene.omega : fastest);
}

}  // namespace

Plot::Plot(const Destination &file, const Scene &scene, const Held &held, double from, double to)
    : file_(file), scene_(scene), from_(from), to_(to) {
  if (file.direct) throw BadInput(fmt::format("--plot {}: must be a file", file.path));
  const Terminal &terminal = terminal_of(file.path);
  if (!(to > from))
    throw BadInput(
        fmt::format("--plot {}: nothing to be drawn from t = {} to {}", file.path, from, to));
  const double periods = (to - from) / period_of(scene);
  const double samples = std::max(least_samples, samples_per_period * periods);
  if (!(samples <= most_samples))
    throw BadInput(
        fmt::format("--plot {}: {:.0f} periods, of which no more than {} can be drawn; "
                    "give a later --from",
                    file.path, periods, most_samples / samples_per_period));
  every_ = (to - from) / std::ceil(samples);
  if (!taken_by_gnuplot(fmt::format("set terminal {}\n", terminal.name)))
    throw BadInput(fmt::format("--plot {}: needs gnuplot with its terminal {}, not found",
                               file.path, terminal.name));

  std::vector<int> masses(static_cast<std::size_t>(scene.masses()));
  for (std::size_t i = 0; i < masses.size(); ++i) masses[i] = static_cast<int>(i) + 1;
  const auto without_stop = [&](int mass) {
    return std::none_of(scene.stops.begin(), scene.stops.end(),
                        [mass](const Stop &stop) { return stop.mass == mass; });
  };
  std::ranges::sort(masses, {}, [&](int mass) { return std::pair(without_stop(mass), mass); });
  masses.resize(std::min(masses.size(), most_masses_drawn));
  std::sort(masses.begin(), masses.end());
  for (const int mass : masses) {
    Panel panel{mass, ""};
    for (const Stop &stop : scene.stops) {
      if (stop.mass != mass) continue;
      fmt::format_to(std::back_inserter(panel.stops), "{:.9g}\n", stop.position);
      const auto i = static_cast<std::size_t>(mass - 1);
      if (held[i] == static_cast<signed char>(stop.side)) panel.held_at = &stop;
    }
    panel.held_since = from;
    panels_.push_back(std::move(panel));
  }
}

double Plot::next_time() const {
  return sample_time(from_, to_, every_, taken_);
}

void Plot::sample(const Moment &moment) {
  ++taken_;
  add_point(moment);
}

void Plot::add_point(const Moment &moment) {
  for (Panel &panel : panels_)
    fmt::format_to(std::back_inserter(panel.line), "{:.9g} {:.6g}\n", moment.time,
                   moment.displacement(panel.mass));
}

void Plot::end_sticking(Panel &panel, double time) {
  if (panel.held_at == nullptr || time < from_) return;
  fmt::format_to(std::back_inserter(panel.sticking), "{:.9g} {:.9g}\n{:.9g} {:.9g}\n\n",
                 std::max(panel.held_since, from_), panel.held_at->position, time,
                 panel.held_at->position);
}

void Plot::event(const Event &event, const Moment &moment) {
  const double apart = (to_ - from_) * resolution;
  const bool seen = event.time >= from_;
  // The lines have their corners where they are.
  if (seen && event.time - last_event_ > apart) {
    add_point(moment);
    last_event_ = event.time;
  }
  const Stop &stop = scene_.stops[event.stop];
  const auto panel = std::find_if(panels_.begin(), panels_.end(),
                                  [&](const Panel &one) { return one.mass == event.mass; });
  if (panel == panels_.end()) return;
  if (event.kind == EventKind::impact) {
    const auto [last, first] = last_impact_.try_emplace(event.stop, event.time);
    if (!seen || (!first && last->second >= from_ && event.time - last->second < apart)) return;
    last->second = event.time;
    fmt::format_to(std::back_inserter(panel->impacts), "{:.9g} {:.9g}\n", event.time,
                   stop.position);
    return;
  }
  if (event.kind == EventKind::release) end_sticking(*panel, event.time);
  panel->held_at = event.kind == EventKind::stick ? &stop : nullptr;
  panel->held_since = event.time;
}

// What a panel consists of, from the back to the front.
struct Plot::Layer {
  const char *name;
  std::string Panel::*data;
  const char *style, *key;
};

std::string Plot::script(double time) const {
  static constexpr std::array layers = {
      Layer{"stop", &Panel::stops, "using (from):1:(to-from):(0) with vectors nohead linestyle 3",
            "lines linestyle 3"},
      Layer{"sticking", &Panel::sticking, "with lines linestyle 4", "lines linestyle 4"},
      Layer{"displacement", &Panel::line, "with lines linestyle 1", "lines linestyle 1"},
      Layer{"impact", &Panel::impacts, "with points linestyle 2", "points linestyle 2"}};
  const Terminal &terminal = terminal_of(file_.path);
  const std::size_t rows = panels_.size();
  const double height = 130.0 + 370.0 * static_cast<double>(rows);
  std::string text = fmt::format(
      "set terminal {} {}\nset output {}\n", terminal.name,
      fmt::format(fmt::runtime(terminal.settings),
                  std::string_view(terminal.name) == "pdfcairo" ? height / 100.0 : height),
      quoted(file_.temporary()));
  text +=
      "set encoding utf8\n"
      "set border linewidth 0.7 linecolor rgb '#202020'\n"
      "set tics nomirror out scale 0.6\n"
      "set key outside top right horizontal reverse Left samplen 2.5 noautotitle\n"
      "set style line 1 linecolor rgb '#12355b' linewidth 1.0\n"
      "set style line 2 linecolor rgb '#c8442c' linewidth 0.7 pointtype 6 pointsize 0.7\n"
      "set style line 3 linecolor rgb '#404040' linewidth 0.6 dashtype (4, 5)\n"
      "set style line 4 linecolor rgb '#e0a030' linewidth 4\n"
      "set lmargin 11\nset rmargin 3\nset offsets 0, 0, graph 0.06, graph 0.06\n";
  fmt::format_to(std::back_inserter(text),
                 "from = {:.17g}\nto = {:.17g}\nset xrange [from:to]\n"
                 "set multiplot layout {},1\n",
                 from_, std::max(time, from_ + (to_ - from_) * resolution), rows);
  for (const Panel &panel : panels_)
    for (const Layer &layer : layers)
      fmt::format_to(std::back_inserter(text), "${}{} << END\n{}END\n", layer.name, panel.mass,
                     panel.*layer.data);
  for (const Panel &panel : panels_) {
    if (&panel == &panels_.back()) text += "set xlabel 'time'\n";
    fmt::format_to(std::back_inserter(text), "set ylabel 'x_{{{}}}'\nplot ", panel.mass);
    for (const Layer &layer : layers) {
      const std::string &data = panel.*layer.data;
      if (!data.empty())
        fmt::format_to(std::back_inserter(text), "${}{} {}, ", layer.name, panel.mass, layer.style);
      // What any panel shows stands above the first.
      if (&panel == &panels_.front() &&
          std::any_of(panels_.begin(), panels_.end(),
                      [&](const Panel &one) { return !(one.*layer.data).empty(); }))
        fmt::format_to(std::back_inserter(text), "NaN with {} title '{}', ", layer.key, layer.name);
    }
    text += "NaN notitle\n";
  }
  return text + "unset multiplot\nset output\n";
}

void Plot::draw(double time) {
  for (Panel &panel : panels_) end_sticking(panel, time);
  std::error_code error;
  const bool drawn = taken_by_gnuplot(script(time)) &&
                     std::filesystem::file_size(file_.temporary(), error) > 0 && !error;
  if (drawn) std::filesystem::rename(file_.temporary(), file_.path, error);
  if (drawn && !error) return;
  std::filesystem::remove(file_.temporary(), error);
  throw std::runtime_error(fmt::format("--plot {}: gnuplot could not draw it", file_.path));
}

}  // namespace vibro_impact::runner
