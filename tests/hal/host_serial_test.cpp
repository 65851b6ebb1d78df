// Serial interfaces of the computer, on pseudo-terminals; how their devices are named.
#include "host/host_serial.hpp"

#include <filesystem>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <termios.h>
#include <unistd.h>

#include "eyebridge/base/unique_fd.hpp"
#include "host/serial_devices.hpp"
#include "rigs.hpp"
#include "run_program.hpp"

namespace eyebridge::hal {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;
using ::testing::Pair;
using ::testing::UnorderedElementsAre;

/// A serial port, and what is at the other end of its cable.
class HostSerialTest : public ::testing::Test {
 protected:
  HostSerialTest() {
    int far = -1;
    int near = -1;
    char name[128] = "";
    if (::openpty(&far, &near, name, nullptr, nullptr) != 0) throw std::runtime_error("no pty");
    far_.reset(far);
    near_.reset(near);
    path_ = name;
  }
  void arrives(std::string_view text) const {
    ASSERT_EQ(::write(far_.get(), text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }
  std::string read_far(std::size_t count) const {
    std::string text(count, '\0');
    text.resize(
        static_cast<std::size_t>(std::max<ssize_t>(::read(far_.get(), text.data(), count), 0)));
    return text;
  }
  static std::string received(SerialPort& port, std::size_t most, Time patience = 10s) {
    std::vector<std::uint8_t> buffer(most);
    const std::size_t count = must(port.receive(buffer, patience));
    return {buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(count)};
  }
  static std::span<const std::uint8_t> bytes(std::string_view text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
  }

  UniqueFd far_;
  UniqueFd near_;
  std::string path_;
};

TEST_F(HostSerialTest, CarriesAllBytesBothWays) {
  HostSerial port(1, path_);
  ASSERT_TRUE(port.open(115200, false));
  ASSERT_TRUE(port.send(bytes(std::string_view("a\0\r\n\x03\xFF", 6))));
  EXPECT_EQ(read_far(6), std::string_view("a\0\r\n\x03\xFF", 6));
  arrives(std::string_view("b\0\n\x11", 4));
  EXPECT_EQ(received(port, 2), std::string_view("b\0", 2));
  EXPECT_EQ(must(port.pending()), 2u);
  EXPECT_EQ(received(port, 9), "\n\x11");
  EXPECT_EQ(received(port, 9, Time{0}), "");
}

TEST_F(HostSerialTest, OneThreadSendsWhileAnotherWaits) {
  HostSerial port(1, path_);
  ASSERT_TRUE(port.open(115200, false));
  std::string answer;
  std::thread waiting([&] { answer = received(port, 1, 60s); });
  ASSERT_TRUE(port.send(bytes("question")));  // hangs when the one who waits has the port
  EXPECT_EQ(read_far(8), "question");
  arrives("!");
  waiting.join();
  EXPECT_EQ(answer, "!");
}

TEST_F(HostSerialTest, FlushForgetsWhatHasCome) {
  HostSerial port(1, path_);
  ASSERT_TRUE(port.open(9600, true));
  arrives("old");
  while (must(port.pending()) < 3) {
  }
  ASSERT_TRUE(port.flush());
  EXPECT_EQ(must(port.pending()), 0u);
  arrives("new");
  EXPECT_EQ(received(port, 1), "n");
}

TEST_F(HostSerialTest, ClosedItDoesNothing) {
  HostSerial port(3, path_);
  EXPECT_EQ(port.send(bytes("x")).error().code, Errc::Unsupported);
  EXPECT_THAT(port.pending().error().what, HasSubstr("serial 3: it is not open"));
  ASSERT_TRUE(port.open(9600, false));
  ASSERT_TRUE(port.open(19200, false)) << "again, with another rate";
  ASSERT_TRUE(port.close());
  ASSERT_TRUE(port.close());
  EXPECT_EQ(port.flush().error().code, Errc::Unsupported);
}

TEST_F(HostSerialTest, WhatCameBeforeTheEndIsHandedOver) {
  HostSerial port(1, path_);
  ASSERT_TRUE(port.open(9600, false));
  arrives("last");
  while (must(port.pending()) < 4) {
  }
  far_.reset();
  EXPECT_EQ(received(port, 9), "last");
  std::uint8_t byte = 0;
  EXPECT_EQ(port.receive({&byte, 1}, 1s).error().code, Errc::Disconnected);
}

TEST_F(HostSerialTest, ADeviceThatCannotBeOpenedSaysWhy) {
  HostSerial missing(1, "/dev/there-is-no-such-device");
  EXPECT_THAT(missing.open(9600, false).error().what, HasSubstr("no such device"));
  HostSerial unnamed(2, "no-such-gps-receiver");
  EXPECT_THAT(unnamed.open(9600, false).error().what, HasSubstr("'no-such-gps-receiver'"));
  HostSerial slow(1, path_);
  EXPECT_EQ(slow.open(49, false).error().code, Errc::OutOfRange);
}

TEST(SerialDevicesSetting, GivesNumbersTheirDevices) {
  EXPECT_THAT(parse_serial_devices("0=/dev/ttyS0; 20 = GPS receiver", {}),
              UnorderedElementsAre(Pair(0, "/dev/ttyS0"), Pair(20, "GPS receiver")));
  EXPECT_TRUE(parse_serial_devices("", {}).empty());
}

TEST(SerialDevicesSetting, MistakesAreNamed) {
  for (const char* text : {"GPS", "=x", "1=", "21=x", "-1=x", "1 2=x", "a=x", "1=x; 1=y"}) {
    EXPECT_THROW(parse_serial_devices(text, {"--serial"}), ConfigError) << text;
  }
}

TEST(SerialDevicesSetting, ANameIsLookedForAmongTheLinks) {
  const testing::ScratchFolder folder;
  folder.write("usb-u-blox_GPS_7-if00", "");
  folder.write("usb-Arduino_b-if00", "");
  folder.write("usb-Arduino_a-if00", "");
  EXPECT_EQ(find_serial_device("gps", folder.path()), folder.path() + "/usb-u-blox_GPS_7-if00");
  EXPECT_EQ(find_serial_device("Arduino", folder.path()), folder.path() + "/usb-Arduino_a-if00");
  EXPECT_EQ(find_serial_device("lidar", folder.path()), "");
  EXPECT_EQ(find_serial_device("./tty", folder.path()), "./tty");
  EXPECT_EQ(find_serial_device("gps", folder.path() + "/none"), "");
}

}  // namespace
}  // namespace eyebridge::hal
