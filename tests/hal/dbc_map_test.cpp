// Mapping files: what is read, and what a mistake is told like.
#include "board/dbc_map.hpp"

#include <fstream>
#include <iterator>

#include <gmock/gmock.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/bridges/dbc/read_dbc.hpp"

namespace eyebridge::hal {
namespace {

using ::testing::HasSubstr;

std::string rover_file(const char* ending) {
  const std::string path = std::string(EYEBRIDGE_SOURCE_DIR "/examples/rover/rover.") + ending;
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

DbcRobot read(const std::string& map) {
  return read_dbc_map(map, "rover.toml", bridges::dbc::read_dbc(rover_file("dbc"), "rover.dbc"));
}

/// The rover's mapping file with `from` once replaced by `to`; what reading it throws.
std::string complaint(const std::string& from, const std::string& to) {
  std::string map = rover_file("toml");
  const std::size_t at = map.find(from);
  if (at == std::string::npos) return "no " + from;
  map.replace(at, from.size(), to);
  try {
    read(map);
    return "";
  } catch (const ConfigError& error) {
    return error.what();
  }
}

TEST(DbcMap, TheRoverIsRead) {
  const DbcRobot rover = read(rover_file("toml"));
  EXPECT_EQ(rover.plan.robot, "rover");
  ASSERT_EQ(rover.plan.commands.size(), 1u);
  const bridges::DbcCommand& command = rover.plan.commands[0];
  EXPECT_EQ(command.period, std::chrono::milliseconds(10));
  EXPECT_EQ(command.resting, (std::vector<std::uint8_t>{0, 0x10, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(command.counter->last, 14u);
  EXPECT_EQ(command.checksum->data_id, 0x2A51);
  EXPECT_EQ(rover.plan.heartbeat_limit, std::chrono::milliseconds(200));
  EXPECT_EQ(rover.plan.statuses.at(rover.plan.heartbeat).name, "RV_State");
  EXPECT_TRUE(rover.plan.has_watchdog);
  EXPECT_NEAR(rover.value_per_speed[0], 60 / (kPi * 0.054), 1e-9);
  EXPECT_NEAR(rover.value_per_speed[1], -60 / (kPi * 0.054), 1e-9);
  ASSERT_EQ(rover.encoders.size(), 2u);
  EXPECT_EQ(rover.encoders[0].bits, 24);
  EXPECT_EQ(rover.encoders[1].ticks_per_bit, -1);
  ASSERT_EQ(rover.ranges.size(), 4u);
  EXPECT_NEAR(rover.ranges[3].distance.scale, 0.001, 1e-12);
  EXPECT_EQ(rover.tables.drive.wheel_base, 0.09);
  EXPECT_EQ(rover.tables.motors.size(), 2u);
  EXPECT_TRUE(rover.tables.servos.empty());
  EXPECT_FALSE(rover.pose);
}

TEST(DbcMap, APoseMayBeGiven) {
  const DbcRobot rover =
      read(rover_file("toml") +
           "[pose]\nx = { signal = \"RV_Speed.Left\", unit = \"cm\" }\n"
           "y = { signal = \"RV_Speed.Right\", unit = \"mm\", scale = 2.0 }\n"
           "theta = { signal = \"RV_State.State\", unit = \"deg\", sign = -1 }\n");
  ASSERT_TRUE(rover.pose);
  EXPECT_NEAR(rover.pose->x.scale, 0.01, 1e-12);
  EXPECT_NEAR(rover.pose->y.scale, 0.002, 1e-12);
  EXPECT_NEAR(rover.pose->theta.scale, -kPi / 180, 1e-12);
}

TEST(DbcMap, WrongNamesHaveTheNearestOnesBesideThem) {
  EXPECT_EQ(complaint("\"RV_Drive.LeftSpeed\"", "\"RV_Drive.LeftSped\""),
            "rover.toml:14:19: found the signal 'LeftSped', expected one that RV_Drive has; "
            "nearest: 'LeftSpeed', 'RightSpeed', 'Counter'");
  EXPECT_THAT(complaint("\"RV_Encoders.Left\"", "\"RV_Encoder.Left\""),
              HasSubstr("found the message 'RV_Encoder', expected one that the DBC file has; "
                        "nearest: 'RV_Encoders'"));
  EXPECT_THAT(complaint("\"RV_Encoders.Left\"", "\"RV_Encoders\""),
              HasSubstr("found 'RV_Encoders', expected \"Message.Signal\""));
  EXPECT_THAT(complaint("wheel_base", "wheelbase"), HasSubstr("found no 'wheel_base' in [robot]"));
  EXPECT_THAT(complaint("max_turn", "max_trun"),
              HasSubstr("rover.toml:9:1: found 'max_trun' in [robot], expected another name; "
                        "nearest: 'max_turn'"));
  EXPECT_THAT(complaint("[stopped]", "[stoped]"), HasSubstr("found 'stoped' in the file"));
}

/// The same for a key that no table has, written behind `before`.
std::string complaint_about_key(const std::string& before, const std::string& written) {
  return complaint(before, before + written);
}

TEST(DbcMap, NoTableMayHaveAKeyThatIsNotItsOwn) {
  EXPECT_THAT(complaint_about_key("see docs/boards.md.\n", "colour = 1\n"),
              HasSubstr("found 'colour' in the file, expected another name"));
  for (const char* table : {"[robot]", "[wheels]", "[[command]]", "[[encoder]]", "[[range]]",
                            "[heartbeat]", "[stopped]"}) {
    EXPECT_THAT(complaint_about_key(table + std::string("\n"), "colour = 1\n"),
                HasSubstr(std::string("found 'colour' in ") + table + ", expected another name"));
  }
  EXPECT_THAT(
      complaint_about_key("unit = \"rpm\"", ", colour = 1"),
      HasSubstr("rover.toml:14:55: found 'colour' in [wheels] left, expected another name"));
  EXPECT_THAT(complaint_about_key("sign = -1", ", colour = 1"),
              HasSubstr("found 'colour' in [wheels] right"));
  EXPECT_THAT(complaint_about_key("last = 14", ", colour = 1"),
              HasSubstr("found 'colour' in 'counter'"));
  EXPECT_THAT(complaint_about_key("mode = \"both\"", ", colour = 1"),
              HasSubstr("found 'colour' in 'checksum'"));
}

TEST(DbcMap, NoQuantityOfAPoseMayHaveAKeyThatIsNotItsOwn) {
  const auto with_pose = [](const std::string& x, const std::string& more) {
    return complaint("[heartbeat]\n",
                     "[pose]\nx = { signal = \"RV_Speed.Left\", unit = \"cm\"" + x +
                         " }\ny = { signal = \"RV_Speed.Right\", unit = \"mm\" }\n"
                         "theta = { signal = \"RV_State.State\", unit = \"deg\" }\n" +
                         more + "[heartbeat]\n");
  };
  EXPECT_EQ(with_pose("", ""), "");
  EXPECT_THAT(with_pose(", colour = 1", ""), HasSubstr("found 'colour' in [pose] x"));
  EXPECT_THAT(with_pose("", "colour = 1\n"), HasSubstr("found 'colour' in [pose], expected"));
}

TEST(DbcMap, WrongUnitsAndNumbersAreRefused) {
  EXPECT_THAT(complaint("unit = \"rpm\"", "unit = \"rpn\""),
              HasSubstr("rover.toml:14:48: found the unit 'rpn', expected one of m/s, mm/s, km/h, "
                        "rad/s, deg/s, rpm, ticks/s, %"));
  EXPECT_THAT(complaint("wheel_diameter = 0.054", ""), HasSubstr("found the unit 'rpm'"));
  EXPECT_THAT(complaint("sign = -1", "sign = 0"), HasSubstr("found 0 for 'sign'"));
  EXPECT_THAT(complaint("sign = -1", "sign = 2"), HasSubstr("found 2 for 'sign'"));
  EXPECT_THAT(complaint("wheel_base = 0.09", "wheel_base = -1"),
              HasSubstr("found -1 for 'wheel_base' in [robot]"));
  EXPECT_THAT(complaint("wheel_base = 0.09", "wheel_base = nan"), HasSubstr("wheel_base"));
  EXPECT_THAT(complaint("wheel_base = 0.09", "wheel_base = \"x\""),
              HasSubstr("found a text for 'wheel_base' in [robot], expected a number"));
  EXPECT_THAT(complaint("max_wheel_speed = 1.6964", "max_wheel_speed = 100.0"),
              HasSubstr("expected what LeftSpeed can say: -3000 … 3000"));
  EXPECT_THAT(complaint("period = \"10ms\"", "period = \"10us\""), HasSubstr("expected 1 ms"));
  EXPECT_THAT(complaint("id = 2", "id = 1"), HasSubstr("found the id 1 a second time"));
}

TEST(DbcMap, CommandsMustFitTogether) {
  EXPECT_THAT(complaint("message = \"RV_Drive\"", "message = \"RV_Speed\""), HasSubstr("'Enable'"));
  EXPECT_THAT(complaint("kind = \"autosar-1\"", "kind = \"crc32\""),
              HasSubstr("found 'crc32' for 'kind', expected one of xor, sae-j1850, autosar-1"));
  EXPECT_THAT(complaint("signal = \"Crc\"", "signal = \"LeftSpeed\""),
              HasSubstr("expected 8 bits that are a byte of their own"));
  EXPECT_THAT(complaint("counter = { signal = \"Counter\", last = 14 }", ""),
              HasSubstr("found autosar-1 without a 'counter'"));
  EXPECT_THAT(complaint("last = 14", "last = 16"), HasSubstr("found 16 for 'last'"));
  EXPECT_THAT(complaint("{ Enable = 1 }", "{ Enable = 2 }"),
              HasSubstr("found a constant that cannot be: Enable cannot be 2"));
  EXPECT_THAT(complaint("mode = \"both\"", "mode = \"all\""), HasSubstr("found 'all' for 'mode'"));
  EXPECT_THAT(complaint("RV_Drive.RightSpeed", "RV_Drive.LeftSpeed"),
              HasSubstr("found one signal for both wheels"));
  EXPECT_THAT(complaint("RV_Drive.RightSpeed", "RV_Speed.Right"),
              HasSubstr("expected a [[command]] with this message"));
  EXPECT_THAT(complaint("RV_State.Moving", "RV_Ranges.Range1"),
              HasSubstr("which a multiplexer selects"));
  EXPECT_THAT(complaint("[heartbeat]\nmessage = \"RV_State\"", "[heartbeat]"),
              HasSubstr("found no 'message' in [heartbeat]"));
}

}  // namespace
}  // namespace eyebridge::hal
