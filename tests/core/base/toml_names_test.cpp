#include "eyebridge/base/toml_names.hpp"

#include <gtest/gtest.h>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge {
namespace {

TEST(TomlNames, AreLettersDigitsOrQuotesAfterOneOrTwoBrackets) {
  for (const char* toml : {"", "[", "[mix]\n", " [ mix ]", "[[list]]", "a = 1\n[\"x y\"]\n['z']",
                           "[]", "[-a]", "list = [\n  1, 2]\n", "a = '[?'"}) {
    EXPECT_NO_THROW(check_table_names(toml, "f.toml")) << toml;
  }
}

TEST(TomlNames, AnythingElseIsAnErrorAtItsPlace) {
  const auto place_of = [](const char* toml) {
    try {
      check_table_names(toml, "f.toml");
    } catch (const ConfigError& error) {
      return error.where();
    }
    return SourceLocation{};
  };
  EXPECT_EQ(place_of("[?]"), (SourceLocation{"f.toml", 1, 2}));
  EXPECT_EQ(place_of("a = 1\n [[ = ]]"), (SourceLocation{"f.toml", 2, 5}));
  EXPECT_EQ(place_of("[\n"), (SourceLocation{"f.toml", 1, 2}));
  EXPECT_EQ(place_of("\n\n[~c3~a9]"), (SourceLocation{"f.toml", 3, 2}));
}

// A file of 80 kB ended every command in its folder: "a.a.a. … .a = 1" fills the reader's stack.
TEST(TomlNames, ANameOfThousandsOfPartsIsAnErrorAtItsLine) {
  std::string deep = "b = 2\na";
  for (int i = 0; i < 1000; ++i) deep += ".a";
  EXPECT_NO_THROW(check_table_names(deep + " = 1", "f.toml"));
  for (const std::string& toml : {deep + ".a = 1", "b = 2\n[a" + deep.substr(7) + ".a]"}) {
    try {
      check_table_names(toml, "f.toml");
      ADD_FAILURE() << "taken";
    } catch (const ConfigError& error) {
      EXPECT_EQ(error.where(), (SourceLocation{"f.toml", 2, 1}));
    }
  }
}

}  // namespace
}  // namespace eyebridge
