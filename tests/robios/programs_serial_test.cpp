// SER: a program that talks to a device on a pseudo-terminal.
#include <functional>
#include <map>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "named_program.hpp"
#include "pty_device.hpp"

namespace eyebridge {
namespace {

using ::testing::HasSubstr;
using testing::ProgramRun;

/// "<" + what came + ">!!" to seven bytes, then "<" + what came + ">" to three.
std::function<std::string(const std::string&)> echo() {
  return [wanted = std::size_t{7}](const std::string& came) mutable -> std::string {
    if (came.size() < wanted) return "";
    const std::string end = wanted == 7 ? "!!" : "";
    wanted = 3;
    return "<" + came + ">" + end;
  };
}

TEST(ProgramsSerial, APortIsUsedInAllForms) {
  for (const auto& clock : testing::kClocks) {
    const testing::PtyDevice device(echo());
    std::map<std::string, std::string> settings = clock;
    settings["EYEBRIDGE_SERIAL"] = "1=" + device.name();
    const ProgramRun r = testing::run_named("serial_port", settings);
    EXPECT_EQ(r.exit_code, 0) << r.err;
    EXPECT_THAT(r.out, HasSubstr("closed 1 0\ninit 0\nsend 0 0 0\n"));
    EXPECT_THAT(r.out, HasSubstr("received 3C 6F 6E 65 2E 61 00 62 3E 21 21\n"));
    EXPECT_THAT(r.out, HasSubstr("then <two>\nnone 0 flush 0\n"));
    EXPECT_THAT(r.out, HasSubstr("bad 1 0 0 1\nbad init 1 1 1\nclose 0, char 0\n"));
    EXPECT_THAT(r.err, HasSubstr("--serial \"7=/dev/ttyUSB0\""));
  }
}

}  // namespace
}  // namespace eyebridge
