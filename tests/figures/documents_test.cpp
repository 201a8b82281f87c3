// The documents against what `check` computes: an edited fragment is found, and each fragment shows
// what its name says. (That those of the documents are right: key_numbers.)
#include "figures/check/fragments.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "figures/check/quotations.hpp"
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

// Two key numbers, of which the second differs from the paper, two claims, and a table in a folder
// of the test, since several tests run at once.
Sources sources() {
  const std::string folder = std::string(PROGRAM_DIR "/../tables_of_tests/") +
                             ::testing::UnitTest::GetInstance()->current_test_info()->name();
  std::filesystem::create_directories(folder);
  std::ofstream(folder + "/speeds.csv")
      << "motion,r,from,to\nat rest,0.69999999999999996,1.5,1.5\nat rest,0.3,2.5e-12,3.5\n";
  return {
      {checked("start", {"715 to 716", numbers::Claim::stated, 715.0, 716.0}, 715.561564510661),
       checked("gap", {"it grazes", numbers::Claim::stated, 0.0, 0.0}, 7.53817007e-05)},
      {{"figure5", "Section 3.3", "it grazes", "{gap:.1e} short, at {start:.0f}", "differs", "gap"},
       {"figure5", "Section 3.3", "no stick", "so", "agrees otherwise",
        "corrections_test.AGrazeBeginsNoStickingPhase"}},
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
  EXPECT_EQ(text("claims:figure5"),
            "\n|the paper |here |class|\n|---|---|---|\n"
            "|Section 3.3: it grazes |7.5e-5 short, at 716 |differs|\n"
            "|no stick |so |agrees otherwise (`corrections_test`)|\n");
  EXPECT_EQ(text("count_of_claims:differs") + text("count_of_claims:agrees+agrees_otherwise") +
                text("count_of_claims:all"),
            "112");
  EXPECT_EQ(text("count:g") + text("count:g+agrees") + text("count:not_in_the_paper"), "120");
  EXPECT_EQ(text("speeds:at rest:from+to:g"), "1.5, 2.5e-12 to 3.5");
  EXPECT_EQ(text("speeds:at rest,0.7:from:.2f"), "1.50");
  for (const char *unknown : {"nothing", "class:nothing", "claims:figure9", "speeds:moving:from:g",
                              "speeds:at rest:time:g", "no_table:1:to:g", "start:x"})
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
  EXPECT_EQ(faults("It <!--=claims:figure5-->\n|the paper |here\n|class|<!--/-->.").size(), 1u);
  EXPECT_EQ(faults("at <!--=start-->7"), Lines{"a: start: has no end"});
  EXPECT_EQ(faults("<!--=start:.0f-->716<!--/-->"), Lines{"a: start:.0f: begins a line"});
  EXPECT_EQ(faults("a\n- <!--=start:.0f-->716<!--/-->").size(), 1u);
  EXPECT_EQ(faults("a\n| <!--=start:.0f-->716<!--/--> |"), Lines{});
  EXPECT_EQ(faults("a <!--=nothing-->7<!--/-->").size(), 1u);
}

// A claim has the class of its key number, or a test that is there.
TEST(Documents, AClaimThatNothingDecidesIsRefused) {
  const std::string folder = PROGRAM_DIR "/../tables_of_tests/claims";
  std::filesystem::create_directories(folder);
  const auto refused = [&](const std::string &verdict, const std::string &decider) {
    std::ofstream(folder + "/claims.csv") << "section,place,the_paper,ours,class,decided_by\n"
                                          << "figure5,,,," << verdict << ',' << decider << '\n';
    return vibro_impact::testing::refusal<std::exception>(
               [&] { claims(folder, sources().findings); }) != "accepted";
  };
  EXPECT_FALSE(refused("differs", "gap"));
  EXPECT_FALSE(refused("agrees", "corrections_test.AGrazeBeginsNoStickingPhase"));
  EXPECT_TRUE(refused("agrees", "gap")) << "the number differs";
  EXPECT_TRUE(refused("agree", "start")) << "no class";
  EXPECT_TRUE(refused("agrees", "nothing"));
  EXPECT_TRUE(refused("agrees", "corrections_test.AGrazeBeginsASticking"));
  EXPECT_TRUE(refused("agrees", "corrections_test."));
}

std::string content(const std::string &path) {
  std::ostringstream content;
  content << vibro_impact::truth::opened(SOURCE_DIR "/" + path).rdbuf();
  return content.str();
}

// Whether `check` sees this edit of a document: in a fragment, which it compares, or of a number
// that is then in no quotation.
bool is_seen(const std::string &document, const std::string &from, const std::string &to) {
  std::string text = content(document);
  const auto place = text.find(from);
  EXPECT_NE(place, std::string::npos) << document << " has no " << from;
  if (place == std::string::npos) return false;
  const auto mark = text.rfind("<!--", place);
  if (mark != std::string::npos && text.compare(mark, 5, "<!--=") == 0) return true;
  text.replace(place, from.size(), to);
  return !numbers_without_origin(document, text, quotations_of(REFERENCE_DIR, document)).empty();
}

TEST(Documents, AnEditOfANumberIsSeen) {
  const std::string page = "figures/README.md", readme = "README.md";
  for (const auto &document : {page, readme})
    EXPECT_EQ(
        numbers_without_origin(document, content(document), quotations_of(REFERENCE_DIR, document)),
        Lines{});
  EXPECT_TRUE(is_seen(page, "0.645", "0.625"));
  EXPECT_TRUE(is_seen(page, "-0.15", "-0.25"));
  EXPECT_TRUE(is_seen(page, "√1.99", "√1.09"));
  EXPECT_TRUE(is_seen(page, "0.33", "0.34"));
  EXPECT_TRUE(is_seen(page, "0.67", "0.66"));
  EXPECT_TRUE(is_seen(page, "T/1000", "T/2000"));
  EXPECT_TRUE(is_seen(page, "0.31.", "0.32."));
  EXPECT_TRUE(is_seen(page, "t = 950", "t = 960"));
  EXPECT_TRUE(is_seen(readme, "0.256 ", "0.255 "));
  EXPECT_TRUE(is_seen(readme, "Ω = 0.65", "Ω = 0.55"));
  EXPECT_TRUE(is_seen(readme, "137-148", "137-149"));
  EXPECT_TRUE(is_seen(readme, "in ten periods", "in nine periods"));
  EXPECT_TRUE(is_seen(readme, "In Figure 3", "In Figure 4")) << "a quotation has it";
  EXPECT_TRUE(is_seen(page, "The five others", "The four others"));
  EXPECT_TRUE(is_seen(page, "the force F_1", "the force F_2"));
  EXPECT_TRUE(is_seen(page, "Eq. 7:", "Eq. 8:"));
  EXPECT_TRUE(is_seen(page, "|ω² q", "|ω³ q"));
  EXPECT_TRUE(is_seen(readme, "holds mass 1", "holds mass 2"));
  EXPECT_TRUE(is_seen(readme, "--until 750", "--until 760"));
  EXPECT_EQ(numbers_without_origin("a", "Seven cut-offs, 2 steps and Figure 3", {}).size(), 3u);
}

// Every digit outside the fragments, anchors and targets of links.
TEST(Documents, AnEditOfAnyDigitIsSeen) {
  for (const std::string document : {"README.md", "figures/README.md"}) {
    const std::string text = content(document);
    const auto quotations = quotations_of(REFERENCE_DIR, document);
    const std::regex left_out(R"(<!--=[^>]*-->[^]*?<!--/-->|\]\([^)]*\)|<a id="[^"]*">)");
    std::string kept = text;
    for (std::sregex_iterator part(text.begin(), text.end(), left_out), end; part != end; ++part)
      std::fill_n(kept.begin() + part->position(), part->length(), ' ');
    int edits = 0;
    for (auto place = kept.find_first_of("0123456789"); place != std::string::npos;
         place = kept.find_first_of("0123456789", place + 1)) {
      std::string edited = text;
      edited[place] = edited[place] == '9' ? '8' : static_cast<char>(edited[place] + 1);
      EXPECT_FALSE(numbers_without_origin(document, edited, quotations).empty())
          << document << ": " << text.substr(place < 20 ? 0 : place - 20, 40);
      ++edits;
    }
    EXPECT_GE(edits, 100) << document;
  }
}

// Different matches in a file of the project, of the first group in brackets.
std::set<std::string> matches(const std::string &path, const std::string &expression) {
  const std::string text = content(path);
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
