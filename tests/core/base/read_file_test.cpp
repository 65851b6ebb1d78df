#include "eyebridge/base/read_file.hpp"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <sys/stat.h>

namespace eyebridge {
namespace {

namespace fs = std::filesystem;

class ReadFile : public ::testing::Test {
 protected:
  ReadFile() { fs::remove_all(path_); }
  ~ReadFile() override { fs::remove_all(path_); }
  std::string complaint(std::uintmax_t most = 100) {
    const auto bytes = read_file(path_, most);
    return bytes ? "" : bytes.error().what;
  }
  fs::path path_ = fs::path(::testing::TempDir()) / "read_file";
};

TEST_F(ReadFile, GivesAllOfIt) {
  const std::string text("a\0b\r\n\xFF", 6);
  std::ofstream(path_, std::ios::binary) << text;
  EXPECT_EQ(read_file(path_, 6).value(), text);
  EXPECT_EQ(first_bytes(path_, 2), text.substr(0, 2));
  EXPECT_EQ(first_bytes(path_, 60), text);
  EXPECT_EQ(complaint(5), "has 6 bytes, expected at most 5");
  std::ofstream(path_, std::ios::trunc);
  EXPECT_EQ(read_file(path_, 0).value(), "");
}

TEST_F(ReadFile, NeverWaits) {
  EXPECT_EQ(complaint(), "no such file");
  ASSERT_EQ(mkfifo(path_.c_str(), 0600), 0);
  EXPECT_EQ(complaint(), "is not a file");
  EXPECT_EQ(first_bytes(path_, 4), "");
  fs::remove(path_);
  fs::create_symlink("/dev/zero", path_);
  EXPECT_EQ(complaint(), "is not a file");
  fs::remove(path_);
  fs::create_directory(path_);
  EXPECT_EQ(complaint(), "is not a file");
}

}  // namespace
}  // namespace eyebridge
