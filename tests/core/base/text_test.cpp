#include "eyebridge/base/text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eyebridge {
namespace {

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
