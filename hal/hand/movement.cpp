#include "hand/movement.hpp"

#include <algorithm>
#include <cmath>

#include "eyebridge/robot/arc.hpp"

namespace eyebridge::hal {
namespace {

Pose end_of(const Pose& begin, const DriveGoal& goal) {
  const world::Arc arc = robot::arc_of({goal.distance, goal.angle});
  return transform(begin, {arc.displacement.x, arc.displacement.y, arc.turn.angle()});
}

bool is_near(const Pose& a, const Pose& b) {
  return norm(a.position() - b.position()) <= Movement::kFarAway &&
         std::abs(wrap_angle(a.theta - b.theta)) <= Movement::kFarTurned;
}

}  // namespace

double Movement::Part::to_go() const { return std::max(0.0, wanted < 0.0 ? -left : left); }

void Movement::set_speed(const Twist& twist) {
  ++commands_;
  twist_ = twist;
  driving_ = false;
  chained_ = false;
}

void Movement::stop() { set_speed({}); }

void Movement::start(const DriveGoal& goal, const Pose& here) {
  if (goal.speed == 0.0 || (goal.distance == 0.0 && goal.angle == 0.0)) return stop();
  ++commands_;
  const Pose begin = chained_ && !driving_ && is_near(end_, here) ? end_ : here;
  const Pose owed = relative_to(here, begin);
  distance_ = {goal.distance, 0.0};
  angle_ = {goal.angle, 0.0};
  if (goal.distance != 0.0) {
    const Vec2 forward = Heading::from_angle(begin.theta).forward();
    distance_.left = goal.distance + dot(begin.position() - here.position(), forward);
  }
  if (goal.angle != 0.0) angle_.left = goal.angle + owed.theta;
  end_ = end_of(begin, goal);
  twist_ = goal.distance != 0.0 ? Twist{goal.speed, 0.0} : Twist{0.0, goal.speed};
  driving_ = true;
  chained_ = true;
  settle();
}

void Movement::moved(const Pose& from, const Pose& to) {
  if (!driving_) return;
  const double turn = wrap_angle(to.theta - from.theta);
  // The heading half way: with that of either end, noise of the pose would add up to a drift.
  const Vec2 forward = Heading::from_angle(from.theta + 0.5 * turn).forward();
  distance_.left -= dot(to.position() - from.position(), forward);
  angle_.left -= turn;
  settle();
}

void Movement::settle() {
  const bool there = distance_.wanted == 0.0 || distance_.to_go() <= kHandDistance;
  const bool turned = angle_.wanted == 0.0 || angle_.to_go() <= kHandAngle;
  if (there && turned) driving_ = false;
}

double Movement::remaining() const {
  return driving_ && distance_.wanted != 0.0 ? distance_.to_go() : 0.0;
}

Instruction Movement::instruction() const {
  Instruction out;
  out.command = commands_;
  if (driving_) {
    out.kind = Instruction::Kind::Goal;
    out.distance = std::copysign(remaining(), distance_.wanted);
    if (angle_.wanted != 0.0) out.angle = std::copysign(angle_.to_go(), angle_.wanted);
    out.speed = twist_;
  } else if (!chained_ && twist_ != Twist{}) {
    out.kind = Instruction::Kind::Speed;
    out.speed = twist_;
  }
  return out;
}

}  // namespace eyebridge::hal
