#pragma once

#include <algorithm>

#include "tap/values.hpp"

namespace eyebridge::hal {

/// A device behind a tap: who it is, and the two kinds of calls.
template <class Device>
class Tapped : public Device {
 public:
  Tapped(Tap& tap, std::string_view kind, int id, Device& inner)
      : tap_(tap), kind_(kind), id_(id), inner_(inner) {}

 protected:
  template <class Value>
  Result<Value> reading(std::string_view name, Result<Value> (Device::*ask)()) {
    const Call call{kind_, id_, name, false, {}};
    return reply_as<Value>(
        call, tap_.exchange(call, [&] { return (inner_.*ask)().map(AsValues<Value>::pack); }));
  }
  template <class CarryOut>
  Result<void> command(std::string_view name, Values request, const CarryOut& carry_out) {
    const Call call{kind_, id_, name, true, std::move(request)};
    return tap_
        .exchange(call,
                  [&]() -> Result<Values> { return carry_out().map([] { return Values{}; }); })
        .map([](const Values&) {});
  }

  Tap& tap_;
  std::string_view kind_;
  int id_;
  Device& inner_;
};

class TappedDrive final : public Tapped<Drive> {
 public:
  using Tapped::Tapped;
  Result<void> set_speed(const Twist& twist) override {
    return command("set_speed", AsValues<Twist>::pack(twist),
                   [&] { return inner_.set_speed(twist); });
  }
  Result<void> start(const DriveGoal& goal) override {
    return command("start", {goal.distance, goal.angle, goal.speed},
                   [&] { return inner_.start(goal); });
  }
  Result<DriveStatus> status() override { return reading("status", &Drive::status); }
  Result<Twist> measured_twist() override {
    return reading("measured_twist", &Drive::measured_twist);
  }
  Result<Pose> odometry() override { return reading("odometry", &Drive::odometry); }
  Result<void> set_odometry(const Pose& pose) override {
    return command("set_odometry", AsValues<Pose>::pack(pose),
                   [&] { return inner_.set_odometry(pose); });
  }
};

class TappedRangeSensor final : public Tapped<RangeSensor> {
 public:
  using Tapped::Tapped;
  Result<double> read() override { return reading("read", &RangeSensor::read); }
  Result<int> read_raw() override { return reading("read_raw", &RangeSensor::read_raw); }
  [[nodiscard]] double out_of_range() const override { return inner_.out_of_range(); }
};

class TappedSwitchSensor final : public Tapped<SwitchSensor> {
 public:
  using Tapped::Tapped;
  Result<bool> read() override { return reading("read", &SwitchSensor::read); }
};

class TappedLidar final : public Tapped<Lidar> {
 public:
  using Tapped::Tapped;
  Result<void> configure(double field_of_view, double tilt, int points) override {
    return command("configure", {field_of_view, tilt, static_cast<double>(points)},
                   [&] { return inner_.configure(field_of_view, tilt, points); });
  }
  [[nodiscard]] LidarShape shape() const override { return inner_.shape(); }
  [[nodiscard]] int points() const override { return inner_.points(); }
  Result<void> read(std::span<double> ranges) override {
    const Call call{kind_, id_, "read", false, {}};
    const Result<Values> scan = tap_.exchange(call, [&]() -> Result<Values> {
      return inner_.read(ranges).map([&] { return Values(ranges.begin(), ranges.end()); });
    });
    if (!scan) return tl::unexpected(scan.error());
    if (scan->size() != ranges.size()) {
      return fail(Errc::Corrupt, fmt::format("lidar: a scan of {} points, expected {}",
                                             scan->size(), ranges.size()));
    }
    std::copy(scan->begin(), scan->end(), ranges.begin());
    return {};
  }
  [[nodiscard]] double max_range() const override { return inner_.max_range(); }
};

class TappedCompass final : public Tapped<Compass> {
 public:
  using Tapped::Tapped;
  Result<double> read() override { return reading("read", &Compass::read); }
};

class TappedGyroscope final : public Tapped<Gyroscope> {
 public:
  using Tapped::Tapped;
  Result<double> read() override { return reading("read", &Gyroscope::read); }
};

class TappedAccelerometer final : public Tapped<Accelerometer> {
 public:
  using Tapped::Tapped;
  Result<Vec2> read() override { return reading("read", &Accelerometer::read); }
};

class TappedMotor final : public Tapped<Motor> {
 public:
  using Tapped::Tapped;
  Result<void> set_duty(double duty) override {
    return command("set_duty", {duty}, [&] { return inner_.set_duty(duty); });
  }
  Result<void> set_speed(double ticks_per_second) override {
    return command("set_speed", {ticks_per_second},
                   [&] { return inner_.set_speed(ticks_per_second); });
  }
  Result<void> set_pid(int p, int i, int d) override {
    return command("set_pid",
                   {static_cast<double>(p), static_cast<double>(i), static_cast<double>(d)},
                   [&] { return inner_.set_pid(p, i, d); });
  }
};

class TappedEncoder final : public Tapped<Encoder> {
 public:
  using Tapped::Tapped;
  Result<int> read() override { return reading("read", &Encoder::read); }
  Result<void> reset() override {
    return command("reset", {}, [&] { return inner_.reset(); });
  }
};

class TappedServo final : public Tapped<Servo> {
 public:
  using Tapped::Tapped;
  Result<void> set(double position) override {
    return command("set", {position}, [&] { return inner_.set(position); });
  }
};

}  // namespace eyebridge::hal
