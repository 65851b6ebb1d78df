#include "hand/instruction.hpp"

#include <cmath>

#include <fmt/format.h>

#include "eyebridge/base/units.hpp"

namespace eyebridge::hal {
namespace {

using camera::Arrow;

/// Forward or backward, left or right: the signs of what is to be done. A goal's parts that are
/// reached are zero.
struct Way {
  double along = 0.0;
  double turn = 0.0;
};

Way way_of(const Instruction& instruction) {
  if (instruction.kind == Instruction::Kind::Goal) return {instruction.distance, instruction.angle};
  if (instruction.kind == Instruction::Kind::Speed) {
    return {instruction.speed.linear, instruction.speed.angular};
  }
  return {};
}

const char* name_of(Arrow arrow) {
  switch (arrow) {
    case Arrow::None:
      return "stand still";
    case Arrow::Forward:
      return "forward";
    case Arrow::Backward:
      return "backward";
    case Arrow::TurnLeft:
      return "turn left";
    case Arrow::TurnRight:
      return "turn right";
    case Arrow::CurveLeft:
      return "forward, to the left";
    case Arrow::CurveRight:
      return "forward, to the right";
    case Arrow::BackLeft:
      return "backward, to the left";
    case Arrow::BackRight:
      return "backward, to the right";
    case Arrow::Lost:
      return "lost";
  }
  return "";
}

std::string metres(double m) { return fmt::format("{:.2f} m", std::abs(m)); }
std::string degrees(double rad) { return fmt::format("{:.0f} deg", rad_to_deg(std::abs(rad))); }

std::string amount_of(const Way& way) {
  if (way.along == 0.0) return way.turn == 0.0 ? "" : degrees(way.turn);
  return metres(way.along) + (way.turn == 0.0 ? "" : ", " + degrees(way.turn));
}

std::string speed_of(const Twist& speed) {
  std::string linear = metres(speed.linear) + "/s";
  std::string angular = degrees(speed.angular) + "/s";
  if (speed.linear == 0.0) return angular;
  return speed.angular == 0.0 ? linear : linear + ", " + angular;
}

}  // namespace

std::string in_words(const Instruction& instruction) {
  if (instruction.kind == Instruction::Kind::Lost) {
    return fmt::format("lost: show me a marker ({})", instruction.reason);
  }
  const Way way = way_of(instruction);
  std::string words = name_of(camera::arrow_for(way.along, way.turn));
  if (instruction.kind == Instruction::Kind::Stand) return words;
  if (instruction.kind == Instruction::Kind::Goal) words += " " + amount_of(way);
  return words + " at " + speed_of(instruction.speed);
}

camera::Sign as_sign(const Instruction& instruction) {
  if (instruction.kind == Instruction::Kind::Lost) {
    return {Arrow::Lost, "lost", "show me a marker"};
  }
  const Way way = way_of(instruction);
  const Arrow arrow = camera::arrow_for(way.along, way.turn);
  if (instruction.kind == Instruction::Kind::Stand) return {arrow, "stop", name_of(arrow)};
  if (instruction.kind == Instruction::Kind::Speed) {
    return {arrow, speed_of(instruction.speed), name_of(arrow)};
  }
  return {arrow, amount_of(way),
          fmt::format("{}, {}", name_of(arrow), speed_of(instruction.speed))};
}

}  // namespace eyebridge::hal
