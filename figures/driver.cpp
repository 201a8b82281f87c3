#include "driver.hpp"

#include <unistd.h>

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <system_error>

namespace vibro_impact::figures {

namespace {

// Throws std::runtime_error naming the folder.
void open_folder(const std::filesystem::path &folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!std::filesystem::is_directory(folder))
    throw std::runtime_error("--output " + folder.string() + ": cannot be created as a folder");
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    throw std::runtime_error("--output " + folder.string() + ": cannot be written to");
}

}  // namespace

int run_program(int argc, char **argv, const std::string &purpose,
                const std::vector<Option> &options, const std::function<int()> &run) {
  const std::string name = argc > 0 ? std::filesystem::path(argv[0]).filename().string() : "figure";
  std::string error;
  CLI::App app(purpose, name);
  try {
    for (const auto &[option, meaning, value] : options)
      app.add_option(option, *value, meaning)->capture_default_str();
    app.parse(argc, argv);
    return run();
  } catch (const CLI::CallForHelp &) {
    fmt::print("{}", app.help());
    return 0;
  } catch (const std::exception &failure) {
    error = failure.what();
  }
  std::replace(error.begin(), error.end(), '\n', ' ');
  fmt::print(stderr, "{}: {}\n", name, error);
  return 2;
}

int main_of_driver(int argc, char **argv, const std::string &purpose,
                   const std::function<void(const std::filesystem::path &)> &draw,
                   std::vector<Option> options) {
  std::string output = "build/figures";
  options.push_back({"--output", "Folder for the tables (created if missing)", &output});
  return run_program(argc, argv, purpose, options, [&] {
    open_folder(output);
    draw(output);
    return 0;
  });
}

}  // namespace vibro_impact::figures
