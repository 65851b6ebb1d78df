#include "eyebridge/files/hdt.hpp"

#include <gmock/gmock.h>

#include "reading.hpp"

namespace eyebridge::files {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// `count` values from 0 up, `step` apart, in a table of `name`.
std::string table(const std::string& name, int count, int step = 1) {
  std::string out = "TABLE " + name + "\n";
  for (int i = 0; i < count; ++i) out += std::to_string(i * step) + (i % 10 == 9 ? "\n" : " ");
  return out + "\nEND TABLE\n";
}

Hdt hdt_of(const std::string& text) {
  std::vector<Warning> warnings;
  Hdt hdt = read_hdt(text, "hdt.txt", warnings);
  EXPECT_TRUE(warnings.empty()) << warnings.front().str();
  return hdt;
}

std::string hdt_error(const std::string& text) {
  return error_of([&] {
    std::vector<Warning> warnings;
    read_hdt(text, "hdt.txt", warnings);
  });
}

const std::string kNumbered = R"(# our own robot
EYEBOT Little Rover
SSID workshop 1 pa,ss
ROBIOS 1
LCD 1
IRTV 0
USB 1 Board
USB 2 GPS
MOTOR 2 lin
MOTOR 1
SERVO 3 700 2300 swap   # a camera
SERVO 14 1000, 2000
ENCODER 1 10000
ENCODER 2 9950.5
PSD 6 near
DRIVE 95 150 0 1
IRTV "remote" 0 15 8 ff 1 4 20
DEMOPATH /home/pi/demo,s
SOFTWAREPATH /home/pi/usr
)" + table("lin", 101) + table("swap", 256) +
                              table("near", 5, 100);

TEST(HdtNumbered, DevicesHaveTheirNumbersAndUnits) {
  const Hdt hdt = hdt_of(kNumbered);
  EXPECT_EQ(hdt.dialect, HdtDialect::Numbered);
  ASSERT_EQ(hdt.motors.size(), 2u);
  EXPECT_EQ(hdt.motors[0].id, 1);
  EXPECT_EQ(hdt.table_of(hdt.motors[0]), nullptr);
  EXPECT_EQ(hdt.motors[1].id, 2);
  ASSERT_NE(hdt.table_of(hdt.motors[1]), nullptr);
  EXPECT_EQ(hdt.table_of(hdt.motors[1])->values.size(), 101u);
  EXPECT_EQ(hdt.motors[1].where, (SourceLocation{"hdt.txt", 9, 1}));
  ASSERT_EQ(hdt.servos.size(), 2u);
  EXPECT_DOUBLE_EQ(hdt.servos[0].shortest_pulse, 700e-6);
  EXPECT_DOUBLE_EQ(hdt.servos[0].longest_pulse, 2300e-6);
  EXPECT_EQ(hdt.table_of(hdt.servos[0])->name, "swap");
  EXPECT_EQ(hdt.servos[1].id, 14);
  EXPECT_FALSE(hdt.servos[1].table);
  ASSERT_EQ(hdt.encoders.size(), 2u);
  EXPECT_DOUBLE_EQ(hdt.encoders[1].ticks_per_metre, 9950.5);
  EXPECT_EQ(hdt.encoders[1].motor, 2);
  ASSERT_EQ(hdt.psds.size(), 1u);
  EXPECT_EQ(hdt.psds[0].id, 6);
  EXPECT_THAT(hdt.table_of(hdt.psds[0])->values, ElementsAre(0, 100, 200, 300, 400));
}

TEST(HdtNumbered, DriveIsInMetresAndItsSpeedWasInCentimetres) {
  const Hdt hdt = hdt_of(kNumbered);
  ASSERT_TRUE(hdt.drive);
  EXPECT_EQ(hdt.drive->kind, robot::DriveKind::Differential);
  EXPECT_DOUBLE_EQ(hdt.drive->wheel_base, 0.095);
  EXPECT_DOUBLE_EQ(hdt.drive->max_speed, 1.5);
  EXPECT_FALSE(hdt.drive->left_clockwise);
  EXPECT_TRUE(hdt.drive->right_clockwise);
  EXPECT_THAT(hdt.drive->encoders, ElementsAre(1, 2));
}

TEST(HdtNumbered, TheComputersLinesAreRead) {
  const Hdt hdt = hdt_of(kNumbered);
  EXPECT_EQ(hdt.name, "Little Rover");
  EXPECT_EQ(hdt.network, "workshop");
  EXPECT_TRUE(hdt.joins_network);
  EXPECT_EQ(hdt.starts_at_boot, true);
  EXPECT_EQ(hdt.lcd_orientation, 1);
  EXPECT_EQ(hdt.remote_enabled, false);
  EXPECT_EQ(hdt.demo_path, "/home/pi/demo,s");
  EXPECT_EQ(hdt.software_path, "/home/pi/usr");
  ASSERT_EQ(hdt.serials.size(), 2u);
  EXPECT_EQ(hdt.serials[1].id, 2);
  EXPECT_EQ(hdt.serials[1].name, "GPS");
}

TEST(HdtNumbered, IrtvIsAFlagOrARemoteControl) {
  const Hdt hdt = hdt_of(kNumbered);
  ASSERT_EQ(hdt.remotes.size(), 1u);
  const HdtRemote& remote = hdt.remotes[0];
  EXPECT_EQ(remote.name, "remote");
  EXPECT_EQ(remote.length, 15);
  EXPECT_EQ(remote.toggle_mask, 8);
  EXPECT_EQ(remote.invert_mask, 0xFF) << "masks are hexadecimal";
  EXPECT_EQ(remote.buffer_size, 4);
  EXPECT_EQ(remote.delay, 20);
}

const std::string kNamed = R"(MOTOR "left" 1A, 20000, "lin"
MOTOR "right" 0x1b 20000 "lin"
ENCODER "eleft" 20 8000 500 "left"
ENCODER "eright" 21 8000 500 "right"
PSD "front" 0 "far away"
SERVO "pan" 30 50 1000 2000
DRIVE "wheels" DIFFERENTIAL 90 "eleft" "eright"
CAM "eye" 1f 2 320 240
ADC "battery" 7 "volts"
SERIAL "console" "/dev/ttyS0"
)" + table("\"lin\"", 101) +
                           table("\"far away\"", 3, 500);

TEST(HdtNamed, DevicesCountFromOneInTheirOrder) {
  const Hdt hdt = hdt_of(kNamed);
  EXPECT_EQ(hdt.dialect, HdtDialect::Named);
  ASSERT_EQ(hdt.motors.size(), 2u);
  EXPECT_EQ(hdt.motors[1].id, 2);
  EXPECT_EQ(hdt.motors[1].name, "right");
  EXPECT_EQ(hdt.motors[0].address, 0x1A);
  EXPECT_EQ(hdt.motors[1].address, 0x1B);
  EXPECT_EQ(hdt.motors[1].pwm_frequency, 20000);
  EXPECT_EQ(hdt.encoders[1].motor, 2);
  EXPECT_DOUBLE_EQ(hdt.encoders[0].max_speed, 500);
  EXPECT_EQ(hdt.table_of(hdt.psds[0])->name, "far away");
  EXPECT_EQ(hdt.servos[0].frequency, 50);
  ASSERT_TRUE(hdt.camera);
  EXPECT_EQ(hdt.camera->address, 0x1F);
  EXPECT_EQ(hdt.camera->width, 320);
  ASSERT_EQ(hdt.adcs.size(), 1u);
  EXPECT_EQ(hdt.adcs[0].address, 7);
  ASSERT_EQ(hdt.serials.size(), 1u);
  EXPECT_EQ(hdt.serials[0].device, "/dev/ttyS0");
}

TEST(HdtNamed, DriveFindsItsEncodersByName) {
  const Hdt hdt = hdt_of(
      "ENCODER \"b\" 1 100 0 \"m\"\nENCODER \"a\" 2 100 0 \"m\"\nMOTOR \"m\" 1 100\n"
      "DRIVE \"d\" ACKERMANN 100 110 200 \"a\" \"b\"\n");
  ASSERT_TRUE(hdt.drive);
  EXPECT_EQ(hdt.drive->kind, robot::DriveKind::Ackermann);
  EXPECT_DOUBLE_EQ(hdt.drive->rear_wheel_base, 0.11);
  EXPECT_DOUBLE_EQ(hdt.drive->axle_distance, 0.2);
  EXPECT_THAT(hdt.drive->encoders, ElementsAre(2, 1));
}

TEST(HdtNamed, OmniDriveHasFourEncoders) {
  const Hdt hdt = hdt_of(
      "MOTOR \"m\" 1 100\nENCODER \"a\" 2 100 0 \"m\"\n"
      "DRIVE \"d\" OMNI 100 200 \"a\" \"a\" \"a\" \"a\"\n");
  EXPECT_EQ(hdt.drive->kind, robot::DriveKind::Omni);
  EXPECT_THAT(hdt.drive->encoders, ElementsAre(1, 1, 1, 1));
}

TEST(HdtReading, KeywordsOfAnyCaseDosLineEndsAndAMissingLastOneAreFine) {
  const Hdt hdt = hdt_of("\xEF\xBB\xBFmotor 1 t\r\ntable t\r\n" + [] {
    std::string values;
    for (int i = 0; i <= 100; ++i) values += std::to_string(i) + ",";
    return values;
  }() + "\r\nend table");
  EXPECT_EQ(hdt.table_of(hdt.motors[0])->values.back(), 100);
}

TEST(HdtReading, UnknownKeywordsAreIgnoredWithAWarning) {
  std::vector<Warning> warnings;
  const Hdt hdt = read_hdt("MOTR 1 t\nCOMPASS \"c\" 1\nWINGS 2\nLCD 0\n", "hdt.txt", warnings);
  EXPECT_TRUE(hdt.motors.empty());
  ASSERT_EQ(warnings.size(), 3u);
  EXPECT_EQ(warnings[0].str(), "hdt.txt:1:1: warning: 'MOTR' ignored: expected 'MOTOR'?");
  EXPECT_THAT(warnings[1].str(), HasSubstr("hdt.txt:2:1: warning: COMPASS ignored"));
  EXPECT_THAT(warnings[2].str(), HasSubstr("'WINGS' ignored: expected EYEBOT, SSID"));
}

struct BadCase {
  const char* name;
  std::string text;
  std::string message;
};
void PrintTo(const BadCase& tested, std::ostream* out) { *out << tested.name; }

class BadHdt : public testing::TestWithParam<BadCase> {};

TEST_P(BadHdt, IsRefusedAtItsPlace) { EXPECT_EQ(hdt_error(GetParam().text), GetParam().message); }

const BadCase kBad[] = {
    {"MissingTable", "LCD 0\nPSD 1 none\n",
     "hdt.txt:2:7: no table 'none' in this file: expected the name of a TABLE"},
    {"ShortMotorTable", "MOTOR 1 t\n" + table("t", 100),
     "hdt.txt:2:1: table 't' of MOTOR 1 has 100 values: expected 101"},
    {"LongServoTable", "SERVO 1 1000 2000 t\n" + table("t", 257),
     "hdt.txt:2:1: table 't' of SERVO 1 has 257 values: expected 256"},
    {"PsdTableOfOne", "PSD 1 t\nTABLE t\n5\nEND TABLE\n",
     "hdt.txt:2:1: table 't' of PSD 1 has 1 values: expected at least 2"},
    {"MotorTableBeyondFullSpeed", "MOTOR 1 t\n" + table("t", 101, 2),
     "hdt.txt:8:5: 102 found in table 't' of MOTOR 1: expected 0 to 100"},
    {"NegativeRange", "PSD 1 t\nTABLE t 4 -3\nEND\n",
     "hdt.txt:2:11: -3 found in table 't' of PSD 1: expected 0 to 65535"},
    {"WordInATable", "TABLE t\n1 2\nMOTOR 1 t\n",
     "hdt.txt:3:1: 'MOTOR' found in table 't', which begins in line 1: expected a whole number or "
     "END TABLE"},
    {"FractionInATable", "TABLE t\n1 2.5\nEND TABLE\n",
     "hdt.txt:2:3: '2.5' found: expected a value of table 't', a whole number"},
    {"OpenTable", "TABLE t\n1 2\n",
     "hdt.txt:2:1: file ends in table 't', which begins in line 1: expected END TABLE"},
    {"TableTwice", "TABLE t\nEND TABLE\nTABLE t\nEND TABLE\n",
     "hdt.txt:3:7: table 't' is given twice, first in line 1: expected one"},
    {"TableWithoutAName", "TABLE\n", "hdt.txt:1:6: line ends: expected the name of the table"},
    {"NumbersOutsideATable", "LCD 0\n1 2 3\n",
     "hdt.txt:2:1: '1' outside a table: expected a keyword or TABLE before it"},
    {"EndWithoutATable", "END TABLE\n",
     "hdt.txt:1:1: 'END' outside a table: expected a keyword or TABLE before it"},
    {"MotorTwice", "MOTOR 1\nMOTOR 1\n",
     "hdt.txt:2:7: motor 1 is given twice, first in line 1: expected one"},
    {"FifthMotor", "MOTOR 5\n", "hdt.txt:1:7: the number of the motor is 5: expected 1 to 4"},
    {"PsdWithoutATable", "PSD 1\n",
     "hdt.txt:1:6: 'PSD' with 1 argument: expected 'PSD number table'"},
    {"ServoBackwards", "SERVO 1 2000 1000\n",
     "hdt.txt:1:14: longest pulse found: expected more than the shortest"},
    {"EncoderWithoutTicks", "ENCODER 1 0\n",
     "hdt.txt:1:11: ticks per metre is 0: expected 1 to 10000000"},
    {"DriveDirection", "DRIVE 100 200 0 2\n",
     "hdt.txt:1:17: the right motor's direction is 2: expected 0 to 1"},
    {"DriveTwice", "DRIVE 100 200 0 1\nDRIVE 100 200 0 1\n",
     "hdt.txt:2:1: a second DRIVE, after the one in line 1: expected one"},
    {"DriveKind", "DRIVE \"d\" SYNCHRO 1\n",
     "hdt.txt:1:11: 'SYNCHRO' found: expected DIFFERENTIAL, ACKERMANN or OMNI"},
    {"EncoderOfNoMotor", "ENCODER \"e\" 1 100 0 \"m\"\n",
     "hdt.txt:1:21: 'm' found: expected the name of a MOTOR of this file"},
    {"DriveOfNoEncoder", "DRIVE \"d\" DIFFERENTIAL 100 \"a\" \"b\"\n",
     "hdt.txt:1:28: 'a' found: expected the name of an ENCODER of this file"},
    {"NameTwice", "MOTOR \"m\" 1 100\nMOTOR \"m\" 2 100\n",
     "hdt.txt:2:7: 'm' is given twice, first in line 1: expected one"},
    {"MixedDialects", "MOTOR 1\nPSD \"p\" 1 \"t\"\n",
     "hdt.txt:2:5: 'p' found: expected a number, as in line 1"},
    {"RegisterNotHexadecimal", "MOTOR \"m\" 1g 100\n",
     "hdt.txt:1:11: '1g' found: expected the register, a hexadecimal number of at most 31 bits"},
    {"OpenQuote", "MOTOR \"m 1 100\n",
     "hdt.txt:1:7: quote \" is not closed: expected another one on this line"},
    {"UsbTwice", "USB 1 a\nUSB 1 b\n", "hdt.txt:2:5: a second USB 1: expected one"},
    {"UsbBeyondTwenty", "USB 21 a\n",
     "hdt.txt:1:5: the number of the interface is 21: expected 0 to 20"},
};

INSTANTIATE_TEST_SUITE_P(Hdt, BadHdt, testing::ValuesIn(kBad),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(HdtReading, AFileWithoutAnyOfItsKeywordsIsNoHdt) {
  EXPECT_THAT(hdt_error(""), HasSubstr("hdt.txt:1:1: no keyword of an HDT in it: expected EYEBOT"));
  EXPECT_THAT(hdt_error("floor_texture x\nrobi y\n"),
              HasSubstr("hdt.txt:2:1: no keyword of an HDT"));
  EXPECT_THAT(hdt_error(std::string("\0\1", 2)), HasSubstr("expected a text file"));
}

TEST(HdtReading, ATableMayNotGrowForEver) {
  EXPECT_THAT(hdt_error(table("t", 65537)),
              HasSubstr("table 't' is too long: expected at most 65536"));
}

TEST(ServoLimits, AreInTensOfMicrosecondsAndAtMost255) {
  HdtServo servo;
  servo.shortest_pulse = 704e-6;
  servo.longest_pulse = 2300e-6;
  EXPECT_EQ(servo_limits(servo), (ServoLimits{70, 230}));
  servo.longest_pulse = 3000e-6;
  EXPECT_EQ(servo_limits(servo).upper, 255);
  // More tens of microseconds than an int holds: processors differ in what they make of these.
  servo.shortest_pulse = -25'000.0;
  servo.longest_pulse = 25'000.0;
  EXPECT_EQ(servo_limits(servo), (ServoLimits{0, 255}));
}

}  // namespace
}  // namespace eyebridge::files
