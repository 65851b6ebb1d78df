#include <string>

#include <gtest/gtest.h>

#include "eyebridge/base/config_error.hpp"
#include "key_script.hpp"

namespace eyebridge::robios {
namespace {

using std::chrono::milliseconds;
using std::chrono::minutes;
using std::chrono::seconds;

std::string error_of(std::string_view script) {
  try {
    parse_key_script(script);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

TEST(KeyScript, NamesKeysAndTimes) {
  const auto script = parse_key_script("KEY1@2s, KEY2@250ms,KEY3@1min ,KEY4@10");
  ASSERT_EQ(script.size(), 4u);
  EXPECT_EQ(script[0], (ScriptedKey{milliseconds(250), 2, {}}));
  EXPECT_EQ(script[1], (ScriptedKey{seconds(2), 1, {}}));
  EXPECT_EQ(script[2], (ScriptedKey{seconds(10), 8, {}}));
  EXPECT_EQ(script[3], (ScriptedKey{minutes(1), 4, {}}));
}

TEST(KeyScript, NamesTouches) {
  const auto script = parse_key_script("120:80@1.5s");
  ASSERT_EQ(script.size(), 1u);
  EXPECT_EQ(script[0], (ScriptedKey{milliseconds(1500), 0, {120, 80}}));
}

TEST(KeyScript, NamesKeysOfTheRemoteControl) {
  const auto script = parse_key_script("IRTV_7@1s,IRTV_RIGHT@2s,IRTV_RED@3s,IRTV_POWER@4s");
  ASSERT_EQ(script.size(), 4u);
  EXPECT_EQ(script[0], (ScriptedKey{seconds(1), 0, {}, '7'}));
  EXPECT_EQ(script[1], (ScriptedKey{seconds(2), 0, {}, '>'}));
  EXPECT_EQ(script[2], (ScriptedKey{seconds(3), 0, {}, 'R'}));
  EXPECT_EQ(script[3], (ScriptedKey{seconds(4), 0, {}, 'P'}));
  EXPECT_EQ(error_of("IRTV_MUTE@1s").substr(0, 48),
            "--keys:1:6: found 'MUTE@1s', expected a key of t");
  EXPECT_NE(error_of("IRTV_12@1s"), "no error");
}

TEST(KeyScript, KeepsTheOrderOfKeysAtTheSameTime) {
  const auto script = parse_key_script("KEY3@1s,KEY1@1s");
  EXPECT_EQ(script.at(0).key, 4);
  EXPECT_EQ(script.at(1).key, 1);
}

TEST(KeyScript, MayBeEmpty) {
  EXPECT_TRUE(parse_key_script("").empty());
  EXPECT_TRUE(parse_key_script("  ").empty());
}

TEST(KeyScript, NamesTheRobotThatIsMeant) {
  const auto script = parse_key_script("2:KEY1@1s,12:IRTV_5@2s,3:120:80@3s,KEY2@4s");
  ASSERT_EQ(script.size(), 4u);
  EXPECT_EQ(script[0].robot, 2);
  EXPECT_EQ(script[0].key, 1);
  EXPECT_EQ(script[1].robot, 12);
  EXPECT_EQ(script[1].remote, '5');
  EXPECT_EQ(script[2].robot, 3);
  EXPECT_EQ(script[2].touch, (TouchPoint{120, 80}));
  EXPECT_EQ(script[3].robot, 0);
  EXPECT_EQ(error_of("0:KEY1@1s"),
            "--keys:1:1: found '0:KEY1@1s', expected the number of a robot, from 1");
  EXPECT_EQ(error_of("2:key1@1s"),
            "--keys:1:3: found 'key1@1s', expected the y of a touch, in pixels, or a key of this "
            "robot");
}

TEST(KeyScript, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(error_of("KEY5@2s"), "--keys:1:4: found '5@2s', expected a key number 1..4");
  EXPECT_EQ(error_of("KEY1@2s,kex"),
            "--keys:1:9: found 'kex', expected KEY1..KEY4, IRTV_5 or a touch like 120:80");
  EXPECT_EQ(error_of("KEY1"), "--keys:1:5: found nothing, expected '@' and a time");
  EXPECT_EQ(error_of("KEY1@"), "--keys:1:6: found nothing, expected a time like 2s, 250ms or 1min");
  EXPECT_EQ(error_of("KEY1@-2s"), "--keys:1:6: found '-2s', expected a time from 0 s to 1e9 s");
  EXPECT_EQ(error_of("KEY1@2h"), "--keys:1:7: found 'h', expected ',' or the end");
  EXPECT_EQ(error_of("KEY1@2s,"), "--keys:1:9: found nothing, expected another key after ','");
  EXPECT_EQ(error_of("12@2s"), "--keys:1:3: found '@2s', expected ':' and the y of a touch");
}

TEST(KeyScript, RefusesTimesThatAreNone) {
  for (const char* script : {"KEY1@nan", "KEY1@inf", "KEY1@1e300", "KEY1@1e400s", "KEY1@1e9min"}) {
    EXPECT_NE(error_of(script), "no error") << script;
  }
}

TEST(KeyScript, RefusesNumbersThatDoNotFit) {
  EXPECT_NE(error_of("99999999999:1@1s"), "no error");
  EXPECT_NE(error_of("KEY99999999999@1s"), "no error");
  EXPECT_LT(error_of(std::string(100000, 'x')).size(), 200u);
}

}  // namespace
}  // namespace eyebridge::robios
