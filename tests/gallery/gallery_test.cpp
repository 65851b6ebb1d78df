// Programs as users write them: what each prints, shows, writes and how its robot moves is as a
// person has once found right. programs.toml lists them, ./accept writes a golden anew.

#include <cstdlib>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gallery_run.hpp"
#include "run_program.hpp"

namespace eyebridge::gallery {
namespace {

namespace fs = std::filesystem;

constexpr double kCameraCells = 0.05;

fs::path golden_of(const Row& row) {
  return fs::path(EYEBRIDGE_SOURCE_DIR) / "tests/gallery/golden" / (row.name + ".txt");
}

Golden read_golden(const Row& row) { return parse_golden(testing::file_text(golden_of(row))); }

/// Writes the golden anew; what was said about the old one stays while nothing has changed.
void accept(const Row& row, Golden run) {
  const Golden before = read_golden(row);
  if (differences(before, run, {}).empty()) run.review = before.review;
  std::ofstream(golden_of(row), std::ios::binary) << to_text(run);
}

class Gallery : public ::testing::TestWithParam<Row> {};

TEST_P(Gallery, ARunLeavesWhatWasOnceFoundRight) {
  const Row& row = GetParam();
  const char* pictures = std::getenv("EYEBRIDGE_TEST_PICTURES");
  const Golden run = run_program_of(row, pictures == nullptr ? "" : pictures);
  if (std::getenv("EYEBRIDGE_TEST_ACCEPT") != nullptr) accept(row, run);

  const Golden golden = read_golden(row);
  EXPECT_FALSE(golden.review.empty()) << golden_of(row) << ": nobody has looked at it yet";
  for (const std::string& line :
       differences(golden, run, {row.tolerance, row.camera ? kCameraCells : 0.0})) {
    ADD_FAILURE() << line;
  }
}

INSTANTIATE_TEST_SUITE_P(Programs, Gallery,
                         ::testing::ValuesIn(read_table(EYEBRIDGE_SOURCE_DIR
                                                        "/tests/gallery/programs.toml")),
                         [](const auto& one) { return one.param.name; });

TEST(GalleryTable, EveryGoldenBelongsToAProgram) {
  std::vector<std::string> expected;
  for (const Row& row : read_table(EYEBRIDGE_SOURCE_DIR "/tests/gallery/programs.toml")) {
    expected.push_back(row.name + ".txt");
  }
  std::vector<std::string> found;
  for (const auto& entry : fs::directory_iterator(EYEBRIDGE_SOURCE_DIR "/tests/gallery/golden")) {
    found.push_back(entry.path().filename());
  }
  std::ranges::sort(expected);
  std::ranges::sort(found);
  EXPECT_EQ(found, expected);
}

TEST(GalleryTable, AMistakeSaysWhatWasFoundAndWhatWasExpected) {
  const testing::ScratchFolder scratch;
  for (const auto& [text, complaint] : {
           std::pair{"[a]\nsource = 5", "programs.toml:2: found 5, expected a string"},
           std::pair{"[a]\ncamera = 1", "programs.toml:2: found 1, expected true or false"},
           std::pair{"[a]\nfiles = 'b'", "found 'b', expected a list of strings"},
           std::pair{"[a]\ntolerance = -1", "found -1, expected a number from 0"},
           std::pair{"[a]\nwrold = 'b'", "found the key 'wrold', expected one"},
           std::pair{"[a]\nworld = 'b'", "programs.toml:1: found no source of a"},
           std::pair{"a = 1", "found 1, expected a table"},
       }) {
    const std::string file = scratch.write("programs.toml", text);
    EXPECT_THAT([&] { read_table(file); },
                ::testing::ThrowsMessage<std::runtime_error>(::testing::HasSubstr(complaint)));
  }
}

}  // namespace
}  // namespace eyebridge::gallery
