#include <cstdint>

#include <gmock/gmock.h>

#include "eyebridge/files/hdt.hpp"
#include "reading.hpp"

namespace eyebridge::files {
namespace {

using Reader = void (*)(const std::string&, std::vector<Warning>&);
struct Row {
  const char* name;
  Reader read;
};

const Row kReaders[] = {
    {"world", [](const std::string& t, std::vector<Warning>& w) { read_world(t, "f", w); }},
    {"maze", [](const std::string& t, std::vector<Warning>& w) { read_maze(t, "f", w); }},
    {"robi", [](const std::string& t, std::vector<Warning>& w) { read_robi(t, "f", w); }},
    {"sim", [](const std::string& t, std::vector<Warning>& w) { read_sim(t, "f", w); }},
    {"parameters",
     [](const std::string& t, std::vector<Warning>& w) { read_parameter_file(t, "f", w); }},
    {"hdt", [](const std::string& t, std::vector<Warning>& w) { read_hdt(t, "f", w); }},
};

TEST(BadInput, EmptyFilesBinaryJunkAndEndlessLinesAreErrorsOfEveryReader) {
  const std::string texts[] = {"", "\n\n", std::string("\0\1\2\3", 4), std::string(1 << 20, 'a'),
                               "\x7F"
                               "ELF"};
  for (const Row& reader : kReaders) {
    for (const std::string& text : texts) {
      std::vector<Warning> warnings;
      EXPECT_THROW(reader.read(text, warnings), ConfigError) << reader.name;
    }
  }
}

TEST(BadInput, WarningsAreLimitedHoweverOddTheFile) {
  std::string maze = " _\n";
  for (int i = 0; i < 3000; ++i) maze += "Q\n";
  std::vector<Warning> warnings;
  read_maze(maze, "f", warnings);
  ASSERT_EQ(warnings.size(), 101u);
  EXPECT_EQ(warnings.back().text, "more oddities, not listed");
}

TEST(BadInput, AnyBytesGiveAModelOrAConfigError) {
  const std::string alphabet = "0123456789 \n\n.-|_ouS'\"#;%e\t\r";
  const char* const words[] = {"floor ",           "push ",     "pop\n",   "psd ",    "error ",
                               "drive ",           "world ",    "robi ",   "S4 ",     "wheel ",
                               "camera ",          "1e308 ",    "-0 ",     "nan ",    "box ",
                               "Can 1 2 3\npath ", "friction ", "kicker ", "fixed\n", "loop "};
  std::uint32_t state = 12345;
  const auto next = [&] { return (state = state * 1664525U + 1013904223U) >> 8U; };
  int read = 0;
  int refused = 0;
  for (int round = 0; round < 2000; ++round) {
    std::string text;
    for (int i = 0; i < 40; ++i) {
      if (next() % 4 == 0) {
        text += words[next() % std::size(words)];
      } else {
        text += alphabet[next() % alphabet.size()];
      }
    }
    for (const Row& reader : kReaders) {
      std::vector<Warning> warnings;
      try {
        reader.read(text, warnings);
        ++read;
      } catch (const ConfigError& error) {
        EXPECT_EQ(error.where().file, "f");
        ++refused;
      }
    }
  }
  EXPECT_GT(read, 0);
  EXPECT_GT(refused, 0);
}

}  // namespace
}  // namespace eyebridge::files
