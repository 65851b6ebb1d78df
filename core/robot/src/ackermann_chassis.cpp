#include <algorithm>
#include <cmath>
#include <limits>

#include "chassis.hpp"
#include "eyebridge/base/math.hpp"

namespace eyebridge::robot {
namespace {

/// A car, as a bicycle in its middle line: the curve's centre lies on the line of the rear axle,
/// where the front wheels' axes meet it (Siegwart, Nourbakhsh and Scaramuzza, Introduction to
/// Autonomous Mobile Robots, 2nd ed., 2011, section 3.3). Speeds and distances are those of the
/// middle of the rear axle.
class AckermannChassis final : public Chassis {
 public:
  AckermannChassis(const DriveModel& model, const MotorModel& motor)
      : Chassis(model, motor),
        axle_distance_(model.axle_distance),
        ahead_(-model.rear_axle),
        lock_(model.max_steering),
        max_curvature_(model.max_curvature()),
        steering_step_(model.steering_speed > 0.0 ? model.steering_speed * motor.dt
                                                  : std::numeric_limits<double>::infinity()) {
    wheels_[0].side = 1.0;
    wheels_[1].side = -1.0;
  }

  Rims follow(const DriveController& controller, const Twist& twist) override {
    // Goals keep way and turn in proportion. The ramps of speeds do not: there the wheels are
    // turned for the curve that it will be.
    const Twist& aim = controller.state() == DriveState::Driving ? twist : controller.target();
    if (aim.linear != 0.0) {
      target_ = limited(arc_tan2(axle_distance_ * aim.angular / aim.linear, 1.0));
    } else if (aim.angular != 0.0) {
      target_ = aim.angular > 0.0 ? lock_ : -lock_;
    }
    is_stuck_ = aim.linear == 0.0 && aim.angular != 0.0 && twist.linear == 0.0;
    turn_steering();
    return rims_of({drive(0, twist.linear)});
  }

  Rims run() override {
    is_stuck_ = false;
    turn_steering();
    return Chassis::run();
  }

  [[nodiscard]] BodyStep ground(const Rims& travel, const Ground& ground) const override {
    // The rear wheels may disagree, by errors: the front ones say which curve it is.
    const double way = ground.way * (travel[0] + travel[1]) / 2;
    return at_centre(way, ground.turn * way * curvature());
  }

  [[nodiscard]] BodyStep seen(const Rims& travel) const override {
    return at_centre((travel[0] + travel[1]) / 2, (travel[1] - travel[0]) / wheel_base_);
  }

  [[nodiscard]] bool can_turn_on_spot() const override { return false; }
  [[nodiscard]] bool is_stuck() const override { return is_stuck_; }
  [[nodiscard]] bool is_settled() const override { return steering_ == target_; }
  [[nodiscard]] bool repeats() const override { return steering_ == target_ && !is_stuck_; }

  void start(const DriveGoal& goal, const Twist& present, DriveController& controller) override {
    const double most = max_curvature_ * std::abs(goal.distance);
    const bool on_the_spot = goal.distance == 0.0;
    const double possible = on_the_spot ? goal.angle : std::clamp(goal.angle, -most, most);
    controller.start({goal.distance, possible, goal.speed}, present);
    // A goal at the limit is none beyond it.
    const bool too_sharp = std::abs(goal.angle - possible) > 1e-9 * most;
    left_over_ = too_sharp && goal.speed != 0.0 ? goal.angle - possible : 0.0;
  }

  void go_on(DriveController& controller) override {
    if (left_over_ == 0.0 || controller.state() == DriveState::Driving) return;
    // On the spot: it will not come to its end.
    controller.start({0.0, left_over_, controller.limits().angular}, controller.twist());
    left_over_ = 0.0;
  }

  void release() override {
    left_over_ = 0.0;
    is_stuck_ = false;
  }

  void set_steering(double angle) override { target_ = limited(angle); }
  [[nodiscard]] double steering() const override { return steering_; }

  void add_to(StateHash& hash) const override {
    Chassis::add_to(hash);
    hash.add(steering_);
  }

 private:
  /// The gear lets the wheels turn as their own curves are long.
  [[nodiscard]] Rims rims_of(const Rims& motors) const override {
    const double apart = motors[0] * curvature() * wheel_base_ / 2;
    return {motors[0] - apart, motors[0] + apart};
  }

  [[nodiscard]] double limited(double angle) const { return std::clamp(angle, -lock_, lock_); }

  void turn_steering() {
    if (steering_ == target_) return;
    steering_ = std::clamp(target_, steering_ - steering_step_, steering_ + steering_step_);
    const SinCos sc = sin_cos(steering_);
    curvature_ = sc.sin / sc.cos / axle_distance_;
  }

  [[nodiscard]] double curvature() const { return curvature_; }

  /// Motion of the robot's centre, which lies `ahead_` of the rear axle.
  [[nodiscard]] BodyStep at_centre(double way, double angle) const {
    return {way, ahead_ * angle, angle};
  }

  double axle_distance_;
  double ahead_;
  double lock_;
  double max_curvature_;
  double steering_step_;  ///< Radians in one step.
  double steering_ = 0.0;
  double target_ = 0.0;     ///< Of the steering.
  double curvature_ = 0.0;  ///< That `steering_` gives.
  double left_over_ = 0.0;  ///< Of a goal: what is too sharp for it.
  bool is_stuck_ = false;
};

}  // namespace

std::unique_ptr<Chassis> make_ackermann(const RobotModel& robot, const MotorModel& motor,
                                        double /*water*/) {
  const DriveModel& drive = robot.drive;
  check_axles(drive);
  check_model(drive.max_steering > 0.0 && drive.max_steering < kPi / 2,
              "robot: the front wheels must turn by more than 0 and less than 90 degrees");
  check_model(std::isfinite(drive.rear_axle), "robot: the rear axle must be somewhere");
  check_model(drive.steering_servo < kServoCount, "robot: the steering needs a servo");
  return std::make_unique<AckermannChassis>(drive, motor);
}

}  // namespace eyebridge::robot
