// The scene runner as a program: run in a folder of its own, its output read back.
#pragma once

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace vibro_impact::testing {

namespace fs = std::filesystem;

// Programs started from here give memory back at once: address sanitizer keeps what has been freed,
// up to 256 MB of it, which is no memory of the program.
inline void without_quarantine() {
  setenv("ASAN_OPTIONS", "quarantine_size_mb=0:thread_local_quarantine_size_kb=0", 0);
}

// What a run of the program left behind.
struct Result {
  int status;
  std::string out, err;
  long peak_memory;  // KiB
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

// The rows of a table without its header line.
inline std::string below_header(const std::string &table) {
  return table.substr(std::min(table.find('\n') + 1, table.size()));
}

// The first line in which two texts differ; nothing when they are the same.
inline std::string first_difference(const std::string &one, const std::string &two) {
  if (one == two) return "";
  const auto first = lines(one), second = lines(two);
  std::size_t line = 0;
  while (line < first.size() && line < second.size() && first[line] == second[line]) ++line;
  const auto shown = [line](const std::vector<std::string> &of) {
    return line < of.size() ? of[line] : std::string("(the end)");
  };
  return "line " + std::to_string(line + 1) + ": " + shown(first) + " | " + shown(second);
}

// True for one line that the program has written as its error message.
inline bool is_one_message(const std::string &text) {
  return text.rfind("vibro-impact: ", 0) == 0 && text.find('\n') == text.size() - 1;
}

// Two or more processes, where the program was built with MPI.
inline std::string mpirun(int processes) {
  return "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 " MPIRUN
         " --oversubscribe -n " +
         std::to_string(processes) + " ";
}
constexpr bool with_mpi = MPIRUN[0] != '\0';

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
             const std::string &by = "") const {
    const fs::path out = folder / "out.txt", err = folder / "err.txt";
    const std::string command = "cd " + folder.string() + " && " + before + " && { " + by +
                                VIBRO_IMPACT_PROGRAM " " + arguments + "; } >" + out.string() +
                                " 2>" + err.string();
    const pid_t shell = fork();
    if (shell == 0) {
      execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
      _exit(127);
    }
    int status = 0;
    rusage used = {};
    EXPECT_EQ(wait4(shell, &status, 0, &used), shell);
    Result result{WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(out), contents(err),
                  used.ru_maxrss};
    fs::remove(out);
    fs::remove(err);
    return result;
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
