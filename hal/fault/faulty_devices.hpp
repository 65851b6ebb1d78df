#pragma once

#include <optional>
#include <vector>

#include "eyebridge/hal/backend.hpp"
#include "fault/fault_gate.hpp"

namespace eyebridge::hal {

// Each stands in front of a device of another backend, which it borrows, and behind a gate of its
// own.

class FaultyDrive final : public Drive {
 public:
  FaultyDrive(Drive& inner, FaultGate& gate) : inner_(inner), gate_(gate) {}
  Result<void> set_speed(const Twist& twist) override {
    return gate_.command([&] { return inner_.set_speed(twist); });
  }
  Result<void> start(const DriveGoal& goal) override {
    return gate_.command([&] { return inner_.start(goal); });
  }
  Result<DriveStatus> status() override {
    return gate_.reading(status_, [&] { return inner_.status(); });
  }
  Result<Twist> measured_twist() override {
    return gate_.reading(twist_, [&] { return inner_.measured_twist(); });
  }
  Result<Pose> odometry() override {
    return gate_.reading(pose_, [&] { return inner_.odometry(); });
  }
  Result<void> set_odometry(const Pose& pose) override {
    return gate_.command([&] { return inner_.set_odometry(pose); });
  }

 private:
  Drive& inner_;
  FaultGate& gate_;
  std::optional<DriveStatus> status_;
  std::optional<Twist> twist_;
  std::optional<Pose> pose_;
};

class FaultyRangeSensor final : public RangeSensor {
 public:
  FaultyRangeSensor(RangeSensor& inner, FaultGate& gate) : inner_(inner), gate_(gate) {}
  Result<double> read() override {
    return gate_.reading(range_, [&] { return inner_.read(); });
  }
  Result<int> read_raw() override {
    return gate_.reading(raw_, [&] { return inner_.read_raw(); });
  }
  [[nodiscard]] double out_of_range() const override { return inner_.out_of_range(); }

 private:
  RangeSensor& inner_;
  FaultGate& gate_;
  std::optional<double> range_;
  std::optional<int> raw_;
};

class FaultySwitchSensor final : public SwitchSensor {
 public:
  FaultySwitchSensor(SwitchSensor& inner, FaultGate& gate) : inner_(inner), gate_(gate) {}
  Result<bool> read() override {
    return gate_.reading(last_, [&] { return inner_.read(); });
  }

 private:
  SwitchSensor& inner_;
  FaultGate& gate_;
  std::optional<bool> last_;
};

class FaultyLidar final : public Lidar {
 public:
  FaultyLidar(Lidar& inner, FaultGate& gate) : inner_(inner), gate_(gate) {}
  Result<void> configure(double field_of_view, double tilt, int points) override {
    return gate_.command([&] { return inner_.configure(field_of_view, tilt, points); });
  }
  [[nodiscard]] LidarShape shape() const override { return inner_.shape(); }
  [[nodiscard]] int points() const override { return inner_.points(); }
  Result<void> read(std::span<double> ranges) override;
  [[nodiscard]] double max_range() const override { return inner_.max_range(); }

 private:
  Lidar& inner_;
  FaultGate& gate_;
  std::optional<std::vector<double>> scan_;
};

class FaultyCompass final : public Compass {
 public:
  FaultyCompass(Compass& inner, FaultGate& gate) : inner_(inner), gate_(gate) {}
  Result<double> read() override {
    return gate_.reading(last_, [&] { return inner_.read(); });
  }

 private:
  Compass& inner_;
  FaultGate& gate_;
  std::optional<double> last_;
};

class FaultyMotor final : public Motor {
 public:
  FaultyMotor(Motor& inner, FaultGate& gate) : inner_(inner), gate_(gate) {}
  Result<void> set_duty(double duty) override {
    return gate_.command([&] { return inner_.set_duty(duty); });
  }
  Result<void> set_speed(double ticks_per_second) override {
    return gate_.command([&] { return inner_.set_speed(ticks_per_second); });
  }
  Result<void> set_pid(int p, int i, int d) override {
    return gate_.command([&] { return inner_.set_pid(p, i, d); });
  }

 private:
  Motor& inner_;
  FaultGate& gate_;
};

class FaultyEncoder final : public Encoder {
 public:
  FaultyEncoder(Encoder& inner, FaultGate& gate) : inner_(inner), gate_(gate) {}
  Result<int> read() override {
    return gate_.reading(last_, [&] { return inner_.read(); });
  }
  Result<void> reset() override {
    return gate_.command([&] { return inner_.reset(); });
  }

 private:
  Encoder& inner_;
  FaultGate& gate_;
  std::optional<int> last_;
};

class FaultyServo final : public Servo {
 public:
  FaultyServo(Servo& inner, FaultGate& gate) : inner_(inner), gate_(gate) {}
  Result<void> set(double position) override {
    return gate_.command([&] { return inner_.set(position); });
  }

 private:
  Servo& inner_;
  FaultGate& gate_;
};

}  // namespace eyebridge::hal
