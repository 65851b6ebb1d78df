// Opening boards as programs do, with all their threads, on the computer's clock.
#include <atomic>
#include <thread>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include "../bridges/client/fake_robot.hpp"
#include "../bridges/protocol/fake_board.hpp"
#include "board/open_board.hpp"
#include "eyebridge/base/unique_fd.hpp"
#include "eyebridge/bridges/memory.hpp"
#include "eyebridge/bridges/monotonic_clock.hpp"
#include "rigs.hpp"

namespace eyebridge::hal {
namespace {

using namespace std::chrono_literals;
using bridges::ByteStream;
using bridges::io7::FakeBoard;
using ::testing::HasSubstr;

/// What `open` throws; "" when it does not.
template <class Open>
std::string refusal(Open&& open) {
  try {
    open();
    return "";
  } catch (const ConfigError& error) {
    return error.what();
  }
}

/// What opening `url` throws; "" when it opens.
std::string complaint(const std::string& url, std::map<std::string, std::string> flags = {}) {
  KeepingLog log;
  flags["hal"] = url;
  return refusal([&] { open_backend({rig_config(flags), log}); });
}

/// A board behind lines that `line` makes: again after a loss.
Rig io7_rig(const std::string& url,
            std::function<Result<std::unique_ptr<ByteStream>>(Clock& clock)> line) {
  Rig rig;
  rig.log = std::make_unique<KeepingLog>();
  const Config config = rig_config({{"hal", url}});
  auto clock = std::make_unique<bridges::MonotonicClock>();
  auto open = [line = std::move(line), &time = *clock] { return line(time); };
  rig.backend = open_io7_board(parse_backend_url(url, {"rig"}), {config, *rig.log}, std::move(open),
                               std::move(clock));
  return rig;
}

/// A robot on `bus`.
Rig can_rig(const std::string& url, bridges::MemoryCan& bus) {
  Rig rig;
  rig.log = std::make_unique<KeepingLog>();
  const Config config = rig_config({{"hal", url}});
  rig.backend = open_can_board(parse_backend_url(url, {"rig"}), {config, *rig.log},
                               bus.connect("can0"), std::make_unique<bridges::MonotonicClock>());
  return rig;
}

/// A board at the other end of lines in memory, on a thread of its own.
class BoardThread {
 public:
  explicit BoardThread(FakeBoard board) : board_(std::move(board)) {}

  /// A new line to the board.
  std::unique_ptr<ByteStream> plug_in(Clock& clock) {
    unplug();
    auto [near, far] = bridges::make_memory_streams(clock, time_);
    thread_ = std::jthread([this, far = std::move(far)](const std::stop_token& stop) {
      std::array<std::uint8_t, 256> buffer;
      while (!stop.stop_requested()) {
        const auto count = far->read_some(buffer, time_.now() + 20ms);
        if (!count && count.error().code == Errc::Timeout) continue;
        if (!count) return;
        const auto answer = board_.answer(std::span(buffer).first(*count));
        if (!far->write_all(answer, time_.now() + 1s)) return;
      }
    });
    return std::move(near);
  }
  void unplug() { thread_ = {}; }

 private:
  bridges::MonotonicClock time_;  // its own: the host may close its side and be gone first
  FakeBoard board_;
  std::jthread thread_;
};

TEST(BoardOpen, FindsABoardAndLosesItAndFindsItAgain) {
  BoardThread board{FakeBoard{}};
  std::atomic<bool> there = true;
  const Rig rig = io7_rig("serial:test", [&](Clock& clock) -> Result<std::unique_ptr<ByteStream>> {
    if (!there) return fail(Errc::Disconnected, "test: no such device");
    return board.plug_in(clock);
  });
  EXPECT_LT(rig.backend->clock().now(), Time(5s));
  EXPECT_FALSE(rig.backend->clock().is_virtual());
  RangeSensor* psd = rig.backend->range_sensor(1);
  ASSERT_NE(psd, nullptr);
  EXPECT_EQ(psd->read_raw().value(), 512);

  there = false;
  board.unplug();
  EXPECT_EQ(psd->read_raw().error().code, Errc::Disconnected);
  there = true;
  const Time end = rig.backend->clock().now() + 30s;
  while (!psd->read_raw() && rig.backend->clock().now() < end) rig.wait(0.02);
  EXPECT_EQ(psd->read_raw().value(), 512);
  rig.backend->stop();
}

TEST(BoardOpen, ARobotOnABusIsReadyWhenItIsOpened) {
  bridges::MonotonicClock time;
  bridges::MemoryCan bus(time);
  bridges::testing::FakeRobot robot(bus.connect("robot"), 3, time);
  std::jthread living([&](const std::stop_token& stop) {
    for (; !stop.stop_requested(); time.wait_until(time.now() + 5ms)) robot.step();
  });
  {
    const Rig rig = can_rig("can:test?node=3", bus);
    EXPECT_EQ(rig.backend->range_sensor(1)->read().value(), 0.5);
    EXPECT_TRUE(rig.backend->drive()->set_speed({0.1, 0.0}));
  }
  living = {};
  robot.step();
  EXPECT_EQ(robot.last(0x00), "000#8003");
}

TEST(BoardOpen, SaysThatNoRobotHasThatNumber) {
  bridges::MonotonicClock time;
  bridges::MemoryCan bus(time);
  const auto other = bus.connect("other");
  EXPECT_THAT(refusal([&] { can_rig("can:test?node=9", bus); }),
              HasSubstr("--hal: robot 9 on can0: not heard yet; expected its heartbeat; expected "
                        "that it is switched on"));
}

TEST(BoardOpen, SaysThatTheDeviceIsNoBoard) {
  FakeBoard gps;
  gps.list = "$GPGGA,092750.000,5321.6802,N\r\n";
  BoardThread board(gps);
  EXPECT_THAT(
      refusal([&] {
        io7_rig("serial:test", [&](Clock& clock) -> Result<std::unique_ptr<ByteStream>> {
          return board.plug_in(clock);
        });
      }),
      HasSubstr("expected an EyeBot I/O board: is it another device, or another bit rate?"));
}

TEST(BoardOpen, SaysWhatIsWrongWithALine) {
  EXPECT_EQ(complaint("serial:/no/such/device"),
            "--hal: /no/such/device: no such device; expected a board that is plugged in");
  EXPECT_EQ(complaint("serial:/dev/null"), "--hal: /dev/null: not a serial port");
  EXPECT_THAT(complaint("tcp:localhost:1?connect_ms=2000"), HasSubstr("--hal: localhost:1: "));
  EXPECT_THAT(complaint("can:nosuchcan"), HasSubstr("--hal: nosuchcan: "));
}

TEST(BoardOpen, SaysThatAPortIsInUse) {
  const UniqueFd terminal(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC));
  ASSERT_TRUE(terminal.valid());
  ASSERT_EQ(::grantpt(terminal.get()) | ::unlockpt(terminal.get()), 0);
  const std::string name = ::ptsname(terminal.get());
  bridges::MonotonicClock clock;
  const auto holder = bridges::open_serial({name}, clock);
  ASSERT_TRUE(holder) << holder.error().what;
  EXPECT_EQ(complaint("serial:" + name), "--hal: " + name + ": in use by another program");
}

TEST(BoardOpen, RefusesWrongOptions) {
  EXPECT_EQ(complaint("can:can0?node=0"),
            "--hal: found '0' for 'node', expected the number of a robot, 1 … 14");
  EXPECT_THAT(complaint("can:can0?node=99"), HasSubstr("found '99' for 'node'"));
  EXPECT_THAT(complaint("can:can0?node=1x"), HasSubstr("found '1x' for 'node'"));
  EXPECT_THAT(complaint("can:can0?node="), HasSubstr("found '' for 'node'"));
  EXPECT_THAT(complaint("serial:/dev/null?profile=io8"),
              HasSubstr("--hal: found 'io8' for 'profile', expected io7vw or io7"));
  EXPECT_THAT(complaint("serial:/dev/null?profile="), HasSubstr("found '' for 'profile'"));
  EXPECT_THAT(complaint("serial:/dev/null?requests=binary"),
              HasSubstr("found 'binary' for 'requests', expected text or bytes"));
  EXPECT_THAT(complaint("serial:/dev/null?order=big"),
              HasSubstr("for 'order', expected msb or lsb"));
  for (const char* const time : {"", "4", "5001", "50ms", "-7"}) {
    EXPECT_THAT(complaint(std::string("serial:/dev/null?timeout=") + time),
                HasSubstr("for 'timeout', expected milliseconds, 5 … 5000"));
  }
  EXPECT_THAT(complaint("can:can0?ids=12"), HasSubstr("found '12', expected 11 or 29 for 'ids'"));
  EXPECT_THAT(complaint("can:can0?offset=241"), HasSubstr("for 'offset', expected 0 … 240"));
  EXPECT_THAT(complaint("can:can0?ids=29&offset=0x20000000"), HasSubstr("expected 0 … 536868864"));
  EXPECT_THAT(complaint("serial:/dev/null?node=1"), HasSubstr("found the option 'node', expected"));
  EXPECT_THAT(complaint("serial:/dev/null?baud=fast"), HasSubstr("found 'fast' for 'baud'"));
  EXPECT_THAT(complaint("can:can0?baud=9600"), HasSubstr("found the option 'baud', expected"));
  EXPECT_THAT(complaint("serial:"), HasSubstr("expected the device of a serial port"));
  EXPECT_THAT(complaint("tcp:robot"), HasSubstr("expected a host and a port"));
  EXPECT_THAT(complaint("serial:/dev/null?hdt=/no/such.txt"), HasSubstr("/no/such.txt"));
  EXPECT_THAT(complaint("can:can0", {{"hdt", "/no/such.txt"}}), HasSubstr("/no/such.txt"));
}

TEST(BoardOpen, IsNotDoneForACheck) {
  for (const BackendFactory& row : backend_table()) {
    // A remote robot, too: it waits for all robots.
    const bool has_effects = row.scheme != "sim" && row.scheme != "replay";
    EXPECT_EQ(row.has_effects, has_effects) << row.scheme;
  }
}

}  // namespace
}  // namespace eyebridge::hal
