#include "eyebridge/base/write_file.hpp"

#include <csignal>
#include <filesystem>
#include <iterator>
#include <string>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "eyebridge/base/read_file.hpp"

namespace eyebridge {
namespace {

namespace fs = std::filesystem;

class WriteFile : public ::testing::Test {
 protected:
  WriteFile() {
    fs::remove_all(folder_);
    fs::create_directory(folder_);
  }
  ~WriteFile() override { fs::remove_all(folder_); }
  [[nodiscard]] std::string text() const { return read_file(path_, 100).value_or("?"); }
  [[nodiscard]] std::ptrdiff_t files() const {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  }
  static std::string complaint(const fs::path& path, std::string_view bytes = "new") {
    const auto done = write_file(path, bytes);
    return done ? "" : done.error().what;
  }
  fs::path folder_ = fs::path(::testing::TempDir()) / "write_file";
  fs::path path_ = folder_ / "result";
};

TEST_F(WriteFile, MakesItAndReplacesIt) {
  const std::string bytes("a\0b\r\n\xFF", 6);
  EXPECT_EQ(complaint(path_, bytes), "");
  EXPECT_EQ(text(), bytes);
  fs::permissions(path_, fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(complaint(path_, ""), "");
  EXPECT_EQ(text(), "");
  EXPECT_EQ(fs::status(path_).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(files(), 1);
}

// A process that was told to end left half a picture, which nothing could show.
TEST_F(WriteFile, AReaderNeverSeesAPartOfIt) {
  ASSERT_EQ(complaint(path_, "old"), "");
  const int before = open(path_.c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_EQ(complaint(path_), "");
  char seen[4] = {};
  EXPECT_EQ(read(before, seen, 3), 3);
  close(before);
  EXPECT_STREQ(seen, "old") << "the new one is another file";
  EXPECT_EQ(text(), "new");
}

TEST_F(WriteFile, AFullDiskLeavesWhatWasThere) {
  ASSERT_EQ(complaint(path_, "old"), "");
  rlimit usual{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &usual), 0);
  const rlimit small{2, usual.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string found = complaint(path_);
  setrlimit(RLIMIT_FSIZE, &usual);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(found, "cannot be written: File too large");
  EXPECT_EQ(text(), "old");
  EXPECT_EQ(files(), 1);
}

TEST_F(WriteFile, ALinkStaysOneAndADeviceIsWrittenTo) {
  const fs::path link = folder_ / "link";
  ASSERT_EQ(complaint(path_, "old"), "");
  fs::create_symlink("result", link);
  EXPECT_EQ(complaint(link), "");
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(text(), "new");
  EXPECT_EQ(complaint("/dev/null"), "");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_EQ(complaint("/dev/full"), "cannot be written: No space left on device");
}

// A downloaded folder had a link for every name that a process might choose.
TEST_F(WriteFile, PreparedLinksLeadNowhere) {
  const fs::path victim = folder_ / "victim";
  ASSERT_EQ(complaint(victim, "precious"), "");
  for (int pid = 1; pid <= 32768; pid += 1) {
    fs::create_symlink(victim, folder_ / ("result." + std::to_string(pid) + ".part"));
  }
  EXPECT_EQ(complaint(path_), "");
  EXPECT_EQ(text(), "new");
  EXPECT_FALSE(fs::is_symlink(path_));
  EXPECT_EQ(read_file(victim, 100).value(), "precious");
}

TEST_F(WriteFile, APipeThatNobodyReadsIsNotWaitedFor) {
  ASSERT_EQ(mkfifo(path_.c_str(), 0600), 0);
  EXPECT_EQ(complaint(path_), "cannot be written: No such device or address");
}

TEST_F(WriteFile, SaysWhyItCannot) {
  EXPECT_EQ(complaint(folder_ / "none/result"), "cannot be written: No such file or directory");
  EXPECT_EQ(complaint(folder_), "cannot be written: Is a directory");
}

}  // namespace
}  // namespace eyebridge
