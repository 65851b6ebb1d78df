// The written specification names what the table holds, and its examples are golden frames.

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "eyebridge/bridges/can/table.hpp"
#include "eyebridge/bridges/io7/command_table.hpp"

namespace eyebridge::bridges {
namespace {

using testing::HasSubstr;

std::string text_of(const char* path) {
  std::ifstream file(std::filesystem::path(EYEBRIDGE_SOURCE_DIR) / path);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(Specification, HasARowForEveryCanMessage) {
  const std::string text = text_of("bridges/protocol/SPECIFICATION.md");
  for (const can::MessageSpec& message : can::messages()) {
    if (message.fd) {
      EXPECT_THAT(text, HasSubstr(fmt::format("`{}` (id {:X}1, {} bytes)", message.name,
                                              message.function, message.length)));
      continue;
    }
    const int node = message.last_node == 0 ? 0 : 1;
    EXPECT_THAT(text, HasSubstr(fmt::format(
                          "\n| {:03X} | {} | {} | {} |", message.function << 4 | node, message.name,
                          message.length,
                          message.period_ms == 0 ? "event" : std::to_string(message.period_ms))));
  }
}

TEST(Specification, HasARowForEveryDocumentedLetter) {
  const std::string text = text_of("bridges/protocol/SPECIFICATION.md");
  for (const io7::Command& command : io7::commands()) {
    const std::string letter = fmt::format("`{}` ", command.letter);
    EXPECT_THAT(text, HasSubstr(command.documented ? "\n| " + letter + "|" : letter));
  }
}

TEST(Specification, ShowsGoldenFrames) {
  const std::string text = text_of("bridges/protocol/SPECIFICATION.md");
  const std::string golden = "\n" + text_of("tests/data/protocol/can.hex");
  int shown = 0;
  for (std::size_t at = text.find('#'); at != std::string::npos; at = text.find('#', at + 1)) {
    const std::size_t begin = text.rfind('`', at) + 1;
    if (at < 4 || begin + 3 != at) continue;
    const std::string frame = text.substr(begin, text.find('`', begin) - begin);
    EXPECT_THAT(golden, HasSubstr("\n" + frame + " ")) << frame;
    ++shown;
  }
  EXPECT_GE(shown, 25);
}

}  // namespace
}  // namespace eyebridge::bridges
