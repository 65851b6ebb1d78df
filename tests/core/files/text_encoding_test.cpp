// Texts as other systems write them: as if written here, or the encoding is named.
#include <gmock/gmock.h>

#include "reading.hpp"

namespace eyebridge::files {
namespace {

using namespace std::string_literals;

const std::string kEncodingCases = EYEBRIDGE_SHARED_DIR "/cases/encodings/";

std::string text_of(const std::string& bytes) {
  const Folder folder;
  return read_text_file(folder.write("a.wld", bytes));
}

TEST(TextEncoding, BecomesUtf8WithPlainLines) {
  EXPECT_EQ(text_of("a\rb\rc"), "a\nb\nc");
  EXPECT_EQ(text_of("a\r\nb\r\n"), "a\nb\n");
  EXPECT_EQ(text_of("a\r\r\nb"), "a\n\nb");
  EXPECT_EQ(text_of("\xEF\xBB\xBF"
                    "a b"),
            "a b");
  EXPECT_EQ(text_of("a\xC2\xA0"
                    "b\xE2\x80\xAF"
                    "c"),
            "a b c");
  EXPECT_EQ(text_of("caf\xE9\n"), "caf\xC3\xA9\n") << "Latin-1";
  EXPECT_EQ(text_of("a\xA0"
                    "1\n"),
            "a 1\n")
      << "Latin-1";
  EXPECT_EQ(text_of("caf\xC3\xA9 \xF0\x9F\x90\xAD\n"), "caf\xC3\xA9 \xF0\x9F\x90\xAD\n");
  EXPECT_EQ(text_of("\xFF\xFE"
                    "a\0\n\0"s),
            "a\n");
  EXPECT_EQ(text_of("\xFE\xFF\0a\0\n"s), "a\n");
  EXPECT_EQ(text_of("\xFF\xFE\x3D\xD8\x2D\xDC"s), "\xF0\x9F\x90\xAD") << "a pair";
  EXPECT_EQ(text_of("f\0l\0o\0o\0r\0 \0001\0 \0001\0"s), "floor 1 1") << "without a mark";
}

TEST(TextEncoding, WhatIsNoneIsNamed) {
  const Folder folder;
  const auto refusal = [&](const std::string& bytes) {
    const auto path = folder.write("a.wld", bytes);
    return without(error_of([&] { read_text_file(path); }), folder.path().string() + "/");
  };
  EXPECT_EQ(refusal("\xFF\xFE\0\0a\0\0\0"s), "a.wld: a text in UTF-32: save it as UTF-8");
  EXPECT_EQ(refusal("\xFF\xFE"
                    "a"s),
            "a.wld: a text in UTF-16 that ends with half a character: expected whole UTF-16; save "
            "the file as UTF-8");
  EXPECT_EQ(refusal("\xFF\xFE\x3D\xD8"s),
            "a.wld: half of a pair at byte 2: expected whole UTF-16; save the file as UTF-8");
}

TEST(TextEncoding, TheCasesAreRead) {
  EXPECT_EQ(load_scenario(kEncodingCases + "cr.wld").world.walls.size(), 4u);
  EXPECT_EQ(load_scenario(kEncodingCases + "utf16.wld").world.walls.size(), 4u);
  EXPECT_EQ(load_scenario(kEncodingCases + "cr.maz").world.maze->columns, 2);
  // The world that they name is not among the cases.
  EXPECT_THAT(error_of([] { load_scenario(kEncodingCases + "cr.sim"); }),
              testing::HasSubstr("cr.sim:1:7: no file 'ok.wld'"));
  EXPECT_THAT(error_of([] { load_scenario(kEncodingCases + "spaces.sim"); }),
              testing::HasSubstr("a name with blanks needs quotes: \"Sub Dir\\room.wld\""));
}

}  // namespace
}  // namespace eyebridge::files
