#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "chassis.hpp"

namespace eyebridge::robot {
namespace {

constexpr double kNoSpeed = 1e-9;  // metres per second

/// What a wheel's rim does for each of a robot's three speeds.
struct OmniRow {
  double forward = 0.0;
  double left = 0.0;
  double turn = 0.0;  ///< Metres.
};

/// Mecanum wheels whose rollers, seen from above, form an X: to go left, front left and back right
/// roll backward, the other two forward, as RoBIOS programs expect it. Equations of Muir and
/// Neuman, Kinematic modeling for feedback control of an omnidirectional wheeled mobile robot, ICRA
/// 1987.
std::vector<OmniRow> mecanum_rows(const DriveModel& model) {
  const double arm = model.turn_arm();
  return {{1, -1, -arm}, {1, 1, arm}, {1, 1, -arm}, {1, -1, arm}};
}

/// Siegwart, Nourbakhsh and Scaramuzza, Introduction to Autonomous Mobile Robots, 2nd ed., 2011,
/// section 3.2: wheels at 60, -60 and 180 degrees, the left one counted the other way round.
std::vector<OmniRow> swedish_rows(const DriveModel& model) {
  const double arm = model.turn_arm();
  const double root = std::sqrt(3.0) / 2;
  return {{root, -0.5, -arm}, {root, 0.5, arm}, {0.0, -1.0, arm}};
}

class OmniChassis final : public Chassis {
 public:
  OmniChassis(const DriveModel& model, const MotorModel& motor, std::vector<OmniRow> rows)
      : Chassis(model, motor),
        rows_(std::move(rows)),
        top_linear_(model.max_linear),
        lateral_step_(model.linear_acceleration > 0.0 ? model.linear_acceleration * motor.dt
                                                      : std::numeric_limits<double>::infinity()) {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const OmniRow& row = rows_[i];
      // A wheel that turns the robot left by going backward is on its left.
      if (row.forward != 0.0) wheels_[i].side = row.turn < 0.0 ? 1.0 : -1.0;
      squares_.forward += row.forward * row.forward;
      squares_.left += row.left * row.left;
      squares_.turn += row.turn * row.turn;
    }
  }

  Rims follow(const DriveController& /*controller*/, const Twist& twist) override {
    lateral_ = std::clamp(lateral_target_, lateral_ - lateral_step_, lateral_ + lateral_step_);
    Rims rims = rims_at({twist.linear, lateral_, twist.angular});
    // Each part has a ramp of its own: on the way together they may be more than a wheel can.
    const double share = share_of(rims);
    for (std::size_t i = 0; i < rows_.size(); ++i) rims[i] = drive(i, share * rims[i]);
    return rims;
  }

  Rims run() override {
    const Rims rims = Chassis::run();
    lateral_ = seen(rims).left / wheels_[0].motor.dt;
    return rims;
  }

  /// The motion that fits the wheels best, if they contradict each other (least squares; the
  /// columns of the rows are orthogonal).
  [[nodiscard]] BodyStep seen(const Rims& travel) const override {
    BodyStep sum;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      sum.forward += rows_[i].forward * travel[i];
      sum.left += rows_[i].left * travel[i];
      sum.angle += rows_[i].turn * travel[i];
    }
    return {sum.forward / squares_.forward, sum.left / squares_.left, sum.angle / squares_.turn};
  }

  /// The wheels go on with what turns the robot.
  [[nodiscard]] Rims blocked(const Rims& travel, double progress) const override {
    const BodyStep step = seen(travel);
    const Rims way = rims_at({step.forward, step.left, 0.0});
    Rims rims = travel;
    for (std::size_t i = 0; i < rims.size(); ++i) rims[i] -= (1.0 - progress) * way[i];
    return rims;
  }

  void settle(const Rims& /*travel*/, const Ground& /*ground*/, bool held) override {
    if (held) lateral_ = 0.0;
  }

  [[nodiscard]] bool is_settled() const override {
    return lateral_target_ == 0.0 && std::abs(lateral_) <= kNoSpeed;
  }
  [[nodiscard]] bool repeats() const override { return lateral_ == lateral_target_; }

  void set_twist(const HolonomicTwist& twist, const Twist& present,
                 DriveController& controller) override {
    const auto clamped = [](double value, double most) { return std::clamp(value, -most, most); };
    const HolonomicTwist asked{clamped(twist.linear, top_linear_),
                               clamped(twist.lateral, top_linear_),
                               clamped(twist.angular, controller.limits().angular)};
    const double share = share_of(rims_at(asked));
    lateral_target_ = share * asked.lateral;
    controller.set_speed({share * asked.linear, share * asked.angular}, present);
  }

  void release() override { lateral_target_ = 0.0; }
  void stop() override { lateral_ = lateral_target_ = 0.0; }
  void halt() override {
    Chassis::halt();
    lateral_ = 0.0;
  }

  void add_to(StateHash& hash) const override {
    Chassis::add_to(hash);
    hash.add(lateral_);
  }

 private:
  [[nodiscard]] Rims rims_at(const HolonomicTwist& twist) const {
    Rims rims{};
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      rims[i] = rows_[i].forward * twist.linear + rows_[i].left * twist.lateral +
                rows_[i].turn * twist.angular;
    }
    return rims;
  }

  /// How much of `rims` is possible, 0 … 1: all alike, so that direction and curve stay.
  [[nodiscard]] double share_of(const Rims& rims) const {
    double fastest = 0.0;
    for (const double rim : rims) fastest = std::max(fastest, std::abs(rim));
    const double top = wheels_[0].motor.top;
    return fastest > top ? top / fastest : 1.0;
  }

  std::vector<OmniRow> rows_;
  OmniRow squares_;  ///< Sums of them.
  double top_linear_;
  double lateral_step_;   ///< Change of speed in one step, metres per second.
  double lateral_ = 0.0;  ///< Commanded in the last step, metres per second.
  double lateral_target_ = 0.0;
};

}  // namespace

std::unique_ptr<Chassis> make_mecanum(const RobotModel& robot, const MotorModel& motor,
                                      double /*water*/) {
  check_axles(robot.drive);
  return std::make_unique<OmniChassis>(robot.drive, motor, mecanum_rows(robot.drive));
}

std::unique_ptr<Chassis> make_swedish(const RobotModel& robot, const MotorModel& motor,
                                      double /*water*/) {
  return std::make_unique<OmniChassis>(robot.drive, motor, swedish_rows(robot.drive));
}

}  // namespace eyebridge::robot
