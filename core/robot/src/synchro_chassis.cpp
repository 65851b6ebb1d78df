#include <algorithm>
#include <cmath>
#include <optional>

#include "chassis.hpp"
#include "eyebridge/base/math.hpp"

namespace eyebridge::robot {
namespace {

// Steering that is off by less is right, radians.
constexpr double kStraight = 1e-9;

/// Wheels that roll and are steered together (Siegwart, Nourbakhsh and Scaramuzza, Introduction to
/// Autonomous Mobile Robots, 2nd ed., 2011, section 3.3). What belongs to it is where the wheels
/// point, not where the body does. A turn of the steering motor is one of the wheels.
class SynchroChassis final : public Chassis {
 public:
  SynchroChassis(const DriveModel& model, const MotorModel& motor)
      : Chassis(model, motor),
        arm_(model.wheel_diameter / 2),
        top_(model.max_angular),
        acceleration_(model.angular_acceleration) {
    wheels_[1].motor.top = model.max_angular * arm_;
    wheels_[1].rolls = false;
  }

  Rims follow(const DriveController& /*controller*/, const Twist& twist) override {
    if (!aim_) return {drive(0, twist.linear), drive(1, arm_ * twist.angular)};
    const double off = how_far_off();
    const double dt = wheels_[1].motor.dt;
    double fastest = std::min(top_, std::abs(off) / dt);
    if (acceleration_ > 0.0) {
      // So that it can still stop there; the last bit is a step's worth.
      const double step = acceleration_ * dt;
      fastest = std::min({fastest, std::max(std::sqrt(2 * acceleration_ * std::abs(off)), step),
                          std::abs(turning_) + step});
    }
    turning_ = off == 0.0 ? 0.0 : std::copysign(fastest, off);
    // On the way there only what goes in the direction counts.
    const double along = std::max(sin_cos(off).cos, 0.0);
    return {drive(0, along * twist.linear), drive(1, arm_ * turning_)};
  }

  [[nodiscard]] BodyStep ground(const Rims& travel, const Ground& ground) const override {
    const double way = ground.way * travel[0];
    const Vec2 chord =
        heading_.rotate(arc_of(PathStep{way, ground.turn * travel[1] / arm_}).displacement);
    // Nothing keeps the body from turning when one side of it rolls farther.
    return {chord.x, chord.y, way * heading_.cos * ground.uneven / wheel_base_};
  }

  [[nodiscard]] BodyStep seen(const Rims& travel) const override {
    return {travel[0], 0.0, travel[1] / arm_};
  }

  void settle(const Rims& travel, const Ground& ground, bool /*held*/) override {
    if (travel[1] != 0.0) {
      heading_ = Heading::from_angle((angle_ += ground.turn * travel[1] / arm_));
    }
  }

  [[nodiscard]] bool is_settled() const override { return turning_ == 0.0; }
  [[nodiscard]] bool repeats() const override {
    return turning_ == 0.0 && wheels_[1].wheel.speed() == 0.0;
  }

  void set_twist(const HolonomicTwist& twist, const Twist& present,
                 DriveController& controller) override {
    double speed = norm({twist.linear, twist.lateral});
    if (speed > 0.0) {
      if (!aim_) turning_ = present.angular;
      aim_ = arc_tan2(twist.lateral, twist.linear);
      // Along the wheels or against them, whichever is nearer.
      if (std::abs(how_far_off()) > kPi / 2) {
        aim_ = *aim_ + kPi;
        speed = -speed;
      }
    }
    controller.set_speed({speed, 0.0}, {present.linear, 0.0});
  }

  void release() override {
    aim_.reset();
    turning_ = 0.0;
  }

  [[nodiscard]] double steering() const override { return heading_.angle(); }

  void add_to(StateHash& hash) const override {
    Chassis::add_to(hash);
    hash.add(angle_);
  }

 private:
  /// From where the wheels point to `aim_`, radians.
  [[nodiscard]] double how_far_off() const {
    const double off = wrap_angle(*aim_ - wheels_[1].wheel.travel() / arm_);
    return std::abs(off) <= kStraight ? 0.0 : off;
  }

  double arm_;  ///< Metres of the steering motor's rim a radian.
  double top_;
  double acceleration_;
  std::optional<double> aim_;  ///< Of set_twist(): direction in the robot, radians.
  double turning_ = 0.0;       ///< Of the wheels towards `aim_`, radians per second.
  double angle_ = 0.0;         ///< Where the wheels point, radians from the robot's front …
  Heading heading_;            ///< … and as a vector.
};

}  // namespace

std::unique_ptr<Chassis> make_synchro(const RobotModel& robot, const MotorModel& motor,
                                      double /*water*/) {
  return std::make_unique<SynchroChassis>(robot.drive, motor);
}

}  // namespace eyebridge::robot
