// Fixed inputs through the entry point of the fuzzer: each is taken, or refused with a message,
// within the test's time.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size);

namespace {

namespace fs = std::filesystem;

std::vector<std::string> inputs() {
  std::vector<std::string> names;
  for (const auto &entry : fs::directory_iterator(FUZZ_INPUTS))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

class FuzzInputs : public testing::TestWithParam<std::string> {};

TEST_P(FuzzInputs, AreTakenOrRefusedWithAMessage) {
  std::ifstream file(fs::path(FUZZ_INPUTS) / GetParam(), std::ios::binary);
  ASSERT_TRUE(file);
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  EXPECT_EQ(
      LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t *>(text.data()), text.size()), 0);
}

INSTANTIATE_TEST_SUITE_P(Fixed, FuzzInputs, testing::ValuesIn(inputs()),
                         [](const auto &input) { return input.param; });

}  // namespace
