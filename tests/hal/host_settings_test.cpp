// From --serial, --player and --radio to devices, whatever the backend is.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/hal/registry.hpp"
#include "rigs.hpp"
#include "run_program.hpp"

namespace eyebridge::hal {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class HostSettings : public ::testing::Test {
 protected:
  std::unique_ptr<Backend> open(std::map<std::string, std::string> flags) {
    flags.emplace("fast", "true");
    return open_backend({rig_config(flags), log_});
  }
  std::string complaint(std::map<std::string, std::string> flags) {
    try {
      open(std::move(flags));
      return "";
    } catch (const ConfigError& error) {
      return error.what();
    }
  }
  KeepingLog log_;
};

TEST_F(HostSettings, GiveEveryRobotSoundAndRadio) {
  const auto robot = open({});
  EXPECT_NE(robot->sound(), nullptr);
  ASSERT_NE(robot->radio(), nullptr);
  EXPECT_EQ(robot->radio()->id(), 1);
  EXPECT_EQ(robot->radio(), robot->radio());
  EXPECT_EQ(robot->serial_port(0), nullptr);
  EXPECT_EQ(robot->remote(), nullptr);
  EXPECT_EQ(robot->io_board(), nullptr);
}

TEST_F(HostSettings, NameTheRadio) {
  EXPECT_EQ(open({{"radio", "none"}})->radio(), nullptr);
  const auto robot = open({{"radio", "world?id=7"}});
  EXPECT_EQ(robot->radio()->id(), 7);
  ASSERT_TRUE(robot->radio()->start());
  EXPECT_THAT(must(robot->radio()->robots()), ElementsAre(7));
}

TEST_F(HostSettings, NameTheSerialPorts) {
  const testing::ScratchFolder folder;
  const std::string hdt = folder.write("hdt.txt",
                                       "USB 1 EyeBot7\nUSB 2 GPS\nDRIVE 90 60 0 1\n"
                                       "ENCODER 1 6484\nENCODER 2 6484\nMOTOR 1\nMOTOR 2\n");
  const auto robot = open({{"serial", "2=/dev/none; 0=/dev/ttyS0"}, {"hdt", hdt}});
  EXPECT_NE(robot->serial_port(0), nullptr);
  ASSERT_NE(robot->serial_port(1), nullptr);
  ASSERT_NE(robot->serial_port(2), nullptr);
  EXPECT_EQ(robot->serial_port(3), nullptr);
  EXPECT_EQ(robot->serial_port(-1), nullptr);
  // The user's word goes before the file's.
  EXPECT_THAT(robot->serial_port(2)->open(9600, false).error().what, HasSubstr("/dev/none"));
  EXPECT_THAT(robot->serial_port(1)->open(9600, false).error().what, HasSubstr("'EyeBot7'"));
}

TEST_F(HostSettings, AreCheckedBeforeAnythingIsOpened) {
  EXPECT_THAT(complaint({{"serial", "0=/dev/ttyS0; x"}}),
              HasSubstr("--serial:1:15: found 'x', expected an interface"));
  EXPECT_THAT(complaint({{"radio", "loud"}}), HasSubstr("--radio: found 'loud'"));
  EXPECT_THAT(complaint({{"radio", "udp:239.192.7.1:7007"}}), HasSubstr("leave --fast out"));
  EXPECT_THAT(complaint({{"psd_numbers", "2016"}}), HasSubstr("robot|2015"));
  EXPECT_THAT(complaint({{"supply_voltage", "48"}}), HasSubstr("0 … 20"));
}

TEST_F(HostSettings, SupplyTheBattery) {
  const auto robot = open({{"supply_voltage", "6.5"}});
  EXPECT_DOUBLE_EQ(must(robot->analog()->supply_voltage()), 6.5);
  EXPECT_EQ(must(robot->analog()->read(0)), 1330);  // 6.5 of 20 V in 4095 steps, cut off
}

TEST_F(HostSettings, DevicesOfTheComputerCanBeMixedToo) {
  const auto robot = open({{"mix", "radio=sim;sound=sim;digital=sim;analog=sim"}});
  ASSERT_TRUE(robot->radio()->start());
  EXPECT_TRUE(robot->sound()->tone(1000, 0.1));
  EXPECT_THAT(complaint({{"mix", "board=sim:"}}), HasSubstr("that robot has no board"));
  EXPECT_THAT(complaint({{"mix", "remote=sim:"}}), HasSubstr("that robot has no remote"));
  EXPECT_THAT(complaint({{"mix", "serial=sim:"}}), HasSubstr("that robot has no serial"));
}

}  // namespace
}  // namespace eyebridge::hal
