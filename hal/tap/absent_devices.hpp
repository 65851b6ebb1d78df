#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "arguments/arguments.hpp"
#include "eyebridge/hal/backend.hpp"

namespace eyebridge::hal {

// Devices that only a tap answers for: every call fails with Unsupported.

inline tl::unexpected<Error> nothing() {
  return fail(Errc::Unsupported, "there is nothing behind this device");
}

class NoDrive final : public Drive {
  Result<void> set_speed(const Twist&) override { return nothing(); }
  Result<void> start(const DriveGoal&) override { return nothing(); }
  Result<DriveStatus> status() override { return nothing(); }
  Result<Twist> measured_twist() override { return nothing(); }
  Result<Pose> odometry() override { return nothing(); }
  Result<void> set_odometry(const Pose&) override { return nothing(); }
};
class NoRangeSensor final : public RangeSensor {
 public:
  explicit NoRangeSensor(double out_of_range) : out_of_range_(out_of_range) {}

 private:
  Result<double> read() override { return nothing(); }
  Result<int> read_raw() override { return nothing(); }
  [[nodiscard]] double out_of_range() const override { return out_of_range_; }
  double out_of_range_;
};
class NoSwitch final : public SwitchSensor {
  Result<bool> read() override { return nothing(); }
};
class NoCompass final : public Compass {
  Result<double> read() override { return nothing(); }
};
class NoGyroscope final : public Gyroscope {
  Result<double> read() override { return nothing(); }
};
class NoAccelerometer final : public Accelerometer {
  Result<Vec2> read() override { return nothing(); }
};
class NoMotor final : public Motor {
  Result<void> set_duty(double) override { return nothing(); }
  Result<void> set_speed(double) override { return nothing(); }
  Result<void> set_pid(int, int, int) override { return nothing(); }
};
class NoEncoder final : public Encoder {
  Result<int> read() override { return nothing(); }
  Result<void> reset() override { return nothing(); }
};
class NoServo final : public Servo {
  Result<void> set(double) override { return nothing(); }
};
/// Keeps the shape that the program asked for, so that it can ask for it again, and knows how much
/// room a scan needs.
class NoLidar final : public Lidar {
 public:
  NoLidar(double max_range, const LidarShape& shape) : max_range_(max_range), shape_(shape) {}

 private:
  Result<void> configure(double field_of_view, double tilt, int points) override {
    shape_ = {field_of_view, tilt, points};
    return {};
  }
  [[nodiscard]] LidarShape shape() const override { return shape_; }
  [[nodiscard]] int points() const override { return shape_.points; }
  Result<void> read(std::span<double> ranges) override {
    return check_scan_size(ranges.size(), shape_.points).and_then([]() -> Result<void> {
      return nothing();
    });
  }
  [[nodiscard]] double max_range() const override { return max_range_; }
  double max_range_;
  LidarShape shape_;
};

class NoDigital final : public DigitalLines {
  Result<void> setup(int, LineMode) override { return nothing(); }
  Result<bool> read(int) override { return nothing(); }
  Result<std::uint16_t> read_all() override { return nothing(); }
  Result<void> write(int, bool) override { return nothing(); }
};
class NoAnalog final : public AnalogInputs {
  Result<int> read(int) override { return nothing(); }
  Result<double> supply_voltage() override { return nothing(); }
};
class NoBoard final : public IoBoard {
  Result<std::string> version() override { return nothing(); }
};
class NoRemote final : public Remote {
  Result<int> read() override { return nothing(); }
};
class NoSerialPort final : public SerialPort {
  Result<void> open(int, bool) override { return nothing(); }
  Result<void> send(std::span<const std::uint8_t>) override { return nothing(); }
  Result<std::size_t> receive(std::span<std::uint8_t>, Time) override { return nothing(); }
  Result<std::size_t> pending() override { return nothing(); }
  Result<void> flush() override { return nothing(); }
  Result<void> close() override { return nothing(); }
};
class NoSound final : public Sound {
  Result<void> tone(double, double) override { return nothing(); }
  Result<void> play(const std::string&) override { return nothing(); }
  Result<bool> is_playing() override { return nothing(); }
};
class NoRadio final : public Radio {
 public:
  explicit NoRadio(int id) : id_(id) {}

 private:
  [[nodiscard]] int id() const override { return id_; }
  Result<void> start() override { return nothing(); }
  Result<void> stop() override { return nothing(); }
  Result<void> send(int, const std::string&) override { return nothing(); }
  Result<std::optional<RadioMessage>> receive() override { return nothing(); }
  Result<std::vector<int>> robots() override { return nothing(); }
  int id_;
};

}  // namespace eyebridge::hal
