// The journal of a sweep: its rows, and what becomes of them when its file is touched while the
// sweep runs, or between two sweeps.
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "program/journal.hpp"
#include "tests/support/runner_program.hpp"

namespace {

using namespace vibro_impact::testing;
using namespace vibro_impact::runner;

const std::string journal_head = "a sweep\n";
constexpr std::size_t row_count = 30;

Texts texts_of(std::size_t row) {
  const std::string number = std::to_string(row);
  return {number + ",1\n", number + ",2\n" + number + ",3\n", ""};
}
std::string all_rows(std::size_t table) {
  std::string text;
  for (std::size_t row = 0; row < row_count; ++row) text += texts_of(row)[table];
  return text;
}
void write(const fs::path &path, const std::string &text) {
  std::ofstream(path, std::ios::binary) << text;
}
std::size_t middle(const std::string &text) {
  return text.find("15,3");
}

// Ways to touch the file, given its path and its text. A line that is cut is computed again;
// another one that does not fit its checksum is refused.
struct Touch {
  const char *name;
  std::function<void(const fs::path &, std::string)> apply;
  const char *refusal = "";  // of the next sweep
};
const char *const unfit = "a row that does not fit its checksum";
const std::vector<Touch> touches = {
    {"cut to nothing", [](auto &path, auto) { fs::resize_file(path, 0); }},
    {"cut in the head", [](auto &path, auto) { fs::resize_file(path, 5); }},
    {"cut in a row", [](auto &path, auto text) { fs::resize_file(path, middle(text)); }},
    {"cut by one character", [](auto &path, auto text) { fs::resize_file(path, text.size() - 1); }},
    {"cut behind a checksum",
     [](auto &path, auto text) { fs::resize_file(path, text.rfind('\n', text.size() - 2) + 14); }},
    {"a digit edited",
     [](auto &path, auto text) { write(path, text.replace(middle(text), 1, "9")); }, unfit},
    {"a digit of the number of a row edited",
     [](auto &path, auto text) { write(path, text.replace(text.find(" 4") + 1, 1, "7")); }, unfit},
    {"an end of a line edited",
     [](auto &path, auto text) {
       write(path, text.replace(text.find('\n', middle(text)), 1, "7"));
     },
     unfit},
    {"a row deleted", [](auto &path, auto text) { write(path, text.erase(middle(text), 4)); },
     unfit},
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
    return Journal(path().string(), journal_head, row_count, resume);
  }
  // Twenty of the rows, every second one first.
  Journal begun() {
    fs::remove_all(folder);
    fs::create_directory(folder);
    Journal journal = open(false);
    for (std::size_t row = 0; row < row_count; row += 2)
      journal.add(journal_line(row, texts_of(row)));
    for (std::size_t row = 11; row < 21; row += 2) journal.add(journal_line(row, texts_of(row)));
    return journal;
  }
  // Adds the missing rows, and expects all in their order.
  static void complete(Journal &journal) {
    for (std::size_t row = row_count; row-- > 0;)
      if (!journal.has(row)) journal.add(journal_line(row, texts_of(row)));
    Texts found;
    for (std::size_t row = 0; row < row_count; ++row)
      for (std::size_t k = 0; k < found.size(); ++k) found[k] += journal.texts_of(row)[k];
    for (std::size_t k = 0; k < found.size(); ++k) EXPECT_EQ(found[k], all_rows(k));
  }
};

TEST_F(JournalFile, WhatIsDoneToItDuringASweepIsHarmless) {
  for (const Touch &touch : touches) {
    SCOPED_TRACE(touch.name);
    Journal journal = begun();
    touch.apply(path(), contents(path()));
    complete(journal);
    journal.remove();
    EXPECT_EQ(fs::exists(path()), std::string(touch.name) == "replaced") << "no file of others";
  }
}

TEST_F(JournalFile, WhatIsDoneToItBetweenTwoSweepsIsSeenOrHarmless) {
  for (const auto &[name, apply, refusal] : touches) {
    SCOPED_TRACE(name);
    begun();
    apply(path(), contents(path()));
    try {
      for (int k = 0; k < 2; ++k) {  // the second has nothing to add
        Journal resumed = open(true);
        complete(resumed);
      }
      EXPECT_STREQ(refusal, "");
    } catch (const std::invalid_argument &refused) {
      EXPECT_STRNE(refusal, "");
      EXPECT_NE(std::string(refused.what()).find(refusal), std::string::npos) << refused.what();
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
