#include <random>
#include <string>

#include <gmock/gmock.h>

#include "eyebridge/bridges/io7/help_list.hpp"

namespace eyebridge::bridges::io7 {
namespace {

struct Case {
  const char* name;
  const char* text;
  const char* letters;
};
void PrintTo(const Case& row, std::ostream* out) { *out << row.name; }

class HelpList : public testing::TestWithParam<Case> {};

TEST_P(HelpList, GivesItsLetters) {
  const auto letters = parse_help(GetParam().text);
  ASSERT_TRUE(letters) << letters.error().what;
  for (int code = 0; code < 256; ++code) {
    const char letter = static_cast<char>(code);
    const bool expected =
        letter != 0 && std::string(GetParam().letters).find(letter) != std::string::npos;
    EXPECT_EQ(letters->has(letter), expected) << letter;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Forms, HelpList,
    testing::Values(
        Case{"Words", "h help\r\nm motor speed\r\nv version\r\n", "hmv"},
        Case{"Colons", "IO7 commands:\nh: help\nM: motor, ticks\nV: voltage\n", "hMV"},
        Case{"Dashes", "  h - help\n  v - version\n  E - demo\n", "hvE"},
        Case{"Quotes", "'h' help\n'O' output mode\n\"v\" version\n<m> motor\n(s) servo\n", "hOvms"},
        Case{"Numbers", "1) h\n2) v\n12. p  sensor\n", "hvp"},
        Case{"Bullets", "* h help\n- v version\n", "hv"},
        Case{"LettersAlone", "h\r\nv\r\nI\r\n", "hvI"},
        Case{"OneLine", "h O m M d s S p e v V\r\n", "hOmMdsSpevV"},
        Case{"OneLineAfterTheEcho", "h\r\nO,m,M,v\r\n", "hOmMv"},
        Case{"OneLineWithWords", "h help, v version\r\n", "h"},
        Case{"ArgumentsAreNoLetters", "h help\nd m p i d\nv\n", "hdv"},
        Case{"OtherScripts", "h aide \xC3\xA9t\xC3\xA9\nv version\n", "hv"},
        Case{"EchoCountsAsListed", "h\nv version\nm motor\n", "hvm"}),
    [](const auto& row) { return std::string(row.param.name); });

/// True when `letter` is in `text` without other letters beside it.
bool stands_alone(char letter, const std::string& text) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const std::string padded = " " + text + " ";
  for (std::size_t i = 1; i + 1 < padded.size(); ++i) {
    if (padded[i] == letter && !is_letter(padded[i - 1]) && !is_letter(padded[i + 1])) return true;
  }
  return false;
}

TEST(HelpListErrors, WhatIsNoListIsRefused) {
  for (const char* text : {"", "\r\n", "hello\r\nworld\r\n", "OK\r\n", "AT+GCAP\r\n", "m motor\r\n",
                           "h\r\n", "login: ", "v\x01rsion\r\n"}) {
    const auto letters = parse_help(text);
    ASSERT_FALSE(letters) << text;
    EXPECT_EQ(letters.error().code, Errc::Corrupt);
  }
}

TEST(HelpListErrors, AnyBytesGiveLettersThatStartALineOrAnError) {
  std::mt19937 random(99);
  const std::string common = "hvmE -:\r\n'ab";
  int read = 0;
  for (int round = 0; round < 50000; ++round) {
    std::string text(random() % 24, '\0');
    for (char& c : text) {
      c = random() % 16 == 0 ? static_cast<char>(random() & 0xFFU)
                             : common[random() % common.size()];
    }
    const auto letters = parse_help(text);
    if (!letters) continue;
    ++read;
    for (const char letter : std::string("vmEabOMdsSpeVio")) {
      ASSERT_TRUE(!letters->has(letter) || stands_alone(letter, text)) << letter << " in " << text;
    }
  }
  EXPECT_GT(read, 500);
}

}  // namespace
}  // namespace eyebridge::bridges::io7
