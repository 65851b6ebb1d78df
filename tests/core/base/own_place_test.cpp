#include "eyebridge/base/own_place.hpp"

#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

namespace eyebridge {
namespace {

namespace fs = std::filesystem;

/// An empty folder that goes away with the test.
class OwnPlace : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "eyebridge-place-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    root_ = fs::canonical(pattern);
  }
  void TearDown() override { fs::remove_all(root_); }

  fs::path file(const fs::path& name) {
    fs::create_directories((root_ / name).parent_path());
    std::ofstream(root_ / name) << "\n";
    return root_ / name;
  }

  fs::path root_;
};

TEST_F(OwnPlace, IsTheFileOfTheProgramItself) {
  EXPECT_EQ(own_binary(), fs::read_symlink("/proc/self/exe"));
}

TEST_F(OwnPlace, FindsTheDataAbove) {
  const fs::path library = file("usr/lib/x86_64-linux-gnu/libeyebridge.so.0");
  const fs::path command = file("usr/bin/eyebridge");
  EXPECT_EQ(share_folder(library), "");
  fs::create_directories(root_ / "usr/share/eyebridge");
  EXPECT_EQ(share_folder(library), root_ / "usr/share/eyebridge");
  EXPECT_EQ(share_folder(command), root_ / "usr/share/eyebridge");
}

TEST_F(OwnPlace, TakesTheNearestData) {
  const fs::path library = file("usr/lib/python3/dist-packages/eyebridge/lib/libeyebridge.so");
  fs::create_directories(root_ / "usr/share/eyebridge");
  fs::create_directories(root_ / "usr/lib/python3/dist-packages/eyebridge/share/eyebridge");
  EXPECT_EQ(share_folder(library),
            root_ / "usr/lib/python3/dist-packages/eyebridge/share/eyebridge");
}

TEST_F(OwnPlace, FollowsLinksToTheRealFile) {
  const fs::path real = file("opt/eyebridge/bin/eyebridge");
  fs::create_directories(root_ / "opt/eyebridge/share/eyebridge");
  fs::create_directories(root_ / "home/bin");
  fs::create_symlink(real, root_ / "home/bin/eyebridge");
  EXPECT_EQ(share_folder(root_ / "home/bin/eyebridge"), root_ / "opt/eyebridge/share/eyebridge");
}

TEST_F(OwnPlace, TakesDataThatIsALink) {
  const fs::path command = file("build/release/bin/eyebridge");
  fs::create_directories(root_ / "source");
  fs::create_directories(root_ / "build/release/share");
  fs::create_directory_symlink(root_ / "source", root_ / "build/release/share/eyebridge");
  EXPECT_EQ(share_folder(command), root_ / "build/release/share/eyebridge");
}

TEST_F(OwnPlace, HasNoDataWhereTheFileIsMissing) {
  EXPECT_EQ(share_folder(root_ / "missing/eyebridge"), "");
  EXPECT_EQ(share_folder(fs::path()), "");
}

TEST_F(OwnPlace, AFileIsNoFolderOfData) {
  const fs::path command = file("usr/bin/eyebridge");
  file("usr/share/eyebridge");
  EXPECT_EQ(share_folder(command), "");
}

TEST_F(OwnPlace, FindsPlugInsFromTheProgramTheLibraryAndPython) {
  file("usr/" EYEBRIDGE_PLUGIN_DIR "/libeyebridge_gui.so");
  const fs::path plugins = root_ / "usr/" EYEBRIDGE_PLUGIN_DIR;
  EXPECT_EQ(plugin_folder(file("usr/bin/eyebridge")), plugins);
  EXPECT_EQ(plugin_folder(plugins / "libeyebridge_gui.so"), plugins);
  EXPECT_EQ(plugin_folder(file("usr/lib/python3/dist-packages/eyebridge/_core.so")), plugins);
  EXPECT_EQ(plugin_folder(file("home/bin/eyebridge")), "");
}

TEST_F(OwnPlace, FindsThePythonPackagesOfAnInstallation) {
  const fs::path packages = file("usr/lib/python3/dist-packages/eye/__main__.py").parent_path();
  const fs::path command = file("usr/bin/eyebridge");
  EXPECT_EQ(python_folder(command), "");
  fs::create_directories(root_ / "usr/" EYEBRIDGE_PLUGIN_DIR "/python");
  EXPECT_EQ(python_folder(command), "");
  fs::create_directory_symlink(packages.parent_path() / "eye",
                               root_ / "usr/" EYEBRIDGE_PLUGIN_DIR "/python/eye");
  EXPECT_EQ(python_folder(command), root_ / "usr/" EYEBRIDGE_PLUGIN_DIR "/python");
}

TEST_F(OwnPlace, FindsThePythonPackagesBesideAWheel) {
  file("site-packages/eye/__main__.py");
  const fs::path library = file("site-packages/eyebridge/lib/libeyebridge.so.0");
  fs::create_directories(root_ / "site-packages/eyebridge/lib/eyebridge");
  EXPECT_EQ(python_folder(library), root_ / "site-packages");
}

}  // namespace
}  // namespace eyebridge
