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
         "/" EYEBRIDGE_LIBDIR
         "/pkgconfig\n"
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
                   "prog.c -o prog\nldd prog | grep -q \"$PWD/moved/" EYEBRIDGE_LIBDIR
                   "/libeyebridge\"\n"
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

// A user's program in an installation sees nothing of the computer that it was built on. Debug
// information and assert() name sources, and may.
#ifdef NDEBUG
TEST_F(Package, NothingOfTheSourceOrTheBuildFolderIsInAnInstallation) {
  const ProgramRun r =
      run_shell(installed() +
                    "find moved -type f -exec strip -g {} + 2>/dev/null || true\n"
                    "grep -rlF -e '" EYEBRIDGE_SOURCE_DIR "' -e '" EYEBRIDGE_BUILD_DIR
                    "' moved || true\n"
                    "find moved -lname '/*'\n",
                folder_.path());
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.out, "");
}
#endif

TEST_F(Package, EveryFileBelongsToOneComponent) {
  const std::string install = "cmake --install " EYEBRIDGE_BUILD_DIR " --prefix ";
  const ProgramRun r = run_shell(
      installed() + "for c in runtime development python gui documentation firmware; do\n" +
          install + "$c --component $c >>log\n(cd $c && find * ! -type d) >>parts\ndone\n" +
          "(cd moved && find * ! -type d) | sort >whole\nsort parts | diff - whole\n"
          "cat whole\n",
      folder_.path());
  EXPECT_EQ(r.exit_code, 0) << r.out << r.err;
  for (const char* file :
       {"bin/eyebridge", "bin/gccsim", EYEBRIDGE_LIBDIR "/libeyebridge.so",
        EYEBRIDGE_LIBDIR "/libeyebridge.so.0", EYEBRIDGE_LIBDIR "/eyebridge/eyebridge-robots",
        "lib/udev/rules.d/60-eyebridge.rules", "share/eyebridge/worlds/rooms.wld",
        "share/eyebridge/examples/square.c", "share/eyebridge/firmware/source/opcodes.h",
        "share/eyebridge/firmware/source/board/src/eb_board.c",
        "share/doc/eyebridge/docs/tour.md"}) {
    EXPECT_THAT("\n" + r.out, HasSubstr(std::string("\n") + file + "\n"));
  }
}

TEST_F(Package, AnInstallationCanBePutBelowAnotherRoot) {
  const ProgramRun r = run_shell("DESTDIR=$PWD/root cmake --install " EYEBRIDGE_BUILD_DIR
                                 " --prefix /opt/eb >log\nls root root/opt/eb\n",
                                 folder_.path());
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.out, "root:\nopt\n\nroot/opt/eb:\nbin\ninclude\nlib\nshare\n");
}

TEST_F(Package, RobotsOfAnInstallationRunSideBySide) {
  const ProgramRun r = run_shell(installed() + "moved/bin/eyebridge-cc " + kConsumer +
                                     "prog.c -o prog\n"
                                     "moved/bin/eyebridge run --robots 2 --world "
                                     "moved/share/eyebridge/worlds/rooms.wld ./prog\n",
                                 folder_.path());
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, ::testing::MatchesRegex("at [^\n]*\nat [^\n]*\n"));
}

#ifdef EYEBRIDGE_PYTHON
TEST_F(Package, PythonFindsBothPackagesOfAnInstallation) {
  const ProgramRun r =
      run_shell(installed() + "PYTHONPATH=moved/" EYEBRIDGE_PYTHON_DIR " " EYEBRIDGE_PYTHON
                              " -c 'import eye, eyebridge; print(eye._library.lib._name, "
                              "eyebridge.default_scenario().size)'\n",
                folder_.path());
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("/moved/" EYEBRIDGE_LIBDIR "/libeyebridge.so.0 "));
}

TEST_F(Package, ProgramsInPythonRunInAnInstallation) {
  const ProgramRun r =
      run_shell(installed() +
                    "cd moved/share/eyebridge\neyebridge=../../bin/eyebridge\n"
                    "$eyebridge run examples/wall_follow.py\n"
                    "$eyebridge run --robots 2 --world worlds/rooms.wld examples/wall_follow.py\n"
                    "$eyebridge run --no-gui --world worlds/rooms.wld --time-limit 5s "
                    "examples/control/explore.py\n"
                    "$eyebridge assess --worlds worlds/empty-room.wld --seeds 1 --time-limit 2s "
                    "--out $OLDPWD/results examples/control/survey.py\n",
                folder_.path());
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("stopped at ")) << r.err;
}
#endif

}  // namespace
}  // namespace eyebridge
