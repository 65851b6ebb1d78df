#include "eyebridge/base/own_results.hpp"

#include <filesystem>
#include <fstream>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

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

TEST_F(OwnResults, AreMissedWhereTheyWere) {
  const std::filesystem::path path = std::filesystem::path(::testing::TempDir()) / "own_result";
  std::filesystem::remove(path);
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  EXPECT_TRUE(is_still_at(path, file));
  std::filesystem::remove(path);
  EXPECT_FALSE(is_still_at(path, file));
  std::ofstream(path) << "another one";
  EXPECT_FALSE(is_still_at(path, file));
  close(file);
  std::filesystem::remove(path);
}

TEST_F(OwnResults, DoNotFollowLinksToOtherFolders) {
  const fs::path other = path_.string() + "_other";
  std::ofstream(other) << "work";
  for (const fs::path& target : {other, fs::path("nowhere"), fs::path("/tmp")}) {
    fs::create_symlink(target, path_);
    drop_link(path_);
    EXPECT_FALSE(fs::is_symlink(path_)) << target;
  }
  EXPECT_TRUE(fs::exists(other));
  fs::create_symlink("/dev/full", path_);
  drop_link(path_);
  EXPECT_TRUE(fs::is_symlink(path_)) << "nothing is lost there";
  fs::remove(path_);
  std::ofstream(path_) << "work";
  drop_link(path_);
  EXPECT_TRUE(fs::exists(path_));
  fs::remove(other);
}

}  // namespace
}  // namespace eyebridge
