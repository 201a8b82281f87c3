// The documents against what `check` computes: an edited fragment is found, and each fragment shows
// what its name says. (That those of the documents are right: key_numbers.)
#include "figures/check/documents.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>

#include "figures/check/fragments.hpp"
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
  std::ofstream(folder + "/speeds.csv") << "omega,r,speed\n0.25,0.7,1.5\n0.25,0.3,2.5e-12\n";
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
  EXPECT_EQ(text("gap:.3e"), "7.538e-5");
  EXPECT_EQ(text("start:.5f"), "715.56156");
  EXPECT_EQ(text("class:start") + ", " + text("class:gap"), "agrees, differs");
  EXPECT_EQ(text("claim:cannot_be_judged:corrections_test"),
            "cannot be judged (`corrections_test`)");
  EXPECT_EQ(text("count:g:w") + text("count:g+agrees:w"), "onetwo");
  EXPECT_EQ(text("speeds:0.25:speed:.1f") + text("speeds:0.25,0.3:speed:.0e"), "1.52e-12");
  EXPECT_EQ(text("verdicts").substr(0, 53),
            "2 key numbers. Of these, 1 agree with the paper (0 by");
  for (const char *unknown :
       {"nothing", "class:nothing", "claim:agree:corrections_test", "claim:agrees:no_test",
        "speeds:0.3:speed:g", "speeds:0.25:time:g", "no_table:1:2:g", "start:x", "count:st"})
    EXPECT_NE(vibro_impact::testing::refusal<std::exception>([&] { text(unknown); }), "accepted")
        << unknown;
}

Document edited(const std::string &edited_text) {
  return renewed("a", edited_text, text);
}

TEST(Documents, AnEditedFragmentIsFoundAndWrittenAgain) {
  const std::string right = "At <!--=start:.1f-->715.6<!--/-->, a\n<!--/-->";
  EXPECT_EQ(edited(right).faults, Lines{});
  const Document wrong = edited("At <!--=start:.1f-->715.7<!--/-->, a\n<!--/-->");
  EXPECT_EQ(wrong.faults, Lines{"a: start:.1f: must be '715.6', not '715.7'"});
  EXPECT_EQ(wrong.text, right);
  const std::string wrapped =
      "It <!--=claim:cannot_be_judged:corrections_test-->cannot be\njudged  "
      "(`corrections_test`)<!--/-->.";
  EXPECT_EQ(edited(wrapped).faults, Lines{});
  EXPECT_EQ(edited(wrapped).text, wrapped);
}

TEST(Documents, AFragmentThatCannotBeReadIsFound) {
  EXPECT_EQ(edited("at <!--=start-->7").faults, Lines{"a: start: has no end"});
  EXPECT_EQ(edited("<!--=start:.0f-->716<!--/-->").faults, Lines{"a: start:.0f: begins a line"});
  EXPECT_EQ(edited("a\n- <!--=start:.0f-->716<!--/-->").faults.size(), 1u);
  EXPECT_EQ(edited("a\n| <!--=start:.0f-->716<!--/--> |").faults, Lines{});
  EXPECT_EQ(edited("a <!--=nothing-->7<!--/-->").faults.size(), 1u);
}

std::string content_of(const std::string &path) {
  std::ostringstream content;
  content << vibro_impact::truth::opened(SOURCE_DIR "/" + path).rdbuf();
  return content.str();
}

// The paper is cited alike everywhere, and the code check lists every picture that `make figures`
// draws but those of error against run time, on which no claim of the paper rests.
TEST(Documents, ThePaperIsCitedAlikeAndTheCodeCheckListsAllPictures) {
  const std::regex doi(R"(10\.\d{4}/[-\w]*)");
  for (const char *file : {"README.md", "CITATION.cff", "codemeta.json", "codecheck.yml"}) {
    const std::string content = content_of(file);
    int cited = 0;
    for (std::sregex_iterator word(content.begin(), content.end(), doi), none; word != none; ++word)
      EXPECT_EQ((++cited, word->str()), "10.1007/s11071-006-0757-7") << file;
    EXPECT_GE(cited, 1) << file;
  }
  for (const char *file : {"README.md", "CITATION.cff", "codecheck.yml"})
    EXPECT_NE(content_of(file).find("eprints.whiterose.ac.uk/79689/"), std::string::npos) << file;
  EXPECT_NE(content_of("README.md").find("43 (2006) 137-148"), std::string::npos);
  EXPECT_NE(content_of("CITATION.cff").find("start: 137\n    end: 148\n    year: 2006"),
            std::string::npos);
  const std::string manifest = content_of("codecheck.yml");
  for (const auto &script : std::filesystem::directory_iterator(SOURCE_DIR "/figures")) {
    const std::string name = script.path().stem().string();
    if (script.path().extension() != ".gp" || name == "style") continue;
    EXPECT_NE(manifest.find("figures/pictures/" + name + ".png"), std::string::npos) << name;
  }
  for (const char *table : {"reference/tables/checked_numbers.csv", "figures/README.md"})
    EXPECT_NE(manifest.find(table), std::string::npos) << table;
  const std::regex file("file: (\\S+)");
  for (std::sregex_iterator word(manifest.begin(), manifest.end(), file), none; word != none;
       ++word)
    EXPECT_TRUE(std::filesystem::exists(SOURCE_DIR "/" + word->str(1))) << word->str(1);
}

}  // namespace
