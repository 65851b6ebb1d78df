#include "machine/serial_ports.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

#include "fake_machine.hpp"
#include "machine/holders.hpp"

namespace eyebridge::apps {
namespace {

using eyebridge::testing::FakeMachine;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

SerialPort only_port(const FakeMachine& machine) {
  const SerialState state = look_at_serial(machine.root());
  EXPECT_EQ(state.ports.size(), 1u);
  return state.ports.empty() ? SerialPort{} : state.ports.front();
}

TEST(SerialPorts, AMachineWithoutAnySaysSo) {
  const FakeMachine machine;
  const auto findings = judge_serial(look_at_serial(machine.root()));
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_FALSE(findings[0].found);
  EXPECT_THAT(findings[0].detail, HasSubstr("no /dev/ttyACM*"));
}

TEST(SerialPorts, ABoardIsShownWithNameNumbersAndDriver) {
  const FakeMachine machine;
  machine.add_acm();
  const SerialPort port = only_port(machine);
  EXPECT_EQ(port.device, "/dev/ttyACM0");
  EXPECT_EQ(port.by_id, "/dev/serial/by-id/usb-UWA_Interface_Board-if00");
  EXPECT_EQ(port.product, "Interface Board (03eb:2404)");
  EXPECT_EQ(port.driver, "cdc_acm");
  EXPECT_TRUE(port.access.permitted);
  EXPECT_FALSE(port.latency_ms);
  EXPECT_THAT(port.holders, IsEmpty());
  EXPECT_FALSE(port.hidden_from_modem_manager);
  EXPECT_EQ(described(port), "Interface Board (03eb:2404), driver cdc_acm");
}

TEST(SerialPorts, WhoHasItOpenIsNamed) {
  const FakeMachine machine;
  machine.add_acm();
  machine.add_process(812, "minicom", "/dev/ttyACM0");
  machine.add_process(813, "bash", "/dev/pts/3");
  EXPECT_THAT(only_port(machine).holders, ElementsAre(Process{812, "minicom"}));
  const auto findings = judge_serial(look_at_serial(machine.root()));
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_THAT(findings[1].advice, Contains("in use by minicom (process 812): end it first"));
}

TEST(SerialPorts, WhoLocksItIsNamedAlsoWhenItsFilesAreHidden) {
  const FakeMachine machine;
  machine.add_acm();
  machine.add_process(900, "python3");
  struct stat file {};
  ASSERT_EQ(::stat(machine.path("/dev/ttyACM0").c_str(), &file), 0);
  const auto line = [&](const char* start, int process, unsigned long inode) {
    return fmt::format("{} FLOCK  ADVISORY  WRITE {} {:02x}:{:02x}:{} 0 EOF\n", start, process,
                       major(file.st_dev), minor(file.st_dev), inode);
  };
  machine.file("/proc/locks", line("1:", 900, file.st_ino) + line("2:", 901, file.st_ino + 1) +
                                  line("1: ->", 902, file.st_ino));
  EXPECT_THAT(holders_of("/dev/ttyACM0", machine.root()), ElementsAre(Process{900, "python3"}));
  machine.file("/proc/locks", line("1:", 0, file.st_ino));
  EXPECT_EQ(listed(holders_of("/dev/ttyACM0", machine.root())),
            "a process outside of this container");
}

TEST(SerialPorts, ALinkToTheDeviceHasTheSameHolders) {
  const FakeMachine machine;
  machine.add_acm();
  machine.add_process(812, "minicom", "/dev/ttyACM0");
  EXPECT_THAT(holders_of("/dev/serial/by-id/usb-UWA_Interface_Board-if00", machine.root()),
              ElementsAre(Process{812, "minicom"}));
}

TEST(SerialPorts, HoldersAreListedAsASentence) {
  EXPECT_EQ(listed({}), "");
  EXPECT_EQ(listed({{1, "a"}, {2, "b"}, {3, "c"}}),
            "a (process 1), b (process 2) and c (process 3)");
}

TEST(SerialPorts, ModemManagerIsKeptAwayByTheRule) {
  const FakeMachine machine;
  machine.add_acm();
  machine.add_process(400, "ModemManager");
  const auto warned = judge_serial(look_at_serial(machine.root()));
  EXPECT_THAT(warned[1].advice, Contains(HasSubstr("ModemManager (process 400) sends modem")));
  machine.file("/run/udev/data/c166:0", "I:123\nE:ID_VENDOR=UWA\nE:ID_MM_PORT_IGNORE=1\n");
  const auto calm = judge_serial(look_at_serial(machine.root()));
  EXPECT_THAT(calm[1].advice, ::testing::Not(Contains(HasSubstr("ModemManager"))));
}

TEST(SerialPorts, ASlowLatencyTimerIsToldHowToBecomeFast) {
  const FakeMachine machine;
  machine.file("/dev/ttyUSB0", "");
  machine.file("/sys/bus/usb-serial/devices/ttyUSB0/latency_timer", "16\n");
  const auto slow = judge_serial(look_at_serial(machine.root()));
  EXPECT_THAT(slow[1].advice, Contains(HasSubstr("holds bytes back for 16 ms")));
  EXPECT_THAT(slow[1].advice,
              Contains(HasSubstr("echo 1 >/sys/bus/usb-serial/devices/ttyUSB0/latency_timer")));
  machine.file("/sys/bus/usb-serial/devices/ttyUSB0/latency_timer", "1\n");
  EXPECT_THAT(judge_serial(look_at_serial(machine.root()))[1].advice, IsEmpty());
}

TEST(SerialPorts, WhoIsNotPermittedIsToldTheGroupAndTheCommand) {
  SerialPort port;
  port.device = "/dev/ttyACM0";
  port.access.group = "dialout";
  port.access.group_may = true;
  EXPECT_THAT(how_to_be_permitted(port), HasSubstr("sudo usermod -aG dialout $USER"));
  const Finding finding = judge_port(port, {});
  EXPECT_FALSE(finding.found);
  EXPECT_THAT(finding.detail, HasSubstr("not permitted (group dialout)"));
  EXPECT_EQ(finding.remedy, how_to_be_permitted(port));

  port.access.in_group = true;
  EXPECT_THAT(how_to_be_permitted(port), HasSubstr("log out and in again"));
  EXPECT_THAT(how_to_be_permitted(port), ::testing::Not(HasSubstr("usermod")));

  port.access.group_may = false;
  EXPECT_THAT(how_to_be_permitted(port), HasSubstr("eyebridge doctor --udev"));
}

TEST(SerialPorts, WhatCannotBeReadIsNotThere) {
  const FakeMachine machine;
  machine.add_acm();
  machine.file("/sys/bus/usb-serial/devices/ttyACM0/latency_timer", "soon\n");
  machine.file("/proc/locks", "1: FLOCK\n\n2: what is this\n");
  machine.file("/proc/12/comm", "");
  machine.file("/proc/x12/comm", "ModemManager\n");
  const SerialState state = look_at_serial(machine.root());
  EXPECT_FALSE(state.ports[0].latency_ms);
  EXPECT_THAT(state.ports[0].holders, IsEmpty());
  EXPECT_FALSE(state.modem_manager);
}

}  // namespace
}  // namespace eyebridge::apps
