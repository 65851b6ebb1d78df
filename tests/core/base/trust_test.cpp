#include "eyebridge/base/trust.hpp"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

namespace eyebridge {
namespace {

namespace fs = std::filesystem;

class TrustTest : public ::testing::Test {
 protected:
  TrustTest() : root_(fs::path(::testing::TempDir()) / "trust"), trust_(root_ / "kept") {
    fs::remove_all(root_);
    fs::create_directories(root_ / "folder");
    std::ofstream(file_) << "x";
  }
  ~TrustTest() override { fs::remove_all(root_); }

  fs::path root_;
  fs::path file_ = root_ / "folder" / "a\nb.sim";
  Trust trust_;
};

TEST_F(TrustTest, HoldsForTheWordsThatWereGivenAndNoOthers) {
  EXPECT_FALSE(trust_.covers(file_, "program = one"));
  trust_.give(file_, {"program = one", "two\nlines\\n"});
  EXPECT_TRUE(trust_.covers(file_, "program = one"));
  EXPECT_TRUE(trust_.covers(file_, "two\nlines\\n"));
  for (const char* other : {"two", "lines\\n", "two\\nlines\n", "program = on", ""}) {
    EXPECT_FALSE(trust_.covers(file_, other)) << other;
  }
  trust_.give(file_, {"program = two"});
  EXPECT_FALSE(trust_.covers(file_, "program = one")) << "what was agreed to last counts";
}

TEST_F(TrustTest, IsOfTheFileWhereverItIsNamedFrom) {
  trust_.give(file_, {"out = /x"});
  EXPECT_TRUE(trust_.covers(root_ / "folder/../folder" / file_.filename(), "out = /x"));
  fs::create_directory_symlink("folder", root_ / "link");
  EXPECT_TRUE(trust_.covers(root_ / "link" / file_.filename(), "out = /x"));
  EXPECT_FALSE(trust_.covers(root_ / "other" / file_.filename(), "out = /x"));
}

TEST_F(TrustTest, IsListedAndTakenBack) {
  EXPECT_TRUE(trust_.entries().empty());
  trust_.give(file_, {"one", "two"});
  ASSERT_EQ(trust_.entries().size(), 1U);
  EXPECT_EQ(trust_.entries()[0].file, fs::canonical(file_));
  EXPECT_EQ(trust_.entries()[0].asked, (std::vector<std::string>{"one", "two"}));
  EXPECT_TRUE(trust_.take_back(file_));
  EXPECT_FALSE(trust_.take_back(file_));
  EXPECT_FALSE(trust_.covers(file_, "one"));
}

TEST_F(TrustTest, WithoutAFolderNothingIsTrusted) {
  const Trust none{fs::path()};
  EXPECT_FALSE(none.covers(file_, "one"));
  EXPECT_THROW(none.give(file_, {"one"}), fs::filesystem_error);
  EXPECT_FALSE(none.take_back(file_));
  EXPECT_TRUE(none.entries().empty());
}

TEST_F(TrustTest, AFileIsWithinAFolderWhereLinksLead) {
  EXPECT_TRUE(is_within(file_, root_ / "folder"));
  EXPECT_TRUE(is_within(file_, root_ / "folder/"));
  EXPECT_TRUE(is_within(root_ / "folder/not/yet", root_ / "folder"));
  EXPECT_FALSE(is_within(root_ / "folder/../x", root_ / "folder"));
  EXPECT_FALSE(is_within(root_ / "folder-2/x", root_ / "folder"));
  EXPECT_FALSE(is_within("/bin/sh", root_));
  fs::create_symlink("/bin/sh", root_ / "folder/inside");
  EXPECT_FALSE(is_within(root_ / "folder/inside", root_ / "folder"));
  EXPECT_TRUE(is_within("x", ""));
}

}  // namespace
}  // namespace eyebridge
