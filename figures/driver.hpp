// What the figure drivers share: the option --output, the error exit, progress, displacement
// tables.
#pragma once

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <mutex>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

#include "paper_scenes.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::figures {

// Creates the folder the tables go to and makes sure, before any work, that they can be written.
// Throws std::runtime_error naming the folder.
inline void open_folder(const std::filesystem::path &folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!std::filesystem::is_directory(folder))
    throw std::runtime_error("--output " + folder.string() + ": cannot be created as a folder");
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    throw std::runtime_error("--output " + folder.string() + ": cannot be written to");
}

// The main function of a driver: reads the options, opens the folder and calls draw(folder).
// Returns the exit status: 0, or 2 after one line on standard error. `add_options` gives the driver
// options beside --output.
template <class AddOptions, class Draw>
int drive(int argc, char **argv, const std::string &purpose, AddOptions &&add_options,
          Draw &&draw) {
  const std::string name = argc > 0 ? std::filesystem::path(argv[0]).filename().string() : "figure";
  std::string output = "build/figures";
  CLI::App options(purpose, name);
  options.add_option("--output", output, "Folder for the tables (created if missing)")
      ->capture_default_str();
  add_options(options);
  std::string error;
  try {
    options.parse(argc, argv);
    open_folder(output);
    draw(std::filesystem::path(output));
    return 0;
  } catch (const CLI::CallForHelp &) {
    fmt::print("{}", options.help());
    return 0;
  } catch (const std::exception &failure) {
    error = failure.what();
  }
  std::replace(error.begin(), error.end(), '\n', ' ');
  fmt::print(stderr, "{}: {}\n", name, error);
  return 2;
}

template <class Draw>
int drive(int argc, char **argv, const std::string &purpose, Draw &&draw) {
  return drive(
      argc, argv, purpose, [](CLI::App &) {}, std::forward<Draw>(draw));
}

// How far a run of more than two seconds has come, on standard error: one line that is rewritten on
// a terminal, a line each further quarter elsewhere. May be called from several threads.
class Progress {
 public:
  Progress(std::string of_what, long long total) : of_what_(std::move(of_what)), total_(total) {
  }

  void advance() {
    const std::lock_guard lock(mutex_);
    const long long percent = 100 * ++done_ / total_;
    const double elapsed =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    const bool last = done_ == total_;
    if (elapsed < 2.0 || (percent < shown_ + (terminal_ ? 1 : 25) && !last)) return;
    shown_ = percent;
    const char *end = terminal_ && !last ? "" : "\n";
    fmt::print(stderr, "{}{}: {} %{}", terminal_ ? "\r" : "", of_what_, percent, end);
    std::fflush(stderr);
  }

 private:
  std::string of_what_;
  long long total_, done_ = 0, shown_ = -25;
  bool terminal_ = isatty(STDERR_FILENO) != 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::mutex mutex_ = {};
};

// A run shown as displacement against time resolves all chatter that can be seen.
inline RunOptions all_visible_chatter() {
  RunOptions options;
  options.resolve_chatter = paper::slowest_impact_shown;
  return options;
}

// Samples both masses across the window of a panel.
inline SampleRecorder samples_across(const paper::AxisBox &box, double every) {
  SampleRecorder samples;
  samples.from = box.from;
  samples.to = box.to;
  samples.every = every;
  samples.masses = 2;
  return samples;
}

// The samples of both masses as a table t, x1, x2.
inline Table displacement_table(const SampleRecorder &samples) {
  Table table("t,x1,x2");
  for (std::size_t i = 0; i < samples.times.size(); ++i)
    table.row(samples.times[i], samples.displacements[2 * i], samples.displacements[2 * i + 1]);
  return table;
}

}  // namespace vibro_impact::figures
