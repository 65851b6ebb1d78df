#include <map>
#include <sstream>

#include <gmock/gmock.h>

#include "reading.hpp"

namespace eyebridge::files {
namespace {

const std::filesystem::path kData = std::filesystem::path(EYEBRIDGE_SHARED_DIR) / "data/worlds";
const std::filesystem::path kTable =
    std::filesystem::path(EYEBRIDGE_SOURCE_DIR) / "tests/core/files/shared_worlds.txt";

/// Without those of the user.
const SearchPlaces kPlaces{{}, {}, {}, own_worlds()};

/// "file | outcome" lines; `#` starts a comment line.
std::map<std::string, std::string> table() {
  std::map<std::string, std::string> rows;
  std::ifstream in(kTable);
  for (std::string line; std::getline(in, line);) {
    const std::size_t bar = line.find(" | ");
    if (line.starts_with('#') || bar == std::string::npos) continue;
    rows[line.substr(0, bar)] = line.substr(bar + 3);
  }
  return rows;
}

std::string outcome(const std::filesystem::path& path) {
  try {
    const Scenario scenario = load_scenario(path, {.places = kPlaces});
    std::ostringstream out;
    out << "walls " << scenario.world.walls.size() << ", objects " << scenario.world.objects.size()
        << ", starts " << scenario.world.starts.size() << ", robots " << scenario.robots.size()
        << ", warnings " << scenario.warnings.size();
    return out.str();
  } catch (const ConfigError& error) {
    // Where it was looked for depends on the machine.
    const std::string text = error.what();
    return without(text.substr(0, text.find("; looked in ")), kData.string() + "/");
  }
}

TEST(SharedWorlds, EveryPublishedFileGivesTheReviewedOutcome) {
  ASSERT_TRUE(std::filesystem::is_directory(kData)) << kData << " is missing";
  std::map<std::string, std::string> expected = table();
  ASSERT_FALSE(expected.empty()) << kTable << " is missing";
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kData)) {
    if (!entry.is_regular_file()) continue;
    const std::string file = std::filesystem::relative(entry.path(), kData).generic_string();
    const auto row = expected.find(file);
    if (row == expected.end()) {
      ADD_FAILURE() << "no row for\n" << file << " | " << outcome(entry.path());
      continue;
    }
    EXPECT_EQ(outcome(entry.path()), row->second) << file;
    expected.erase(row);
  }
  for (const auto& [file, text] : expected) ADD_FAILURE() << "no file for the row " << file;
}

}  // namespace
}  // namespace eyebridge::files
