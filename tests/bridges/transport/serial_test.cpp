#include "eyebridge/bridges/serial.hpp"

#include <asm/termbits.h>  // termios2, which has the bit rate as a number
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "rigs.hpp"

namespace eyebridge::bridges::testing {
namespace {

using ::testing::HasSubstr;

termios2 settings_of(const UniqueFd& terminal) {
  termios2 settings{};
  EXPECT_EQ(::ioctl(terminal.get(), TCGETS2, &settings), 0);
  return settings;
}

void apply(const UniqueFd& terminal, const termios2& settings) {
  ASSERT_EQ(::ioctl(terminal.get(), TCSETS2, &settings), 0);
}

UniqueFd open_as_another(const std::string& path) {
  return UniqueFd(::open(path.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC));
}

class Serial : public ::testing::Test {
 protected:
  Error error_of(const SerialSettings& settings) {
    auto opened = open_serial(settings, clock_);
    return opened ? Error{Errc::Unsupported, "opened"} : opened.error();
  }

  MonotonicClock clock_;
};

TEST_F(Serial, MakesTheLineRawWithTheBitRateAndWithoutHangingUp) {
  const auto [master, path] = open_pty();
  const UniqueFd other = open_as_another(path);
  termios2 before = settings_of(other);
  before.c_cflag |= HUPCL | CSTOPB | PARENB;
  apply(other, before);

  const auto opened = open_serial({path, 921600}, clock_);
  ASSERT_TRUE(opened) << what(opened);

  const termios2 now = settings_of(other);
  EXPECT_EQ(now.c_lflag & (ICANON | ECHO | ISIG | IEXTEN), 0u);
  EXPECT_EQ(now.c_oflag & OPOST, 0u);
  EXPECT_EQ(now.c_iflag & (IXON | ICRNL | INLCR | ISTRIP | BRKINT), 0u);
  EXPECT_EQ(now.c_cflag & (CSIZE | PARENB | CSTOPB | HUPCL), static_cast<tcflag_t>(CS8));
  EXPECT_NE(now.c_cflag & CLOCAL, 0u);
  EXPECT_EQ(now.c_ospeed, 921600u);
  EXPECT_EQ(now.c_ispeed, 921600u);
}

TEST_F(Serial, TakesBitRatesThatHaveNoName) {
  const auto [master, path] = open_pty();
  const auto opened = open_serial({path, 123456}, clock_);
  ASSERT_TRUE(opened) << what(opened);
  EXPECT_EQ(settings_of(master).c_ospeed, 123456u);
}

TEST_F(Serial, ForgetsWhatCameBeforeItWasOpened) {
  const auto [master, path] = open_pty();
  // A program before us left the line raw and something unread.
  const UniqueFd before = open_as_another(path);
  termios2 raw = settings_of(before);
  raw.c_lflag = raw.c_iflag = 0;
  apply(before, raw);
  ASSERT_EQ(::write(master.get(), "AT+E", 4), 4);
  char first = 0;
  ASSERT_EQ(::read(before.get(), &first, 1), 1);  // so the rest has arrived too

  auto opened = open_serial({path, 115200}, clock_);
  ASSERT_TRUE(opened) << what(opened);
  ASSERT_EQ(::write(master.get(), ">", 1), 1);
  EXPECT_EQ(read_exactly(**opened, 1, clock_.now() + kSoon), Bytes{'>'});
}

TEST_F(Serial, BelongsToOneAtATime) {
  const auto [master, path] = open_pty();
  auto first = open_serial({path, 115200}, clock_);
  ASSERT_TRUE(first) << what(first);
  const Error second = error_of({path, 115200});
  EXPECT_EQ(second.code, Errc::Disconnected);
  EXPECT_EQ(second.what, path + ": in use by another program");

  (*first)->close();
  const auto third = open_serial({path, 115200}, clock_);
  EXPECT_TRUE(third) << what(third);
}

TEST_F(Serial, LeavesTheLineOfAnotherProgramAlone) {
  const auto [master, path] = open_pty();
  const UniqueFd other = open_as_another(path);
  ASSERT_EQ(::flock(other.get(), LOCK_EX | LOCK_NB), 0);
  const termios2 before = settings_of(other);
  EXPECT_THAT(error_of({path, 57600}).what, HasSubstr("in use"));
  const termios2 after = settings_of(other);
  EXPECT_EQ(after.c_lflag, before.c_lflag);
  EXPECT_EQ(after.c_ospeed, before.c_ospeed);
}

TEST_F(Serial, SaysThatADeviceIsMissing) {
  const Error error = error_of({"/dev/ttyACM_none", 115200});
  EXPECT_EQ(error.code, Errc::Disconnected);
  EXPECT_EQ(error.what, "/dev/ttyACM_none: no such device; expected a board that is plugged in");
}

TEST_F(Serial, SaysThatAFileIsNoSerialPort) {
  for (const char* const path : {"/dev/null", "/etc/passwd"}) {
    const Error error = error_of({path, 115200});
    EXPECT_EQ(error.code, Errc::Unsupported);
    EXPECT_EQ(error.what, std::string(path) + ": not a serial port");
  }
}

TEST_F(Serial, SaysThatPermissionIsMissing) {
  const auto [master, path] = open_pty();
  // A directory cannot be opened for writing, even by root; users are refused by the mode.
  const bool is_root = ::geteuid() == 0;
  if (!is_root) ::chmod(path.c_str(), 0);
  const Error error = is_root ? error_of({"/dev", 115200}) : error_of({path, 115200});
  EXPECT_EQ(error.code, Errc::Disconnected);
  EXPECT_THAT(error.what, HasSubstr(is_root ? "Is a directory" : "permission denied"));
}

}  // namespace
}  // namespace eyebridge::bridges::testing
