// The program as a user starts it: in a folder of its own, its output read back.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tables.hpp"

namespace vibro_impact::testing {

namespace fs = std::filesystem;

// The output of a run of the program.
struct Result {
  int status;
  std::string out, err;
};

inline std::string contents(const fs::path &path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

inline std::vector<std::string> lines(const std::string &text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// The program ended with this status and wrote one line, its message, which has these words.
inline void expect_message(const Result &result, const std::string &words, int status = 2) {
  EXPECT_EQ(result.status, status) << words;
  EXPECT_TRUE(result.err.starts_with("vibro-impact: ")) << result.err;
  EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << result.err;
  EXPECT_NE(result.err.find(words), std::string::npos) << result.err << "instead of " << words;
}

// For the shell, before the program: no file can grow beyond this size, a multiple of 512 bytes.
inline std::string full_disk(int bytes) {
  return "trap '' XFSZ && ulimit -f " + std::to_string(bytes / 512);
}

inline bool there_is_gnuplot() {
  return std::system("gnuplot -d -e 'set terminal pngcairo' >/dev/null 2>&1") == 0;
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
  // `before`: what the shell does first; `by`: what starts the program.
  Result run(const std::string &arguments, const std::string &before = "true",
             const std::string &by = "", const std::string &program = VIBRO_IMPACT_PROGRAM) const {
    const fs::path out = folder / "out.txt", err = folder / "err.txt";
    const std::string command = "cd '" + folder.string() + "' && " + before + " && { " + by + "'" +
                                program + "' " + arguments + "; } >'" + out.string() + "' 2>'" +
                                err.string() + "'";
    const int status = std::system(command.c_str());
    Result result{WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(out), contents(err)};
    fs::remove(out);
    fs::remove(err);
    return result;
  }
  // A table that the program has written there.
  truth::Rows table(const std::string &name) const {
    return truth::read_rows(folder / name);
  }
  // The names of the files left, in order.
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto &entry : fs::directory_iterator(folder))
      names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  }
};

}  // namespace vibro_impact::testing
