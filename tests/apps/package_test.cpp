#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "command.hpp"

namespace eyebridge {
namespace {

using ::testing::HasSubstr;
using testing::ProgramRun;
using testing::run_shell;
using testing::ScratchFolder;

const std::string kConsumer = EYEBRIDGE_SOURCE_DIR "/tests/apps/consumer/";

/// Builds and runs the consumer in `folder` with CMake, its EyeBridge taken from `prefix`.
std::string with_cmake(const std::string& prefix, const std::string& folder = kConsumer) {
  return "cmake -S " + folder + " -B by_cmake -G Ninja -DCMAKE_PREFIX_PATH=" + prefix +
         " >log 2>&1 || { cat log >&2; exit 1; }\n"
         "cmake --build by_cmake >log 2>&1 || { cat log >&2; exit 1; }\nby_cmake/prog\n";
}

/// The same with pkg-config.
std::string with_pkg_config(const std::string& prefix) {
  return "export PKG_CONFIG_PATH=" + prefix +
         "/lib/pkgconfig\n"
         "gcc $(pkg-config --cflags eyebridge) " +
         kConsumer + "prog.c -o by_pkg_config $(pkg-config --libs eyebridge)\n./by_pkg_config\n";
}

class Package : public ::testing::Test {
 protected:
  /// An installation that was moved after it was made, as a package may be.
  static std::string installed() {
    return "cmake --install " EYEBRIDGE_BUILD_DIR
           " --prefix first >log 2>&1 || { cat log >&2; exit 1; }\nmv first moved\n";
  }
  void expect_it_drives(const std::string& script) {
    const ProgramRun r = run_shell(script, folder_.path());
    EXPECT_EQ(r.exit_code, 0) << r.err;
    EXPECT_EQ(r.out, "at 300 0 90\n") << r.err;
  }
  ScratchFolder folder_;
};

TEST_F(Package, CMakeFindsTheBuildTree) { expect_it_drives(with_cmake(EYEBRIDGE_BUILD_DIR)); }

TEST_F(Package, PkgConfigFindsTheBuildTree) {
  expect_it_drives(with_pkg_config(EYEBRIDGE_BUILD_DIR));
}

TEST_F(Package, CMakeFindsAnInstallation) {
  expect_it_drives(installed() + with_cmake("$PWD/moved"));
}

TEST_F(Package, ProgramsCanRunEpisodesThemselves) {
  for (const std::string& prefix : {std::string(EYEBRIDGE_BUILD_DIR), std::string("$PWD/moved")}) {
    const ScratchFolder folder;
    const ProgramRun r =
        run_shell((prefix[0] == '$' ? installed() : "") + with_cmake(prefix, kConsumer + "episode"),
                  folder.path());
    EXPECT_EQ(r.exit_code, 0) << r.err;
    EXPECT_EQ(r.out, "at 1.2, 3 rows\n") << r.err;
  }
}

TEST_F(Package, PkgConfigFindsAnInstallation) {
  expect_it_drives(installed() + with_pkg_config("$PWD/moved"));
}

TEST_F(Package, TheWrapperOfAnInstallationUsesItsOwnFiles) {
  expect_it_drives(installed() + "moved/bin/eyebridge-cc " + kConsumer +
                   "prog.c -o prog\nldd prog | grep -q \"$PWD/moved/lib/libeyebridge\"\n"
                   "moved/bin/eyebridge run ./prog\n");
}

TEST_F(Package, AnInstallationHasTheNamesOfEyeSimsWrappers) {
  const std::string program = kConsumer + "prog.c -o prog\n";
  expect_it_drives(installed() + "moved/bin/gccarm " + program + "moved/bin/gccsim " + program +
                   "./prog\nmoved/bin/g++sim " + kConsumer +
                   "prog.cpp -o prog\n"
                   "moved/bin/g++arm " +
                   kConsumer + "prog.cpp -o prog\n");
}

TEST_F(Package, TheDoctorOfAnInstallationFindsItsFiles) {
  const ProgramRun r = run_shell(installed() + "moved/bin/eyebridge doctor\n", folder_.path());
  EXPECT_EQ(r.exit_code, 0) << r.out;
  EXPECT_THAT(r.out, HasSubstr("/moved/include/eyebridge/eyebot.h\n"));
  EXPECT_THAT(r.out, HasSubstr("/moved/share/eyebridge/worlds\n"));
}

TEST_F(Package, TheRuleForUdevIsInstalled) {
  const ProgramRun r =
      run_shell(installed() + "moved/bin/eyebridge doctor --udev\n", folder_.path());
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.out, testing::file_text(EYEBRIDGE_SOURCE_DIR "/apps/udev/60-eyebridge.rules"));
}

}  // namespace
}  // namespace eyebridge
