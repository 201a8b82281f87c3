// The comparison of the documents with what `check` computes: an edited number, verdict, sentence
// or table is found.
#include "figures/check/documents.hpp"

#include <gtest/gtest.h>

namespace {

using namespace vibro_impact::figures;

using vibro_impact::numbers::Claim, vibro_impact::numbers::Printed;

Finding checked(const std::string &id, const Printed &printed, double computed) {
  vibro_impact::numbers::CheckedNumber number;
  number.id = id;
  number.source = "wagg";
  number.meaning = "of " + id;
  number.format = ".0e";
  number.printed = printed;
  return {number, computed};
}

// Two key numbers, of which the second differs from the paper.
const Findings two{checked("start", {"715 to 716", Claim::stated, 715.0, 716.0}, 715.561564510661),
                   checked("gap", {"it grazes", Claim::stated, 0.0, 0.0}, 7.53817007e-05)};

using Lines = std::vector<std::string>;

TEST(Documents, ANumberOfFiveDigitsThatIsNoKeyNumberIsFound) {
  const auto unknown = [](const std::string &text) {
    Lines words;
    for (const std::string &fault : faults_of(two, {"a", {}, true}, text))
      words.push_back(fault.substr(3, fault.find(" is no key number") - 3));
    return words;
  };
  EXPECT_EQ(unknown("from 715.5616 to 715.5617, 715.56156 and -715.561564511"), Lines{"715.5617"});
  EXPECT_EQ(unknown("a gap of 7.5382e-05, not 7.5381e-05"), Lines{"7.5381e-05"});
  EXPECT_EQ(unknown("0.29655-0.33098"), (Lines{"0.29655", "0.33098"}));
  EXPECT_EQ(unknown("four digits: 0.2561, 12.33, 0.0025; doi 10.1007/s11071-006-0757-7"), Lines{});
  EXPECT_EQ(unknown("```\n0.123456\n```\n0.123457\n"), Lines{"0.123457"});
}

TEST(Documents, AVerdictThatIsAnotherOneIsFound) {
  const auto faults = [](const std::string &text) {
    return faults_of(two, {"a", {}, false}, text);
  };
  const std::string link = "](../reference/tables/checked_numbers.csv ";
  EXPECT_EQ(faults("| [agrees" + link + "\"start\") | [differs" + link + "\"gap\") |"), Lines{});
  EXPECT_EQ(faults("| [agrees" + link + "\"start\") | [close" + link + "\"gap\") |"),
            Lines{"a: gap: must be 'differs', not 'close'"});
  EXPECT_THROW(faults("[agrees" + link + "\"nothing\")"), std::runtime_error);
}

TEST(Documents, AQuotationMayBeWrappedAndNotEdited) {
  const std::string counts = count_of_verdicts(two), table = table_of_few(two, {"gap"});
  EXPECT_EQ(counts,
            "2 key numbers: 1 agree with the paper, 0 are close to it, 1 differ from it, 0 depend "
            "on an inferred value, 0 are not in the paper");
  EXPECT_NE(table.find("| it grazes | 8e-05 | differs |"), std::string::npos);
  const Document document{"a", {counts, table}, false};
  std::string text = "before\n" + table + counts + ". After.";
  text[text.find("0 depend") - 1] = '\n';
  EXPECT_EQ(faults_of(two, document, text), Lines{});
  text[text.find("8e-05")] = '7';
  EXPECT_EQ(faults_of(two, document, text), Lines{"a: must quote: " + table});
}

}  // namespace
