// The journal of a sweep: what is done to its file while a sweep runs, or between two sweeps, does
// not change the tables unnoticed.
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "program/files.hpp"
#include "tests/support/runner_program.hpp"

namespace {

using namespace vibro_impact::testing;
using vibro_impact::runner::Journal;
using vibro_impact::runner::Texts;

const std::string journal_head = "a sweep\nk,value\n";

std::string row(std::size_t k) {
  return std::to_string(k) + "," + std::to_string(k * k) + "\n";
}
// Row k begins with k, and there are 100 of them.
bool rule(std::size_t k, std::string_view line) {
  return k < 100 && line.starts_with(std::to_string(k) + ",");
}
// A block of ten rows, with impacts and a section.
Texts block(std::size_t first) {
  Texts block;
  for (std::size_t k = first; k < first + 10; ++k) {
    block[0] += row(k);
    block[1] += "1," + row(k);
    block[2] += "2," + row(k);
  }
  return block;
}
void write(const fs::path &path, const std::string &text) {
  std::ofstream(path, std::ios::binary) << text;
}
std::size_t middle(const std::string &text) {
  return text.find("15,225");
}

// Thirteen ways to touch the file, given its path and its text, and why a sweep that goes on
// refuses it. A block has 33 lines, below two of the head, and row 15 is line 41.
struct Touch {
  const char *name;
  std::function<void(const fs::path &, std::string)> apply;
  const char *refusal = "";
};
const std::vector<Touch> touches = {
    {"cut to nothing", [](auto &path, auto) { fs::resize_file(path, 0); }},
    {"cut in the head", [](auto &path, auto) { fs::resize_file(path, 10); }},
    {"cut in a block", [](auto &path, auto text) { fs::resize_file(path, middle(text)); }},
    {"cut by one character", [](auto &path, auto text) { fs::resize_file(path, text.size() - 1); }},
    {"a digit edited",
     [](auto &path, auto text) { write(path, text.replace(middle(text) + 3, 1, "9")); },
     "line 101: the rows above do not fit it"},
    {"a row deleted", [](auto &path, auto text) { write(path, text.erase(middle(text), 7)); },
     "line 41: not the row of its point"},
    {"a row doubled",
     [](auto &path, auto text) { write(path, text.insert(middle(text), "15,225\n")); },
     "line 42: not the row of its point"},
    {"a row emptied",
     [](auto &path, auto text) { write(path, text.replace(middle(text), 6, "15,")); },
     "line 101: the rows above do not fit it"},
    {"a row appended", [](auto &path, auto text) { write(path, text + "30,900\n"); }},
    {"its blocks doubled",
     [](auto &path, auto text) { write(path, text + text.substr(journal_head.size())); },
     "line 102: not the row of its point"},
    {"deleted", [](auto &path, auto) { fs::remove(path); }},
    {"renamed", [](auto &path, auto) { fs::rename(path, path.string() + ".old"); }},
    {"replaced",
     [](auto &path, auto) {
       fs::remove(path);
       write(path, "something else\n");
     },
     "not the rows of this sweep"},
};

struct JournalFile : Runner {
  fs::path path() const {
    return folder / "t.csv.partial";
  }
  Journal open(bool resume) const {
    return Journal(path().string(), journal_head, resume, rule);
  }
};

TEST_F(JournalFile, WhatIsDoneToItDuringASweepIsSeenAndHarmless) {
  for (const auto &[name, apply, refusal] : touches) {
    fs::remove_all(folder);
    fs::create_directory(folder);
    Journal journal = open(false);
    journal.add(block(0));
    journal.add(block(10));
    apply(path(), contents(path()));
    journal.add(block(20));
    EXPECT_EQ(journal.size(), 30u) << name;
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(journal.rows()[k], block(0)[k] + block(10)[k] + block(20)[k]) << name;
    EXPECT_FALSE(journal.remove()) << name;
    EXPECT_EQ(fs::exists(path()), std::string(name) == "replaced") << name << ": no file of others";
  }
  fs::remove(path());
  Journal untouched = open(false);
  untouched.add(block(0));
  EXPECT_TRUE(untouched.remove());
  EXPECT_FALSE(fs::exists(path()));
}

// A sweep that goes on has the rows that were written, or fewer, or refuses the file.
TEST_F(JournalFile, WhatIsDoneToItBetweenTwoSweepsIsSeenOrHarmless) {
  for (const auto &[name, apply, refusal] : touches) {
    fs::remove_all(folder);
    fs::create_directory(folder);
    {
      Journal journal = open(false);
      for (const std::size_t first : {0u, 10u, 20u}) journal.add(block(first));
    }
    apply(path(), contents(path()));
    try {
      Texts expected;
      for (const std::size_t first : {0u, 10u, 20u, 30u})
        for (std::size_t k = 0; k < 3; ++k) expected[k] += block(first)[k];
      {
        Journal resumed = open(true);
        EXPECT_EQ(resumed.size() % 10, 0u) << name;
        for (std::size_t first = resumed.size(); first < 40; first += 10) resumed.add(block(first));
        EXPECT_EQ(resumed.rows(), expected) << name;
      }
      EXPECT_EQ(open(true).rows(), expected) << name << ", and once more";
      EXPECT_STREQ(refusal, "") << name;
    } catch (const std::invalid_argument &refused) {
      const std::string begin = path().string() + ": " + refusal;
      EXPECT_EQ(std::string(refused.what()).substr(0, begin.size()), begin) << name;
      EXPECT_STRNE(refusal, "") << name;
    }
  }
}

TEST_F(JournalFile, APipeOrAFolderInItsPlaceIsRefused) {
  for (const char *command : {"mkfifo t.csv.partial", "mkdir t.csv.partial"}) {
    expect_message(run("sweep --vary omega=0.3:0.5:2 --resume --table t.csv", command),
                   "is no file");
    fs::remove(path());
  }
}

}  // namespace
