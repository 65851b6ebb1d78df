#include "board/host_controller.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "../bridges/transport/fake_clock.hpp"
#include "board/make_controller.hpp"
#include "eyebridge/base/random.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge::hal {
namespace {

using namespace std::chrono_literals;

constexpr double kTicksPerMetre = 6484;
constexpr double kWheelBase = 0.09;

/// A board as that of shared/judges: it counts and obeys at once and exactly, and its answers take
/// some time, none the same as the one before.

class SlowBoard final : public BoardLink {
 public:
  SlowBoard(Clock& clock, Time answer, std::uint64_t seed)
      : clock_(clock), answer_(answer), random_(seed) {
    ticks_ = {random_.uniform(), random_.uniform()};
  }

  Result<BoardCount> encoder(int id) override {
    roll();
    const Time at = clock_.now();
    const auto ticks = static_cast<std::int32_t>(std::floor(ticks_[index(id)]));
    clock_.spend(answer_ + from_seconds(3e-3 * random_.uniform()));
    return BoardCount{ticks, at, clock_.now() - at};
  }
  Result<void> motor_speed(int id, int ticks_per_10ms) override {
    roll();
    speeds_[index(id)] = ticks_per_10ms;
    return {};
  }
  [[nodiscard]] double driven() const { return (ticks_[0] + ticks_[1]) / 2 / kTicksPerMetre; }
  [[nodiscard]] double turned() const {
    return (ticks_[1] - ticks_[0]) / kTicksPerMetre / kWheelBase;
  }

  [[nodiscard]] bool has_motor(int id) const override { return id == 1 || id == 2; }
  [[nodiscard]] bool has_speed_control() const override { return holds_speeds; }
  [[nodiscard]] bool has_encoder(int id) const override { return has_motor(id); }
  [[nodiscard]] bool has_servo(int) const override { return false; }
  [[nodiscard]] bool has_psd(int) const override { return false; }
  [[nodiscard]] bool has_digital() const override { return false; }
  [[nodiscard]] bool has_analog() const override { return false; }
  [[nodiscard]] bool has_remote() const override { return false; }
  Result<void> motor_duty(int, int) override { return lacks(); }
  Result<void> motor_pid(int, int, int, int) override { return lacks(); }
  Result<void> servo(int, int) override { return lacks(); }
  Result<int> psd_raw(int) override { return lacks(); }
  Result<double> psd_metres(int) override { return lacks(); }
  Result<void> digital_setup(int, LineMode) override { return lacks(); }
  Result<bool> digital_in(int) override { return lacks(); }
  Result<std::uint16_t> digital_in_all() override { return lacks(); }
  Result<void> digital_out(int, bool) override { return lacks(); }
  Result<int> analog(int) override { return lacks(); }
  Result<double> supply_voltage() override { return lacks(); }
  Result<std::string> version() override { return lacks(); }
  Result<int> remote_key() override { return lacks(); }
  std::unique_ptr<DriveController> make_drive(const BoardDriveShape&) override { return nullptr; }
  Result<void> stop() override { return lacks(); }
  void look_after() override {}
  [[nodiscard]] std::uint32_t generation() const override { return 1; }

  bool holds_speeds = true;

 private:
  static std::size_t index(int id) { return static_cast<std::size_t>(id) - 1; }
  static tl::unexpected<Error> lacks() {
    return fail(Errc::Unsupported, "this board has wheels and encoders alone");
  }
  void roll() {
    const double seconds = to_seconds(clock_.now() - rolled_);
    rolled_ = clock_.now();
    for (std::size_t i = 0; i < 2; ++i) ticks_[i] += 100.0 * speeds_[i] * seconds;
  }

  Clock& clock_;
  Time answer_;
  Random random_;
  Time rolled_{0};
  std::array<double, 2> ticks_{};
  std::array<int, 2> speeds_{};
};

BoardDriveShape shape() {
  BoardDriveShape shape;
  shape.wheel_base = kWheelBase;
  shape.left_ticks_per_metre = shape.right_ticks_per_metre = kTicksPerMetre;
  return shape;
}

// Its commands were taken, and nothing moved.
TEST(HostController, ABoardWhoseMotorsHoldNoSpeedHasNoDrive) {
  bridges::testing::FakeClock clock;
  SlowBoard board(clock, 2ms, 0);
  EXPECT_NE(make_controller(board, clock, shape()), nullptr);
  board.holds_speeds = false;
  EXPECT_EQ(make_controller(board, clock, shape()), nullptr);
}

// One curve in some thirty was driven to and fro at its end, until that looked like a wheel that
// is held.
TEST(HostController, EachCurveOverASlowLineEnds) {
  for (const Time answer : {8ms, 16ms, 20ms, 30ms, 60ms}) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      bridges::testing::FakeClock clock;
      SlowBoard board(clock, answer, seed);
      HostController drive(board, clock, shape());
      const double distance = seed % 2 == 0 ? -0.25 : 0.3;
      const double angle = deg_to_rad(40.0 + static_cast<double>(seed % 60));
      drive.step();
      ASSERT_TRUE(drive.start({distance, angle, 0.15}));
      while (drive.status()->progress == DriveProgress::Driving && clock.now() < 20s) {
        const Time next = clock.now() + 1ms;
        drive.step();
        clock.wait_until(next);
      }
      EXPECT_EQ(drive.status()->progress, DriveProgress::Done) << answer / 1ms << " ms " << seed;
      EXPECT_NEAR(board.driven(), distance, 2e-3) << answer / 1ms << " ms " << seed;
      EXPECT_NEAR(board.turned(), angle, deg_to_rad(3.5)) << answer / 1ms << " ms " << seed;
    }
  }
}

}  // namespace
}  // namespace eyebridge::hal
