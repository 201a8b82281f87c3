// Fragments of documents: texts that `check` writes and compares. Comments of Markdown stand around
// a fragment. The first one has its name, which says what the fragment shows (fragments.hpp):
//   from <!--=border_mass_1_2:.5f-->0.29654<!--/-->
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace vibro_impact::figures {

// The text of the fragment with this name. Throws std::runtime_error if there is none.
using TextOf = std::function<std::string(const std::string &fragment)>;

// A document with the right fragments, and a line for each fault that it had: a fragment with
// another text, without an end, of an unknown name or at the beginning of a line, which Markdown
// then takes for HTML. Line breaks and the number of blanks do not matter.
struct Document {
  std::string text;
  std::vector<std::string> faults;
};

Document renewed(const std::string &name, const std::string &text, const TextOf &text_of);

}  // namespace vibro_impact::figures
