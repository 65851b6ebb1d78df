// OSInitRS232 and its sisters: a program that talks to a device on a pseudo-terminal.

#include <string>

#include <gtest/gtest.h>

#include "named_program.hpp"
#include "pty_device.hpp"

namespace eyebridge {
namespace {

/// "<" + what came + ">!!" to seven bytes.
std::string echo(const std::string& came) { return came.size() < 7 ? "" : "<" + came + ">!!"; }

TEST(ClassicSerial, BytesGoAndComeOneByOne) {
  const testing::PtyDevice device(echo);
  const testing::ProgramRun r = testing::run_named(
      "serial_c", {{"EYEBRIDGE_SERIAL", "1=" + device.name()}, {"EYEBRIDGE_FAST", "false"}});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.out,
            "bad baud 8\ninit 0\nnothing 1\nsent 0\n<hello!n>!!\nlast 0\nwaiting 0\nout 0\n"
            "flush 0\nnull 2\n");
}

}  // namespace
}  // namespace eyebridge
