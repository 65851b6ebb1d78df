// A wall follower and its robot on a line that loses and flips bytes, in virtual time: the whole
// host, the whole firmware, no process. tests/robust has the same with processes.
#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>

#include "../firmware/bridge_lines.hpp"
#include "board/board_backend.hpp"
#include "board/open_board.hpp"
#include "borrowed_clock.hpp"
#include "eyebridge/base/math.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/bridges/faulty_stream.hpp"
#include "eyebridge/bridges/memory.hpp"
#include "eyebridge/files/load.hpp"
#include "eyebridge/pins/board_world.hpp"
#include "eyebridge/pins/psd_table.hpp"
#include "eyebridge/ports/port.hpp"
#include "rigs.hpp"
#include "run_program.hpp"
#include "turns.hpp"

namespace eyebridge::hal {
namespace {

using bridges::ByteStream;
using testing::TurnClock;

/// Damages what passes once `damaging` is true: the board is found on a sound line.
class LateDamage final : public ByteStream {
 public:
  LateDamage(std::unique_ptr<ByteStream> line, const bridges::FaultPlan& plan, Clock& clock,
             const bool& damaging)
      : sound_(line.get()), damaged_(std::move(line), plan, clock), damaging_(damaging) {}
  Result<std::size_t> read_some(std::span<std::uint8_t> buffer, Time deadline) override {
    return line().read_some(buffer, deadline);
  }
  Result<void> write_all(std::span<const std::uint8_t> bytes, Time deadline) override {
    return line().write_all(bytes, deadline);
  }
  void close() override { damaged_.close(); }
  [[nodiscard]] std::string_view name() const override { return "noisy"; }

 private:
  ByteStream& line() { return damaging_ ? static_cast<ByteStream&>(damaged_) : *sound_; }

  ByteStream* sound_;
  bridges::FaultyStream damaged_;
  const bool& damaging_;
};

class NoisyLine : public ::testing::TestWithParam<int> {
 protected:
  NoisyLine() {
    eb_config config;
    eb_config_default(&config);
    config.io7.letters = EB_LETTERS_PAGE;
    config.silence_us = 300'000;
    auto [near, far] = bridges::make_memory_streams(clock);
    wire = std::move(far);
    port = firmware::port_on(ports::byte_line(world.add_board(0, config)), *wire);
    clock.board = [this](Time now) {
      port->pump();
      world.advance(now);
      port->pump();
    };
    bridges::FaultPlan plan;
    plan.seed = static_cast<std::uint64_t>(GetParam());
    plan.incoming.drop = plan.outgoing.drop = 0.01;
    plan.incoming.flip = plan.outgoing.flip = 0.01;
    auto line = std::make_shared<std::unique_ptr<ByteStream>>(std::make_unique<LateDamage>(
        testing::by_turns(std::move(near), clock), plan, clock, damaging));
    const auto once = [line]() -> Result<std::unique_ptr<ByteStream>> {
      if (*line == nullptr) return fail(Errc::Disconnected, "memory: there is one line only");
      return std::move(*line);
    };
    const std::string hdt = folder.write("hdt.txt", pins::hdt_text(scenario.models.front()));
    const Config settings = rig_config({{"hal", "serial:memory?hdt=" + hdt}});
    backend = open_io7_board(parse_backend_url("serial:memory?hdt=" + hdt, {"test"}),
                             BackendContext{settings, log}, once,
                             std::make_unique<testing::BorrowedClock>(clock));
    clock.host = [this] { dynamic_cast<BoardBackend&>(*backend).step(); };
    damaging = true;
  }

  void wait(int ms) { clock.wait_until(clock.now() + std::chrono::milliseconds(ms)); }

  /// Of three readings that came.
  template <class Read>
  double middle(Read&& read) {
    std::array<double, 3> values{};
    for (double& value : values) {
      auto reading = read();
      for (; !reading; reading = read()) {
        if (clock.now() > kLongest) throw std::runtime_error(reading.error().what);
        wait(10);
      }
      value = *reading;
    }
    std::ranges::sort(values);
    return values[1];
  }
  double range_mm(int sensor) {
    return middle([&] { return backend->range_sensor(sensor)->read(); }) * 1000;
  }
  double askew_deg(int corners) {
    const double heading = middle(
        [&] { return backend->drive()->odometry().map([](const Pose& p) { return p.theta; }); });
    return rad_to_deg(wrap_angle(deg_to_rad(90.0 * corners) - heading));
  }
  void set_speed(double linear, double degrees) {
    (void)backend->drive()->set_speed({linear, deg_to_rad(degrees)});
  }
  /// Until it has ended; false when it failed.
  void turn(double degrees) {
    DriveGoal goal;
    goal.angle = deg_to_rad(degrees);
    goal.speed = deg_to_rad(90);
    if (!backend->drive()->start(goal)) return wait(10);
    while (true) {
      const auto status = backend->drive()->status();
      if (status && status->progress != DriveProgress::Driving) return;
      wait(10);
    }
  }

  /// As tests/parity/follower.c does.
  void follow() {
    int corners = 0;
    double last = range_mm(3);
    while (clock.now() < kLongest) {
      const bool ahead = range_mm(1) < 280 && range_mm(1) < 280;
      const double off = askew_deg(corners);
      if (ahead || std::abs(off) > 20) {
        set_speed(0, 0);
        if (std::abs(off) <= 20 && ++corners == 3) break;
        for (double rest = askew_deg(corners); std::abs(rest) > 2; rest = askew_deg(corners)) {
          turn(rest);
          wait(200);
        }
        last = range_mm(3);
      }
      const double right = range_mm(3);
      set_speed(0.2, std::clamp((240 - right) / 4 + 2 * (last - right), -25.0, 25.0));
      last = right;
      wait(50);
    }
    wait(500);
  }

  static constexpr Time kLongest = std::chrono::minutes(3);

  bool damaging = false;
  TurnClock clock;
  files::Scenario scenario = files::load_scenario(EYEBRIDGE_SOURCE_DIR "/worlds/corridor.wld");
  pins::BoardWorld world{scenario};
  std::unique_ptr<ByteStream> wire;
  std::unique_ptr<ports::Port> port;
  eyebridge::testing::ScratchFolder folder;
  KeepingLog log;
  std::unique_ptr<Backend> backend;
};

TEST_P(NoisyLine, AWallFollowerEndsItsCourse) {
  follow();
  const Pose end = world.simulation().pose(0);
  EXPECT_NEAR(end.x, 0.3, 0.15) << "before the third corner";
  EXPECT_NEAR(end.y, 2.1, 0.15);
}

INSTANTIATE_TEST_SUITE_P(Seeds, NoisyLine, ::testing::Range(1, 13));
// In this one a spoiled byte made the board answer in text, and the host gave it up.
INSTANTIATE_TEST_SUITE_P(AnswersInText, NoisyLine, ::testing::Values(415));

}  // namespace
}  // namespace eyebridge::hal
