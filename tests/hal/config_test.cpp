#include "eyebridge/hal/config.hpp"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/base/text.hpp"
#include "eyebridge/hal/world_file.hpp"

namespace eyebridge::hal {
namespace {

using testing::HasSubstr;

/// A folder of its own for each test, gone afterwards.
class ConfigTest : public testing::Test {
 protected:
  ConfigTest() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) / (std::string("config_") + info->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~ConfigTest() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& name, const std::string& text) {
    auto path = folder_ / name;
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }

  /// What load() says of `text` in an eyebridge.toml; "" when it takes it.
  std::string complaint(const std::string& text) {
    return complaint(Config::Sources{{}, {}, {write("eyebridge.toml", text)}});
  }
  static std::string complaint(const Config::Sources& sources) {
    try {
      Config::load(sources);
      return "";
    } catch (const ConfigError& error) {
      return error.what();
    }
  }

  std::filesystem::path folder_;
};

TEST_F(ConfigTest, HoldsTheFallbacksWhenNobodySaysAnything) {
  const Config config = Config::load({});
  EXPECT_EQ(config.text("hal"), "sim");
  EXPECT_FALSE(config.boolean("fast"));
  EXPECT_EQ(config.integer("seed"), 1);
  EXPECT_DOUBLE_EQ(config.number("step"), 0.01);
  EXPECT_FALSE(config.is_set("world"));
  EXPECT_EQ(config.value("hal").where.str(), "default");
}

TEST_F(ConfigTest, PrefersFlagsToVariablesToFilesToDefaults) {
  const auto near = write("near.toml", "seed = 2\nfactor = 2\nrobot = 'near'\nlcd = '320x240'\n");
  const auto far = write("far.toml", "seed = 1\nfactor = 1\nrobot = 'far'\nkeys = 'far'\n");
  const Config config = Config::load(
      {{{"seed", "4"}}, {{"EYEBRIDGE_SEED", "3"}, {"EYEBRIDGE_FACTOR", "3"}}, {near, far}});
  EXPECT_EQ(config.integer("seed"), 4);
  EXPECT_DOUBLE_EQ(config.number("factor"), 3.0);
  EXPECT_EQ(config.text("robot"), "near");
  EXPECT_EQ(config.text("keys"), "far");
  EXPECT_EQ(config.text("camera"), "render");
}

TEST_F(ConfigTest, SaysWhereEachValueCameFrom) {
  const auto file = write("eyebridge.toml", "# mine\nfast = true\n");
  const Config config =
      Config::load({{{"time_limit", "2 min"}}, {{"EYEBRIDGE_WORLD", "a.maz"}}, {file}});
  EXPECT_EQ(config.value("time_limit").where.str(), "--time-limit");
  EXPECT_EQ(config.value("world").where.str(), "EYEBRIDGE_WORLD");
  EXPECT_EQ(config.value("fast").where.str(), file.string() + ":2:8");
}

TEST_F(ConfigTest, APlanBringsEveryValueAndItsPlaceToTheProgramThatWouldReadTheSame) {
  const auto file = write("eyebridge.toml", "# mine\nrobot = \"a\\tb\\\\n\"\nfactor = 2\n");
  const std::map<std::string, std::string> variables = {
      {"EYEBRIDGE_SEED", "3"}, {"EYEBRIDGE_FACTOR", "3"}, {"EYEBRIDGE_WORLD", "two\nlines.maz"}};
  const Config made =
      Config::load({{{"seed", "9"}, {"keys", "KEY1@2s,KEY2=x"}}, variables, {file}});
  auto handed_on = variables;
  handed_on["EYEBRIDGE_PLAN"] = made.plan();
  write("eyebridge.toml", "not read again");
  const Config read = Config::load({{}, handed_on, {file}});
  EXPECT_EQ(read.describe(), made.describe());
  EXPECT_EQ(read.text("robot"), "a\tb\\n");
  EXPECT_EQ(read.value("robot").where, (SourceLocation{file.string(), 2, 9}));
  EXPECT_EQ(read.text("world"), "two\nlines.maz");
  EXPECT_EQ(read.text("keys"), "KEY1@2s,KEY2=x");
  EXPECT_EQ(read.value("seed").where.str(), "--seed");
  EXPECT_TRUE(read.value("camera").is_default());
}

TEST_F(ConfigTest, OfAPlanForOtherVariablesFilesOrProcessesOnlyTheFlagsCount) {
  const auto file = write("eyebridge.toml", "robot = 'made'\n");
  const auto other = write("other.toml", "robot = 'found'\n");
  const std::string plan =
      Config::load({{{"seed", "9"}}, {{"EYEBRIDGE_STEP", "1ms"}}, {file}}).plan();
  const Config set = Config::load(
      {{}, {{"EYEBRIDGE_PLAN", plan}, {"EYEBRIDGE_STEP", "2ms"}, {"EYEBRIDGE_SEED", "3"}}, {file}});
  EXPECT_EQ(set.text("step"), "2ms");
  EXPECT_EQ(set.integer("seed"), 9);
  EXPECT_EQ(set.value("seed").where.str(), "--seed");
  const Config unset = Config::load({{}, {{"EYEBRIDGE_PLAN", plan}}, {file}});
  EXPECT_EQ(unset.text("step"), "10ms");
  const Config elsewhere =
      Config::load({{}, {{"EYEBRIDGE_PLAN", plan}, {"EYEBRIDGE_STEP", "1ms"}}, {other}});
  EXPECT_EQ(elsewhere.text("robot"), "found");
  EXPECT_EQ(elsewhere.integer("seed"), 9);
  write("eyebridge.toml", "robot = 'written since'\n");
  const Config of_child =
      Config::load({{}, {{"EYEBRIDGE_PLAN", plan}, {"EYEBRIDGE_STEP", "1ms"}}, {file}, 7});
  EXPECT_EQ(of_child.text("robot"), "written since");
  EXPECT_EQ(of_child.integer("seed"), 9);
}

TEST_F(ConfigTest, ASealedPlanCountsWhateverIsFound) {
  const auto file = write("eyebridge.toml", "robot = 'found'\n");
  const std::string plan = Config::load({{{"seed", "9"}}, {}, {}}).sealed_plan();
  const Config config =
      Config::load({{}, {{"EYEBRIDGE_PLAN", plan}, {"EYEBRIDGE_STEP", "2ms"}}, {file}});
  EXPECT_EQ(config.integer("seed"), 9);
  EXPECT_EQ(config.text("robot"), "S4");
  EXPECT_EQ(config.text("step"), "10ms");
}

TEST_F(ConfigTest, RefusesAFlagOfTwoLines) {
  EXPECT_EQ(complaint({{{"keys", "KEY1\nseed=2"}}, {}, {}}),
            "--keys: found a line end in the value, expected one line");
}

TEST_F(ConfigTest, NamesTheLineOfABadPlan) {
  EXPECT_EQ(complaint({{}, {{"EYEBRIDGE_PLAN", "any\nseed=1\t--seed\t0\t0\nfast\n"}}, {}}),
            "EYEBRIDGE_PLAN:3: found 'fast', expected key=value, file, line and column");
  EXPECT_EQ(complaint({{}, {{"EYEBRIDGE_PLAN", "any\nsede=1\t--sede\t0\t0\n"}}, {}}),
            "EYEBRIDGE_PLAN:2: unknown setting 'sede', the nearest setting is 'seed'");
}

TEST_F(ConfigTest, TakesRelativePathsFromWhereTheyWereWritten) {
  const auto file = write("eyebridge.toml", "world = 'mazes/a.maz'\nout = '/tmp/out'\n");
  const Config from_file = Config::load({{}, {}, {file}});
  EXPECT_EQ(from_file.path("world"), folder_ / "mazes/a.maz");
  EXPECT_EQ(from_file.path("out"), "/tmp/out");
  const Config from_flag = Config::load({{{"world", "mazes/a.maz"}}, {}, {file}});
  EXPECT_EQ(from_flag.path("world"), "mazes/a.maz");
}

TEST_F(ConfigTest, AWorldByNameIsLookedForBesideItsFileAndItsProgram) {
  const auto file = write("eyebridge.toml", "world = 'a.maz'\n");
  std::filesystem::create_directories(folder_ / "bin/worlds");
  const std::filesystem::path program = folder_ / "bin/prog";
  const Config config = Config::load({{}, {}, {file}});
  const std::string as_written = config.text("world");
  EXPECT_EQ(world_file(config.value("world"), program), as_written);
  write("bin/worlds/a.maz", "");
  EXPECT_EQ(world_file(config.value("world"), {}), as_written);
  try {
    (void)find_world(config.value("world"), {});
    ADD_FAILURE() << "found it";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr(file.string() + ":1:9: no file 'a.maz': expected "));
    EXPECT_THAT(error.what(), HasSubstr("; looked in the working folder, " + folder_.string()));
  }
  EXPECT_EQ(world_file(config.value("world"), program), folder_ / "bin/worlds/a.maz");
  EXPECT_EQ(world_file({"a.maz", {"--world"}}, program), folder_ / "bin/worlds/a.maz");
  write("a.maz", "");
  EXPECT_EQ(world_file(config.value("world"), program), folder_ / "a.maz");
}

TEST_F(ConfigTest, NamesTheNearestKeyOfAnUnknownOneWithLineAndColumn) {
  EXPECT_THAT(complaint("seed = 1\n  wrold = 'a'\n"),
              HasSubstr("eyebridge.toml:2:3: unknown key 'wrold', the nearest setting is 'world'"));
}

TEST_F(ConfigTest, KnowsNoTableButMix) {
  EXPECT_THAT(complaint("seed = 1\n[max]\ndrive = 'sim'\n"),
              HasSubstr(":2:2: unknown table 'max', the nearest setting is 'mix'"));
  EXPECT_THAT(complaint("[seed]\na = 'sim'\n"), HasSubstr("found a table for 'seed'"));
}

TEST_F(ConfigTest, TakesAMixAsATableOrAsText) {
  const auto table = write("table.toml", "[mix]\npsd = 'sim'\ndrive = 'serial:/dev/a~b?c=d'\n");
  EXPECT_EQ(Config::load({{}, {}, {table}}).text("mix"), "drive=serial:/dev/a~b?c=d; psd=sim");
  const auto text = write("text.toml", "mix = 'psd=sim'\n");
  EXPECT_EQ(Config::load({{}, {}, {text}}).text("mix"), "psd=sim");
}

TEST_F(ConfigTest, SaysWhereAMixIsWrong) {
  EXPECT_THAT(complaint("[mix]\npsd = 'sim'\nwings = 'sim'\n"),
              HasSubstr(":3:1: found 'wings' as a device, expected one of drive, motor, encoder"));
  EXPECT_THAT(complaint("[mix]\npsd = 1\n"),
              HasSubstr(":2:7: found a whole number for 'mix.psd', expected a text"));
  EXPECT_THAT(complaint("[mix]\npsd = 'sim; drive=sim'\n"), HasSubstr(":2:7: found a ';'"));
  EXPECT_THAT(complaint("[mix]\npsd = ''\n"), HasSubstr(":2:1: found no backend for 'psd'"));
  EXPECT_THAT(complaint("[mix.psd]\na = 'sim'\n"), HasSubstr("found a table for 'mix.psd'"));
}

TEST_F(ConfigTest, NamesTheNearestVariableOfAnUnknownOne) {
  EXPECT_EQ(complaint({{}, {{"EYEBRIDGE_SEDE", "1"}}, {}}),
            "EYEBRIDGE_SEDE: unknown variable, the nearest one is EYEBRIDGE_SEED");
  EXPECT_EQ(complaint({{}, {{"EYEBRIDGE_Seed", "1"}}, {}}),
            "EYEBRIDGE_Seed: unknown variable, the nearest one is EYEBRIDGE_SEED");
}

TEST_F(ConfigTest, LeavesTheOtherVariablesAlone) {
  EXPECT_EQ(
      complaint(
          {{}, {{"EYEBRIDGE_DATA", "x"}, {"EYEBRIDGE_TEST_CAN", "vcan0"}, {"SEED", "x"}}, {}}),
      "");
}

TEST_F(ConfigTest, NamesTheNearestSettingOfAnUnknownFlag) {
  EXPECT_EQ(complaint({{{"time_limt", "1"}}, {}, {}}),
            "--time-limt: unknown setting 'time_limt', the nearest setting is 'time_limit'");
}

TEST_F(ConfigTest, RefusesTomlValuesOfTheWrongKind) {
  EXPECT_THAT(complaint("seed = 'one'"),
              HasSubstr(":1:8: found a text for 'seed', expected a whole number"));
  EXPECT_THAT(complaint("fast = 1"), HasSubstr("found a whole number for 'fast', expected true"));
  EXPECT_THAT(complaint("seed = 1.5"), HasSubstr("found a number for 'seed'"));
  EXPECT_THAT(complaint("world = [1]"), HasSubstr("found a list for 'world'"));
  EXPECT_THAT(complaint("step = 2020-01-01"), HasSubstr("found a date or time for 'step'"));
  EXPECT_THAT(complaint("factor = inf"), HasSubstr("expected a number"));
  EXPECT_THAT(complaint("step = 'soon'"), HasSubstr("expected a duration such as"));
}

TEST_F(ConfigTest, TakesNumbersOfRobotsAndYearsInTomlWithAndWithoutQuotes) {
  const auto text_of = [&](const std::string& toml, const char* key) {
    return Config::load({{}, {}, {write("eyebridge.toml", toml)}}).text(key);
  };
  EXPECT_EQ(text_of("robots = 2", "robots"), "2");
  EXPECT_EQ(text_of("robots = '2'", "robots"), "2");
  EXPECT_EQ(text_of("robots = 'all'", "robots"), "all");
  EXPECT_EQ(text_of("psd_numbers = 2015", "psd_numbers"), "2015");
}

TEST_F(ConfigTest, RefusesTextsOfTheWrongKind) {
  EXPECT_EQ(complaint({{{"seed", "1x"}}, {}, {}}), "--seed: found '1x', expected a whole number");
  EXPECT_EQ(complaint({{{"fast", "maybe"}}, {}, {}}),
            "--fast: found 'maybe', expected true or false");
  EXPECT_EQ(complaint({{{"factor", "nan"}}, {}, {}}), "--factor: found 'nan', expected a number");
  EXPECT_THAT(complaint({{{"hal", ""}}, {}, {}}), HasSubstr("--hal: found nothing for 'hal'"));
}

TEST_F(ConfigTest, RefusesValuesOutsideTheirRange) {
  EXPECT_EQ(complaint({{{"factor", "0"}}, {}, {}}),
            "--factor: found '0' for 'factor', expected 0.001 … 1000000");
  EXPECT_THAT(complaint("step = '2s'"), HasSubstr("found '2s' for 'step', expected 0.0001 … 1 s"));
  EXPECT_THAT(complaint("seed = -1"), HasSubstr("expected at least 0"));
}

TEST_F(ConfigTest, ReadsTheSizeOfAScreen) {
  EXPECT_EQ(Config::load({{{"lcd", "320x240"}}, {}, {}}).size("lcd"), (PixelSize{320, 240}));
  EXPECT_EQ(Config::load({{{"lcd", " 320x240 "}}, {}, {}}).size("lcd"), (PixelSize{320, 240}));
  EXPECT_EQ(Config::load({}).size("lcd"), (PixelSize{560, 400}));
}

TEST_F(ConfigTest, RefusesWhatIsNoSizeOfAScreen) {
  for (const char* bad : {"560", "560x", "x400", "560x400x", "560 x 400", "560,400", "axb"}) {
    EXPECT_THAT(complaint({{{"lcd", bad}}, {}, {}}),
                HasSubstr("', expected WIDTHxHEIGHT in pixels, such as 560x400"))
        << bad;
  }
  EXPECT_THAT(complaint("\nlcd = '560x4'"),
              HasSubstr("eyebridge.toml:2:7: found '560x4' for 'lcd', "
                        "expected 160 … 4096 pixels each way"));
  EXPECT_THAT(complaint("lcd = '9999x400'"), HasSubstr("expected 160 … 4096 pixels each way"));
  EXPECT_THAT(complaint("lcd = 560"), HasSubstr("expected a text such as \"560x400\""));
}

TEST_F(ConfigTest, RefusesATextThatIsNoChoice) {
  EXPECT_EQ(complaint({{{"log", "loud"}}, {}, {}}),
            "--log: found 'loud' for 'log', expected one of debug|info|warning|error");
  EXPECT_EQ(complaint({{{"log", "info"}}, {}, {}}), "");
}

TEST_F(ConfigTest, ChecksASourceEvenWhereAnotherOneWins) {
  EXPECT_EQ(complaint({{{"seed", "1"}}, {{"EYEBRIDGE_SEED", "x"}}, {}}),
            "EYEBRIDGE_SEED: found 'x', expected a whole number");
}

TEST_F(ConfigTest, GivesThePlaceOfATomlSyntaxError) {
  EXPECT_THAT(complaint("seed = 1\nfast = tru\n"), HasSubstr("eyebridge.toml:2:"));
  EXPECT_THAT(complaint("seed = 1\nseed = 2\n"), HasSubstr("eyebridge.toml:2:"));
  EXPECT_NE(complaint(std::string("\x00\xFF\x7F", 3)), "");
}

TEST_F(ConfigTest, TakesCharactersBeyondAsciiInQuotesAndComments) {
  const auto file =
      write("eyebridge.toml", "\xEF\xBB\xBF# größe\nrobot = \"Mö\\\"ü\"  # ü\nkeys = 'ß'\n");
  const Config config = Config::load({{}, {}, {file}});
  EXPECT_EQ(config.text("robot"), "Mö\"ü");
  EXPECT_EQ(config.text("keys"), "ß");
}

TEST_F(ConfigTest, RefusesCharactersBeyondAsciiElsewhere) {
  EXPECT_THAT(complaint("seed = 1\nkeys = 'ü'ü\n"), HasSubstr("eyebridge.toml:2:11: "));
  EXPECT_THAT(complaint("wörld = 'a'\n"), HasSubstr("eyebridge.toml:1:2: "));
  EXPECT_NE(complaint("seed = 1ü\n"), "");
  EXPECT_NE(complaint("seed =999'\xEF\xBB\xBB\n"), "");
  EXPECT_THAT(complaint("'wörld' = 'a'\n"), HasSubstr("unknown key 'wörld'"));
}

TEST_F(ConfigTest, KeepsATilde) {
  const auto file = write("eyebridge.toml", "keys = '~41~'\nrobot = '~'\n");
  const Config config = Config::load({{}, {}, {file}});
  EXPECT_EQ(config.text("keys"), "~41~");
  EXPECT_EQ(config.text("robot"), "~");
  EXPECT_THAT(complaint("seed = 1\nkeys = \"\\u007E41\"\n"),
              HasSubstr(":2: found \\u007E, expected ~ as it is"));
}

TEST_F(ConfigTest, SkipsMissingFilesButNotUnreadableOnes) {
  EXPECT_EQ(complaint({{}, {}, {folder_ / "missing.toml"}}), "");
  EXPECT_EQ(complaint({{}, {}, {folder_}}),
            folder_.string() + ": is not a file: expected a TOML file");
  EXPECT_THAT(complaint(std::string((1U << 20U) + 1, '\n')),
              HasSubstr("has 1048577 bytes, expected at most 1048576: expected a TOML file"));
}

TEST_F(ConfigTest, UnsetsWithAnEmptyValueWhatMayBeUnset) {
  const Config config = Config::load({{{"time_limit", ""}}, {{"EYEBRIDGE_TIME_LIMIT", "3s"}}, {}});
  EXPECT_FALSE(config.is_set("time_limit"));
}

TEST_F(ConfigTest, DescribesEverySettingWithItsOrigin) {
  const std::string text = Config::load({{{"seed", "7"}}, {}, {}}).describe();
  for (const Setting& setting : settings()) {
    EXPECT_THAT(text, HasSubstr(std::string(setting.key) + ' ')) << setting.key;
  }
  EXPECT_THAT(text, testing::ContainsRegex("seed +=  *7 +# --seed\n"));
  EXPECT_THAT(text, testing::ContainsRegex("hal +=  *sim +# default\n"));
}

TEST(Duration, ReadsEveryUnit) {
  EXPECT_DOUBLE_EQ(parse_duration("2s", {}), 2.0);
  EXPECT_DOUBLE_EQ(parse_duration("250ms", {}), 0.25);
  EXPECT_DOUBLE_EQ(parse_duration("1.5 min", {}), 90.0);
  EXPECT_DOUBLE_EQ(parse_duration("10 us", {}), 1e-5);
  EXPECT_DOUBLE_EQ(parse_duration(" 2h ", {}), 7200.0);
  EXPECT_DOUBLE_EQ(parse_duration("0.5", {}), 0.5);
}

TEST(Duration, RefusesWhatIsNone) {
  for (const char* text : {"", "s", "2 days", "-1s", "1e300s", "nan", "2s2", "1 0s", "0x10"}) {
    EXPECT_THROW(parse_duration(text, {"--step"}), ConfigError) << text;
  }
  try {
    parse_duration("2 days", {"--step"});
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("--step: found '2 days', expected a duration"));
  }
}

TEST(Settings, HaveKeysThatAreSpelledInOneWay) {
  EXPECT_EQ(Config::flag_name("time_limit"), "--time-limit");
  EXPECT_EQ(Config::variable_name("time_limit"), "EYEBRIDGE_TIME_LIMIT");
  EXPECT_EQ(nearest_key("tmie-limit"), "time_limit");
  for (const Setting& setting : settings()) EXPECT_EQ(find_setting(setting.key), &setting);
  EXPECT_EQ(find_setting("nothing"), nullptr);
}

}  // namespace
}  // namespace eyebridge::hal
