#include "eyebridge/base/text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eyebridge {
namespace {

TEST(Text, PrintableLeavesTerminalsNothingToObey) {
  EXPECT_EQ(printable("gr\xC3\xB6\xC3\x9F\ttwo\nlines\\x"), "gr\xC3\xB6\xC3\x9F\ttwo\nlines\\x");
  EXPECT_EQ(printable("\x1B[31m\x07\r\x7F"), "\\x1b[31m\\x07\\x0d\\x7f");
  // U+009B, which begins a command without an escape, and bytes that are no UTF-8.
  EXPECT_EQ(printable("\xC2\x9B"
                      "2J"),
            "\\xc2\\x9b"
            "2J");
  EXPECT_EQ(printable("\xFF\xC3"), "\\xff\\xc3");
  EXPECT_EQ(in_quotes("\xC2\x9B"
                      "2J"),
            "'?2J'");
}

TEST(Text, QuotesWhatCanBeShown) {
  EXPECT_EQ(in_quotes("plain"), "'plain'");
  EXPECT_EQ(in_quotes("gr\xC3\xB6\xC3\x9F"
                      "e"),
            "'gr\xC3\xB6\xC3\x9F"
            "e'");
  EXPECT_EQ(in_quotes("a\tb\x7F\n"), "'a?b?\?'");
  EXPECT_EQ(in_quotes("\xE4 \xC3 \xF0\x9F"), "'? ? ?\?'");
}

TEST(Text, CutsLongQuotesBetweenCharacters) {
  EXPECT_EQ(in_quotes("abcdef", 4), "'abcd…'");
  EXPECT_EQ(in_quotes("abcd", 4), "'abcd'");
  EXPECT_EQ(in_quotes("abc\xC3\xB6z", 4), "'abc\xC3\xB6…'");
}

TEST(Text, CountsEdits) {
  EXPECT_EQ(edit_distance("", "abc"), 3u);
  EXPECT_EQ(edit_distance("push", "ush"), 1u);
  EXPECT_EQ(edit_distance("wrold", "world"), 2u);
  EXPECT_EQ(edit_distance("same", "same"), 0u);
}

TEST(Text, TrimsBlanksOnly) {
  EXPECT_EQ(trimmed(" \t a b\r\n"), "a b");
  EXPECT_EQ(trimmed(" \n"), "");
}

TEST(Text, RefusesDurationsThatAreNone) {
  EXPECT_DOUBLE_EQ(parse_duration("1.5 min", {}), 90.0);
  for (const char* bad : {"", "s", "-1s", "2e9", "nan", "inf s", "2 days", "1e999"}) {
    EXPECT_THROW(parse_duration(bad, {"--step"}), ConfigError) << bad;
  }
}

}  // namespace
}  // namespace eyebridge
