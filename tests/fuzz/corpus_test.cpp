#include <cstdio>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>

#include "entry.hpp"

namespace eyebridge::fuzz {
namespace {

using Entry = void (*)(std::string_view);

struct Target {
  const char* name;
  Entry run;
};

class FuzzCorpus : public testing::TestWithParam<Target> {};

void PrintTo(const Target& target, std::ostream* out) { *out << target.name; }

TEST_P(FuzzCorpus, EveryInputGivesAModelOrAConfigError) {
  const auto folder =
      std::filesystem::path(EYEBRIDGE_SOURCE_DIR) / "tests/fuzz/corpus" / GetParam().name;
  ASSERT_TRUE(std::filesystem::is_directory(folder)) << folder << " is missing";
  int inputs = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    std::FILE* file = std::fopen(entry.path().c_str(), "rb");
    ASSERT_NE(file, nullptr) << entry.path();
    std::string text(static_cast<std::size_t>(entry.file_size()), '\0');
    const std::size_t got = std::fread(text.data(), 1, text.size(), file);
    std::fclose(file);
    ASSERT_EQ(got, text.size()) << entry.path();
    GetParam().run(text);
    ++inputs;
  }
  EXPECT_GE(inputs, 3);
}

INSTANTIATE_TEST_SUITE_P(Readers, FuzzCorpus,
                         testing::Values(Target{"world", world}, Target{"maze", maze},
                                         Target{"robi", robi}, Target{"sim", sim},
                                         Target{"parameter", parameter}, Target{"pnm", pnm},
                                         Target{"picture", picture}, Target{"config", config}),
                         [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace eyebridge::fuzz
