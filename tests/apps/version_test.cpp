// eyebridge --version, and the script that finds the commit for it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "command.hpp"

namespace eyebridge {
namespace {

using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using testing::ProgramRun;
using testing::run_command;
using testing::ScratchFolder;

TEST(Version, HasTheCommit) {
  const ProgramRun r = run_command({"--version"}, ".");
  EXPECT_EQ(r.exit_code, 0);
  EXPECT_THAT(r.out, MatchesRegex("eyebridge " EYEBRIDGE_VERSION
                                  " \\((commit [0-9A-Za-z._+~-]+|unknown commit)\\)\n"));
}

/// What the script makes of a folder.
class Commit : public ::testing::Test {
 protected:
  ProgramRun script(const std::string& commit = "") const {
    return testing::run_program(
        {{"cmake", "-D", "SOURCE=" + folder_.path(), "-D", "OUTPUT=" + output(), "-D",
          "COMMIT=" + commit, "-P", EYEBRIDGE_SOURCE_DIR "/cmake/EyebridgeCommit.cmake"},
         {},
         folder_.path()});
  }
  std::string output() const { return folder_.path() + "/commit.cpp"; }
  /// What commit() would return.
  std::string commit(const std::string& commit = "") const {
    const ProgramRun r = script(commit);
    EXPECT_EQ(r.exit_code, 0) << r.err;
    const std::string text = testing::file_text(output());
    const std::size_t begin = text.find("return \"") + 8;
    return text.substr(begin, text.find('"', begin) - begin);
  }
  void shell(const std::string& command) const {
    const ProgramRun r = testing::run_program(
        {{"sh", "-euc", command},
         {{"GIT_CONFIG_GLOBAL", "/dev/null"}, {"GIT_CONFIG_SYSTEM", "/dev/null"}},
         folder_.path()});
    ASSERT_EQ(r.exit_code, 0) << r.err;
  }
  void make_archive(const std::string& line) const {
    shell("mkdir cmake");
    folder_.write("cmake/commit.txt", line + "\n");
  }

  const ScratchFolder folder_;
};

TEST_F(Commit, IsUnknownWithoutGitOrArchive) {
  EXPECT_EQ(commit(), "unknown commit");
  make_archive("$Format:%H$");
  EXPECT_EQ(commit(), "unknown commit");
}

TEST_F(Commit, IsThatOfAnArchive) {
  make_archive("4aec93400b2f00112233445566778899aabbccdd");
  EXPECT_EQ(commit(), "commit 4aec93400b2f");
}

TEST_F(Commit, OfASourceDistributionSaysWhetherFilesWereChanged) {
  make_archive("4aec93400b2f00112233445566778899aabbccdd-modified");
  EXPECT_EQ(commit(), "commit 4aec93400b2f-modified");
}

TEST_F(Commit, IsWhatAPackageSays) {
  make_archive("4aec93400b2f00112233445566778899aabbccdd");
  EXPECT_EQ(commit("0.2.0-1~deb12"), "commit 0.2.0-1~deb12");
  const ProgramRun r = script("a\"b");
  EXPECT_NE(r.exit_code, 0);
  EXPECT_THAT(r.err, HasSubstr("EYEBRIDGE_COMMIT is 'a\"b'"));
}

TEST_F(Commit, IsThatOfGitAndSaysWhetherFilesWereChanged) {
  folder_.write("a.txt", "1\n");
  shell("git init -q . && git add a.txt && git -c user.name=a -c user.email=a@b commit -qm one");
  const std::string clean = commit();
  EXPECT_THAT(clean, MatchesRegex("commit [0-9a-f]{12}"));
  folder_.write("a.txt", "2\n");
  EXPECT_EQ(commit(), clean + "-modified");
}

TEST_F(Commit, IsWrittenOnlyWhenItChanges) {
  ASSERT_EQ(script().exit_code, 0);
  shell("touch -d 2001-01-01 commit.cpp && cp -p commit.cpp before");
  ASSERT_EQ(script().exit_code, 0);
  shell("[ ! commit.cpp -nt before ]");
  ASSERT_EQ(script("other").exit_code, 0);
  shell("[ commit.cpp -nt before ]");
}

}  // namespace
}  // namespace eyebridge
