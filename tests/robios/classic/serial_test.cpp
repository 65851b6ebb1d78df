// OSInitRS232 and its sisters: a program that talks to a device on a pseudo-terminal.

#include <array>
#include <stdexcept>
#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <unistd.h>

#include "eyebridge/base/unique_fd.hpp"
#include "named_program.hpp"

namespace eyebridge {
namespace {

/// A device that answers "<" + what came + ">!!" to seven bytes.
class EchoDevice {
 public:
  EchoDevice() {
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
    while (!stop.stop_requested()) {
      pollfd entry{far_.get(), POLLIN, 0};
      if (::poll(&entry, 1, 10) <= 0) continue;
      char byte = 0;
      if (::read(far_.get(), &byte, 1) != 1) continue;
      came += byte;
      if (came.size() < 7) continue;
      const std::string reply = "<" + came + ">!!";
      EXPECT_EQ(::write(far_.get(), reply.data(), reply.size()),
                static_cast<ssize_t>(reply.size()));
      came.clear();
    }
  }

  UniqueFd far_;
  UniqueFd near_;
  std::string name_;
  std::jthread thread_;
};

TEST(ClassicSerial, BytesGoAndComeOneByOne) {
  const EchoDevice device;
  const testing::ProgramRun r = testing::run_named(
      "serial_c", {{"EYEBRIDGE_SERIAL", "1=" + device.name()}, {"EYEBRIDGE_FAST", "false"}});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.out,
            "bad baud 8\ninit 0\nnothing 1\nsent 0\n<hello!n>!!\nlast 0\nwaiting 0\nout 0\n"
            "flush 0\nnull 2\n");
}

}  // namespace
}  // namespace eyebridge
