#include <algorithm>
#include <cmath>

#include "chassis.hpp"

namespace eyebridge::robot {
namespace {

constexpr double kAtRest = 1e-9;  // metres per second, upward

/// Which thruster is which, as programs number them from 1.
enum Thruster : std::size_t { kLeft, kFront, kRight, kBack };

/// A hull in water: left and right thrusters for surge and yaw, front and back ones for heave. Drag
/// is linear, with one time constant for all three, so that to the plane a thruster is a wheel with
/// a lagging motor. No pitch: front and back thrusters count by their mean.
class SubmarineChassis final : public Chassis {
 public:
  SubmarineChassis(const RobotModel& model, const MotorModel& motor, double water)
      : Chassis(model.drive, motor),
        rise_(model.drive.rise_speed),
        top_(std::max(water - model.height, 0.0)),
        altitude_(top_) {
    wheels_[kLeft].side = 1.0;
    wheels_[kRight].side = -1.0;
    for (const Thruster i : {kFront, kBack}) {
      wheels_[i].motor.top = model.drive.max_vertical;
      wheels_[i].rolls = false;
      wheels_[i].is_apart = true;
    }
  }

  Rims follow(const DriveController& /*controller*/, const Twist& twist) override {
    const double turning = twist.angular * wheel_base_ / 2;
    Rims rims{};
    rims[kLeft] = reach(kLeft, twist.linear - turning);
    rims[kRight] = reach(kRight, twist.linear + turning);
    return rims;
  }

  Rims run() override {
    Rims rims{};
    for (const Thruster i : {kLeft, kRight}) rims[i] = obey(i);
    return rims;
  }

  [[nodiscard]] BodyStep seen(const Rims& travel) const override {
    const PathStep path = path_of({travel[kLeft], travel[kRight]}, wheel_base_);
    return {path.distance, 0.0, path.angle};
  }

  /// It still turns where something is in its way.
  [[nodiscard]] Rims blocked(const Rims& travel, double progress) const override {
    const double lost = (1.0 - progress) * (travel[kLeft] + travel[kRight]) / 2;
    Rims rims = travel;
    rims[kLeft] -= lost;
    rims[kRight] -= lost;
    return rims;
  }

  void settle(const Rims& /*travel*/, const Ground& /*ground*/, bool /*held*/) override {
    // Exact solution of T v' = end - v over the step, and its integral.
    const MotorModel& motor = wheels_[kFront].motor;
    const double end = pull();
    const double difference = rising_ - end;
    rising_ = end + difference * motor.decay;
    altitude_ += end * motor.dt + difference * motor.lag;
    if (altitude_ >= top_) {
      altitude_ = top_;
      rising_ = std::min(rising_, 0.0);
    }
    if (altitude_ <= 0.0) {
      altitude_ = 0.0;
      rising_ = std::max(rising_, 0.0);
    }
  }

  [[nodiscard]] bool is_settled() const override {
    if (std::abs(rising_) > kAtRest) return false;
    const double end = pull();
    return end == 0.0 || (end > 0.0 ? altitude_ == top_ : altitude_ == 0.0);
  }

  /// Braking goes by the ramp.
  [[nodiscard]] PathStep rolling() const override { return {}; }

  void set_twist(const HolonomicTwist& twist, const Twist& present,
                 DriveController& controller) override {
    release();
    Chassis::set_twist(twist, present, controller);
  }
  void release() override { is_off_ = false; }
  void stop() override {
    is_off_ = true;
    for (const Thruster i : {kFront, kBack}) wheels_[i].command = {};
  }
  void halt() override {
    Chassis::halt();
    rising_ = 0.0;
  }

  [[nodiscard]] double altitude() const override { return altitude_; }
  [[nodiscard]] double highest() const override { return top_; }
  void set_altitude(double altitude) override {
    altitude_ = std::clamp(altitude, 0.0, top_);
    rising_ = 0.0;
  }

  void add_to(StateHash& hash) const override {
    Chassis::add_to(hash);
    hash.add(altitude_);
    hash.add(rising_);
  }

 private:
  /// Drives a thruster so that `speed` is reached at the end of the step, as far as it can: drag is
  /// known. A submarine that is switched off glides.
  double reach(Thruster i, double speed) {
    ChassisWheel& w = wheels_[i];
    const double end = (speed - w.wheel.speed() * w.motor.decay) / (1.0 - w.motor.decay);
    return w.wheel.drive(is_off_ ? 0.0 : end, w.motor);
  }
  /// How fast it would rise in the end, metres per second, if the water went on for ever.
  [[nodiscard]] double pull() const {
    return (wheels_[kFront].command.speed + wheels_[kBack].command.speed) / 2 + rise_;
  }

  double rise_;          ///< DriveModel::rise_speed.
  double top_;           ///< Its altitude where it floats, metres.
  double altitude_;      ///< Of its underside above the floor, metres.
  double rising_ = 0.0;  ///< Metres per second, upward.
  bool is_off_ = false;  ///< After stop(): thrusters do not brake.
};

}  // namespace

std::unique_ptr<Chassis> make_submarine(const RobotModel& robot, const MotorModel& motor,
                                        double water) {
  check_model(robot.height <= water, "robot: the submarine is higher than the water is deep");
  return std::make_unique<SubmarineChassis>(robot, motor, water);
}

}  // namespace eyebridge::robot
