// The documents against what `check` computes: an edited fragment is found, and each fragment shows
// what its name says. (That those of the documents are right: key_numbers.)
#include "figures/check/fragments.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>

#include "tests/support/refusals.hpp"

namespace {

using namespace vibro_impact::figures;
namespace numbers = vibro_impact::numbers;
using Lines = std::vector<std::string>;

Finding checked(const std::string &id, const numbers::Printed &printed, double computed) {
  numbers::CheckedNumber number;
  number.id = id;
  number.source = "wagg";
  number.format = ".0e";
  number.printed = printed;
  return {number, computed};
}

// Two key numbers, of which the second differs from the paper, and a table.
Sources sources() {
  const std::string folder = PROGRAM_DIR "/../tables_of_tests/documents";
  std::filesystem::create_directories(folder);
  std::ofstream(folder + "/speeds.csv")
      << "motion,r,from,to\nat rest,0.69999999999999996,1.5,1.5\nat rest,0.3,2.5e-12,3.5\n";
  return {{checked("start", {"715 to 716", numbers::Claim::stated, 715.0, 716.0}, 715.561564510661),
           checked("gap", {"it grazes", numbers::Claim::stated, 0.0, 0.0}, 7.53817007e-05)},
          {},
          folder};
}

std::string text(const std::string &fragment) {
  return text_of(fragment, sources());
}

TEST(Documents, AFragmentShowsWhatItsNameSays) {
  EXPECT_EQ(text("gap"), "8e-5") << "the format of its row";
  EXPECT_EQ(text("gap:.3e") + " " + text("start:.5f"), "7.538e-5 715.56156");
  EXPECT_EQ(text("class:start") + ", " + text("class:gap"), "agrees, differs");
  EXPECT_EQ(text("claim:cannot_be_judged:corrections_test.AGrazeBeginsNoStickingPhase"),
            "cannot be judged (`corrections_test`)");
  EXPECT_EQ(text("count:g") + text("count:g+agrees") + text("count:not_in_the_paper"), "120");
  EXPECT_EQ(text("speeds:at rest:from+to:g"), "1.5, 2.5e-12 to 3.5");
  EXPECT_EQ(text("speeds:at rest,0.7:from:.2f"), "1.50");
  for (const char *unknown :
       {"nothing", "class:nothing", "claim:agree:corrections_test.AGrazeBeginsNoStickingPhase",
        "claim:agrees:corrections_test.AGrazeBeginsASticking", "claim:agrees:corrections_test",
        "speeds:moving:from:g", "speeds:at rest:time:g", "no_table:1:to:g", "start:x"})
    EXPECT_NE(vibro_impact::testing::refusal<std::exception>([&] { text(unknown); }), "accepted")
        << unknown;
}

TEST(Documents, AFaultOfAFragmentIsFoundAndItsTextIsWrittenAgain) {
  const auto faults = [](const std::string &edited) {
    return renewed("a", edited, sources()).faults;
  };
  const std::string right = "At <!--=start:.1f-->715.6<!--/-->, a\n<!--/-->",
                    wrong = "At <!--=start:.1f-->715.7<!--/-->, a\n<!--/-->";
  EXPECT_EQ(faults(right), Lines{});
  EXPECT_EQ(faults(wrong), Lines{"a: start:.1f: must be '715.6', not '715.7'"});
  EXPECT_EQ(renewed("a", wrong, sources()).text, right);
  EXPECT_EQ(faults("It "
                   "<!--=claim:agrees_otherwise:corrections_test.AGrazeBeginsNoStickingPhase-->"
                   "agrees\notherwise "
                   "(`corrections_test`)<!--/-->."),
            Lines{});
  EXPECT_EQ(faults("at <!--=start-->7"), Lines{"a: start: has no end"});
  EXPECT_EQ(faults("<!--=start:.0f-->716<!--/-->"), Lines{"a: start:.0f: begins a line"});
  EXPECT_EQ(faults("a\n- <!--=start:.0f-->716<!--/-->").size(), 1u);
  EXPECT_EQ(faults("a\n| <!--=start:.0f-->716<!--/--> |"), Lines{});
  EXPECT_EQ(faults("a <!--=nothing-->7<!--/-->").size(), 1u);
}

// Different matches in a file of the project, of the first group in brackets.
std::set<std::string> matches(const std::string &path, const std::string &expression) {
  std::ostringstream content;
  content << vibro_impact::truth::opened(SOURCE_DIR "/" + path).rdbuf();
  const std::string text = content.str();
  const std::regex regex(expression);
  return {std::sregex_token_iterator(text.begin(), text.end(), regex, 1), {}};
}

TEST(Documents, ThePaperIsCitedAlike) {
  for (const char *file : {"README.md", "CITATION.cff", "codemeta.json", "codecheck.yml"})
    EXPECT_EQ(matches(file, R"((10\.\d{4}/[-\w]*))"),
              std::set<std::string>{"10.1007/s11071-006-0757-7"});
  for (const char *file : {"README.md", "CITATION.cff", "codecheck.yml"})
    EXPECT_EQ(matches(file, "(eprints.whiterose.ac.uk/79689/)").size(), 1u) << file;
  EXPECT_EQ(matches("README.md", R"((43 \(2006\) 137-148))").size(), 1u);
  EXPECT_EQ(matches("CITATION.cff", "(start: 137\n    end: 148\n    year: 2006)").size(), 1u);
}

// Error against run time is left out, since no claim of the paper rests on it.
TEST(Documents, TheCodeCheckListsThePictures) {
  const auto listed = matches("codecheck.yml", "file: (\\S+)");
  for (const std::string &path : listed)
    EXPECT_TRUE(std::filesystem::exists(SOURCE_DIR "/" + path)) << path;
  for (const char *table : {"reference/tables/checked_numbers.csv", "figures/README.md"})
    EXPECT_TRUE(listed.contains(table)) << table;
  for (const auto &script : std::filesystem::directory_iterator(SOURCE_DIR "/figures")) {
    const std::string name = script.path().stem().string();
    if (script.path().extension() != ".gp" || name == "style") continue;
    EXPECT_TRUE(listed.contains("figures/pictures/" + name + ".png")) << name;
  }
}

}  // namespace
