#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <utility>

#include "eyebridge/base/units.hpp"
#include "eyebridge/hal/device_notes.hpp"

namespace eyebridge::hal {

/// A device whose calls are noted; `inner` and what is noted in are lent.
template <class Device>
class Noting : public Device {
 public:
  Noting(Device& inner, const DeviceNotes& notes) : inner_(inner), notes_(notes) {}

 protected:
  /// `result`, noted in `cell`; `values` makes a note of its value.
  template <class Value, class Values>
  Result<Value> noted(NoteCell& cell, Result<Value> result, const Values& values) {
    if (result) {
      cell.put(notes_.stamp(), values(*result));
    } else {
      cell.put_failure(notes_.stamp());
    }
    return result;
  }
  Result<double> noted(NoteCell& cell, Result<double> result) {
    return noted(cell, std::move(result), [](double value) { return NoteCell::Values{value}; });
  }
  Result<int> noted(NoteCell& cell, Result<int> result) {
    return noted(cell, std::move(result),
                 [](int value) { return NoteCell::Values{static_cast<double>(value)}; });
  }
  Result<bool> noted(NoteCell& cell, Result<bool> result) {
    return noted(cell, std::move(result),
                 [](bool value) { return NoteCell::Values{value ? 1.0 : 0.0}; });
  }
  /// A command that had these `values`.
  Result<void> noted(NoteCell& cell, Result<void> result, const NoteCell::Values& values) {
    if (result) {
      cell.put(notes_.stamp(), values);
    } else {
      cell.put_failure(notes_.stamp());
    }
    return result;
  }

  Device& inner_;
  const DeviceNotes& notes_;
};

class NotingDrive final : public Noting<Drive> {
 public:
  NotingDrive(Drive& inner, DeviceNotes& notes)
      : Noting(inner, notes),
        wanted_(notes.add("drive", 1, "", Quantity::WantedSpeed)),
        goal_(notes.add("drive", 1, "", Quantity::Goal)),
        progress_(notes.add("drive", 1, "", Quantity::Progress)),
        speed_(notes.add("drive", 1, "", Quantity::Speed)),
        pose_(notes.add("drive", 1, "", Quantity::Pose)) {}

  Result<void> set_speed(const Twist& twist) override {
    return noted(wanted_, inner_.set_speed(twist), {twist.linear, twist.angular});
  }
  Result<void> start(const DriveGoal& goal) override {
    return noted(goal_, inner_.start(goal), {goal.distance, goal.angle, goal.speed});
  }
  Result<DriveStatus> status() override {
    return noted(progress_, inner_.status(), [](const DriveStatus& s) {
      return NoteCell::Values{static_cast<double>(s.progress), s.remaining,
                              s.stalled_left ? 1.0 : 0.0, s.stalled_right ? 1.0 : 0.0};
    });
  }
  Result<Twist> measured_twist() override {
    return noted(speed_, inner_.measured_twist(), [](const Twist& t) {
      return NoteCell::Values{t.linear, t.angular};
    });
  }
  Result<Pose> odometry() override {
    return noted(pose_, inner_.odometry(), [](const Pose& p) {
      return NoteCell::Values{p.x, p.y, p.theta};
    });
  }
  Result<void> set_odometry(const Pose& pose) override {
    return noted(pose_, inner_.set_odometry(pose), {pose.x, pose.y, pose.theta});
  }

 private:
  NoteCell& wanted_;
  NoteCell& goal_;
  NoteCell& progress_;
  NoteCell& speed_;
  NoteCell& pose_;
};

class NotingRangeSensor final : public Noting<RangeSensor> {
 public:
  NotingRangeSensor(RangeSensor& inner, DeviceNotes& notes, int id, const std::string& name)
      : Noting(inner, notes),
        distance_(notes.add("psd", id, name, Quantity::Distance)),
        raw_(notes.add("psd", id, name, Quantity::Raw)) {}

  Result<double> read() override { return noted(distance_, inner_.read()); }
  Result<int> read_raw() override { return noted(raw_, inner_.read_raw()); }
  [[nodiscard]] double out_of_range() const override { return inner_.out_of_range(); }

 private:
  NoteCell& distance_;
  NoteCell& raw_;
};

class NotingSwitchSensor final : public Noting<SwitchSensor> {
 public:
  NotingSwitchSensor(SwitchSensor& inner, DeviceNotes& notes, const char* kind, int id,
                     const std::string& name)
      : Noting(inner, notes), state_(notes.add(kind, id, name, Quantity::Switch)) {}

  Result<bool> read() override { return noted(state_, inner_.read()); }

 private:
  NoteCell& state_;
};

class NotingLidar final : public Noting<Lidar> {
 public:
  NotingLidar(Lidar& inner, DeviceNotes& notes)
      : Noting(inner, notes), nearest_(notes.add("lidar", 1, "", Quantity::Nearest)) {}

  Result<void> configure(double field_of_view, double tilt, int points) override {
    return inner_.configure(field_of_view, tilt, points);
  }
  [[nodiscard]] LidarShape shape() const override { return inner_.shape(); }
  [[nodiscard]] int points() const override { return inner_.points(); }
  Result<void> read(std::span<double> ranges) override {
    Result<void> result = inner_.read(ranges);
    const bool is_scan = result && !ranges.empty();
    return noted(nearest_, std::move(result), is_scan ? nearest_of(ranges) : NoteCell::Values{});
  }
  [[nodiscard]] double max_range() const override { return inner_.max_range(); }

 private:
  [[nodiscard]] NoteCell::Values nearest_of(std::span<const double> ranges) const {
    const auto nearest = std::ranges::min_element(ranges);
    const double field_of_view = inner_.shape().field_of_view;
    const bool is_circle = field_of_view > 2 * kPi - 1e-9;  // without a ray at both ends
    const auto gaps = static_cast<double>(ranges.size()) - (is_circle ? 0.0 : 1.0);
    if (gaps < 0.5) return {*nearest, 0.0};
    return {*nearest, (0.5 - static_cast<double>(nearest - ranges.begin()) / gaps) * field_of_view};
  }

  NoteCell& nearest_;
};

class NotingCompass final : public Noting<Compass> {
 public:
  NotingCompass(Compass& inner, DeviceNotes& notes)
      : Noting(inner, notes), heading_(notes.add("compass", 1, "", Quantity::Heading)) {}

  Result<double> read() override { return noted(heading_, inner_.read()); }

 private:
  NoteCell& heading_;
};

class NotingGyroscope final : public Noting<Gyroscope> {
 public:
  NotingGyroscope(Gyroscope& inner, DeviceNotes& notes)
      : Noting(inner, notes), rate_(notes.add("gyroscope", 1, "", Quantity::TurnRate)) {}

  Result<double> read() override { return noted(rate_, inner_.read()); }

 private:
  NoteCell& rate_;
};

class NotingAccelerometer final : public Noting<Accelerometer> {
 public:
  NotingAccelerometer(Accelerometer& inner, DeviceNotes& notes)
      : Noting(inner, notes),
        acceleration_(notes.add("accelerometer", 1, "", Quantity::Acceleration)) {}

  Result<Vec2> read() override {
    return noted(acceleration_, inner_.read(), [](Vec2 felt) {
      return NoteCell::Values{felt.x, felt.y};
    });
  }

 private:
  NoteCell& acceleration_;
};

class NotingMotor final : public Noting<Motor> {
 public:
  NotingMotor(Motor& inner, DeviceNotes& notes, int id, const std::string& name)
      : Noting(inner, notes),
        duty_(notes.add("motor", id, name, Quantity::Duty)),
        speed_(notes.add("motor", id, name, Quantity::TickRate)),
        gains_(notes.add("motor", id, name, Quantity::Gains)) {}

  Result<void> set_duty(double duty) override {
    return noted(duty_, inner_.set_duty(duty), {duty});
  }
  Result<void> set_speed(double ticks_per_second) override {
    return noted(speed_, inner_.set_speed(ticks_per_second), {ticks_per_second});
  }
  Result<void> set_pid(int p, int i, int d) override {
    return noted(gains_, inner_.set_pid(p, i, d),
                 {static_cast<double>(p), static_cast<double>(i), static_cast<double>(d)});
  }

 private:
  NoteCell& duty_;
  NoteCell& speed_;
  NoteCell& gains_;
};

class NotingEncoder final : public Noting<Encoder> {
 public:
  NotingEncoder(Encoder& inner, DeviceNotes& notes, int id, const std::string& name)
      : Noting(inner, notes), ticks_(notes.add("encoder", id, name, Quantity::Ticks)) {}

  Result<int> read() override { return noted(ticks_, inner_.read()); }
  Result<void> reset() override { return noted(ticks_, inner_.reset(), {}); }

 private:
  NoteCell& ticks_;
};

class NotingServo final : public Noting<Servo> {
 public:
  NotingServo(Servo& inner, DeviceNotes& notes, int id, const std::string& name)
      : Noting(inner, notes), position_(notes.add("servo", id, name, Quantity::Position)) {}

  Result<void> set(double position) override {
    return noted(position_, inner_.set(position), {position});
  }

 private:
  NoteCell& position_;
};

}  // namespace eyebridge::hal
