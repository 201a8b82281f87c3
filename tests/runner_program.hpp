// The scene runner as a program: run in a folder of its own, its output read back.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace vibro_impact::testing {

namespace fs = std::filesystem;

// What a run of the program left behind.
struct Result {
  int status;
  std::string out, err;
};

inline std::string contents(const fs::path &path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

inline std::vector<std::string> cells(const std::string &row) {
  std::vector<std::string> found;
  std::istringstream stream(row);
  for (std::string cell; std::getline(stream, cell, ',');) found.push_back(cell);
  return found;
}

inline std::vector<std::string> lines(const std::string &text) {
  std::vector<std::string> found;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) found.push_back(line);
  return found;
}

// A folder of its own for every test, in which the program runs.
struct Runner : ::testing::Test {
  fs::path folder;

  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "vibro-impact-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder = pattern;
  }
  void TearDown() override {
    fs::remove_all(folder);
  }
  Result run(const std::string &arguments) const {
    const fs::path out = folder / "out.txt", err = folder / "err.txt";
    const std::string command = "cd " + folder.string() + " && " VIBRO_IMPACT_PROGRAM " " +
                                arguments + " >" + out.string() + " 2>" + err.string();
    const int status = std::system(command.c_str());
    Result result{WEXITSTATUS(status), contents(out), contents(err)};
    fs::remove(out);
    fs::remove(err);
    return result;
  }
};

}  // namespace vibro_impact::testing
