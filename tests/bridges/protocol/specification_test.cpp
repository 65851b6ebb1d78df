// The written specification names what the table holds, and its examples are golden frames.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
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

TEST(Specification, NamesEveryCanNumberOfTheFirmwaresHeader) {
  const std::string text = text_of("bridges/protocol/SPECIFICATION.md");
  std::istringstream header(text_of("bridges/protocol/opcodes.h"));
  int named = 0;
  for (std::string define, macro, number; header >> define;) {
    if (define != "#define" || !(header >> macro >> number) || !macro.starts_with("EYECAN_")) {
      continue;
    }
    const auto message = std::ranges::find_if(can::messages(), [&](const auto& spec) {
      return "EYECAN_" + std::string(spec.c_name) == macro;
    });
    if (message == can::messages().end()) {
      EXPECT_THAT(text, HasSubstr(fmt::format("| {} | `{}` |", number, macro)));
    } else {
      EXPECT_EQ(number, fmt::format("0x{:02X}", message->function));
    }
    ++named;
  }
  EXPECT_GE(named, 80);
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
  EXPECT_GE(shown, 26);
}

}  // namespace
}  // namespace eyebridge::bridges
