#include "eyebridge/hal/config.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "command.hpp"

namespace eyebridge {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using testing::ProgramRun;
using testing::run_command;
using testing::ScratchFolder;

TEST(Config, ShowsEverySettingAndWhereItsValueCameFrom) {
  const ScratchFolder folder;
  folder.write("eyebridge.toml", "factor = 3\n");
  const ProgramRun r =
      run_command({"config", "--seed", "42"}, folder.path(), {{"EYEBRIDGE_ROBOT", "LabBot"}});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, ContainsRegex("seed += 42 +# --seed"));
  EXPECT_THAT(r.out, ContainsRegex("robot += LabBot +# EYEBRIDGE_ROBOT"));
  EXPECT_THAT(r.out, ContainsRegex("factor += 3 +# eyebridge.toml:1"));
  EXPECT_THAT(r.out, ContainsRegex("hal += sim +# default"));
  for (const hal::Setting& setting : hal::settings()) {
    EXPECT_THAT(r.out, HasSubstr(std::string(setting.key) + " ")) << setting.key;
  }
}

TEST(Config, TheFileBesideAProgramCounts) {
  const ScratchFolder folder;
  const ScratchFolder beside;
  beside.write("eyebridge.toml", "seed = 9\n");
  const ProgramRun r = run_command({"config", beside.path() + "/prog"}, folder.path());
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, ContainsRegex("seed += 9 +# .*eyebridge.toml:1"));
}

TEST(Config, ABadValueIsNamedWithItsPlace) {
  const ScratchFolder folder;
  folder.write("eyebridge.toml", "\nseed = \"many\"\n");
  const ProgramRun r = run_command({"config"}, folder.path());
  EXPECT_EQ(r.exit_code, 2);
  EXPECT_THAT(r.err, HasSubstr("eyebridge.toml:2:"));
}

TEST(Command, HelpOfRunListsAFlagForEverySetting) {
  const ProgramRun r = run_command({"run", "--help"}, ".");
  EXPECT_EQ(r.exit_code, 0);
  EXPECT_THAT(r.out, HasSubstr("PROGRAM [ARGUMENTS]"));
  EXPECT_THAT(r.out, HasSubstr("--sim"));
  for (const hal::Setting& setting : hal::settings()) {
    EXPECT_THAT(r.out, HasSubstr(hal::Config::flag_name(setting.key)));
    EXPECT_THAT(r.out, HasSubstr(std::string(setting.help).substr(0, 15)));
  }
}

TEST(Command, NoSubcommandOrAnUnknownOneIsBadInput) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{},
                                                    {"fly"},
                                                    {"world"},
                                                    {"world", "check"},
                                                    {"config", "--wrold=1"}}) {
    const ProgramRun r = run_command(arguments, ".");
    EXPECT_EQ(r.exit_code, 2);
    EXPECT_THAT(r.err, HasSubstr("eyebridge --help"));
    EXPECT_EQ(r.out, "");
  }
}

TEST(Doctor, NamesWhatThereIsAndWhatIsMissing) {
  const ProgramRun r = run_command({"doctor"}, ".");
  EXPECT_THAT(r.out, ContainsRegex("gcc +ok +/"));
  EXPECT_THAT(r.out,
              ContainsRegex("libeyebridge +ok +" EYEBRIDGE_BUILD_DIR "/lib/libeyebridge.so"));
  EXPECT_THAT(r.out, ContainsRegex("sim +a simulated robot"));
  for (const char* row : {"g++", "python3", "eyebot.h", "worlds", "windows", "import eyebridge",
                          "MPI", "renderer", "lab", "sanitizers", "PTY", "CAN", "V4L2 cameras"}) {
    EXPECT_THAT(r.out, ContainsRegex(std::string("\n") + (row == std::string("g++") ? "g.." : row) +
                                     " +(ok|none) "));
  }
}

TEST(Doctor, FailsWithoutACompilerAndNamesItsPackage) {
  const ProgramRun r = run_command({"doctor"}, ".", {{"PATH", "/nonexistent"}});
  EXPECT_EQ(r.exit_code, 1);
  EXPECT_THAT(r.out, ContainsRegex("gcc +MISSING"));
  EXPECT_THAT(r.out, HasSubstr("apt install build-essential"));
}

TEST(ConfigurationDocument, NamesEverySettingWithItsDefaultAndMeaning) {
  const std::string text = testing::file_text(EYEBRIDGE_SOURCE_DIR "/docs/configuration.md");
  std::size_t rows = 0;
  for (const hal::Setting& setting : hal::settings()) {
    const std::string fallback =
        setting.fallback.empty() ? "" : std::string("`").append(setting.fallback) + "`";
    const std::string row = std::string("| `").append(setting.key) + "` | " + fallback + " | " +
                            std::string(setting.help) + " |\n";
    EXPECT_THAT(text, HasSubstr(row));
    ++rows;
  }
  std::size_t written = 0;
  for (std::size_t at = text.find("\n| `"); at != std::string::npos;
       at = text.find("\n| `", at + 1)) {
    ++written;
  }
  EXPECT_EQ(written, rows) << "docs/configuration.md lists a setting that does not exist";
}

}  // namespace
}  // namespace eyebridge
