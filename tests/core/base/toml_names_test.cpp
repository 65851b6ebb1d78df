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

}  // namespace
}  // namespace eyebridge
