#include "eyebridge/base/own_results.hpp"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class OwnResults : public ::testing::Test {
 protected:
  OwnResults() { fs::remove_all(path_); }
  ~OwnResults() override { fs::remove_all(path_); }
  std::string complaint() {
    try {
      check_replaceable(path_, "report", "time = ");
      return "";
    } catch (const ConfigError& error) {
      return error.what();
    }
  }
  fs::path path_ = fs::path(::testing::TempDir()) / "own_results";
};

TEST_F(OwnResults, ReplaceNothingThatIsSomebodysWork) {
  EXPECT_EQ(complaint(), "") << "nothing is there";
  for (const char* own : {"", "time = 1.0\n", "time = "}) {
    std::ofstream(path_) << own;
    EXPECT_EQ(complaint(), "") << own;
  }
  for (const char* other : {"int main() {}", "time", "\n", " time = 1"}) {
    std::ofstream(path_) << other;
    EXPECT_THAT(complaint(), HasSubstr("found another kind of file, expected a new name, or an "
                                       "earlier report"))
        << other;
  }
}

TEST_F(OwnResults, GoToRegularFilesAndToDevicesThatKeepNothing) {
  fs::create_directory(path_);
  EXPECT_THAT(complaint(), HasSubstr("found a folder"));
  fs::remove(path_);
  ASSERT_EQ(mkfifo(path_.c_str(), 0600), 0);
  EXPECT_THAT(complaint(), HasSubstr("found no regular file"));
  fs::remove(path_);
  fs::create_symlink("/dev/null", path_);
  EXPECT_EQ(complaint(), "");
}

}  // namespace
}  // namespace eyebridge
