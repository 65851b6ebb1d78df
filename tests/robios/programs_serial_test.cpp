// SER: a program that talks to a device on a pseudo-terminal.
#include <array>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <unistd.h>

#include "eyebridge/base/unique_fd.hpp"
#include "named_program.hpp"

namespace eyebridge {
namespace {

using ::testing::HasSubstr;
using testing::ProgramRun;

/// A device that answers "<" + what came + ">" to seven bytes, then to three.
class Device {
 public:
  Device() {
    int far = -1;
    int near = -1;
    std::array<char, 128> name{};
    if (::openpty(&far, &near, name.data(), nullptr, nullptr) != 0) {
      throw std::runtime_error("no pty");
    }
    far_.reset(far);
    near_.reset(near);
    name_ = name.data();
    thread_ = std::jthread([this](const std::stop_token& stop) { answer(stop); });
  }
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  void answer(const std::stop_token& stop) {
    std::string came;
    std::size_t wanted = 7;
    while (!stop.stop_requested()) {
      pollfd entry{far_.get(), POLLIN, 0};
      if (::poll(&entry, 1, 10) <= 0) continue;
      char byte = 0;
      if (::read(far_.get(), &byte, 1) != 1) continue;
      came += byte;
      if (came.size() < wanted) continue;
      const std::string reply = "<" + came + ">" + (wanted == 7 ? "!!" : "");
      EXPECT_EQ(::write(far_.get(), reply.data(), reply.size()),
                static_cast<ssize_t>(reply.size()));
      came.clear();
      wanted = 3;
    }
  }

  UniqueFd far_;
  UniqueFd near_;
  std::string name_;
  std::jthread thread_;
};

TEST(ProgramsSerial, APortIsUsedInAllForms) {
  for (const auto& clock : testing::kClocks) {
    const Device device;
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
