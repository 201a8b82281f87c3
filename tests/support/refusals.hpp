// The message of a call that must be refused.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace vibro_impact::testing {

struct BadCall {
  std::function<void()> call;
  const char *says;  // part of the message: the value and the rule
};

// The message of the error of this kind that the call throws, or that it was accepted; any other
// error goes on to the test, which fails.
template <class Error = std::invalid_argument>
std::string refusal(const std::function<void()> &call) {
  try {
    call();
  } catch (const Error &bad) {
    return bad.what();
  }
  return "accepted";
}

// Every call throws std::invalid_argument, with one line.
inline void expect_refused(const std::vector<BadCall> &calls) {
  for (const auto &[call, says] : calls) {
    const std::string message = refusal(call);
    EXPECT_NE(message.find(says), std::string::npos) << "'" << message << "' for '" << says << "'";
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

}  // namespace vibro_impact::testing
