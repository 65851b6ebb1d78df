#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "entry.hpp"

namespace eyebridge::bridges::fuzz {
namespace {

struct Target {
  const char* name;
  void (*run)(std::span<const std::uint8_t>);
};
void PrintTo(const Target& target, std::ostream* out) { *out << target.name; }

class ProtocolCorpus : public testing::TestWithParam<Target> {};

TEST_P(ProtocolCorpus, NoInputIsAcceptedWrongly) {
  const auto folder = std::filesystem::path(EYEBRIDGE_SOURCE_DIR) /
                      "tests/bridges/protocol/corpus" / GetParam().name;
  ASSERT_TRUE(std::filesystem::is_directory(folder)) << folder << " is missing";
  int inputs = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    std::ifstream file(entry.path(), std::ios::binary);
    const std::vector<char> text{std::istreambuf_iterator<char>(file), {}};
    const std::vector<std::uint8_t> bytes(text.begin(), text.end());
    ASSERT_FALSE(bytes.empty()) << entry.path();
    GetParam().run(bytes);
    ++inputs;
  }
  EXPECT_GE(inputs, 3);
}

INSTANTIATE_TEST_SUITE_P(Targets, ProtocolCorpus,
                         testing::Values(Target{"io7_reply", io7_reply},
                                         Target{"io7_help", io7_help},
                                         Target{"can_frame", can_frame}),
                         [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace eyebridge::bridges::fuzz
