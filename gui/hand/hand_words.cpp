#include "hand/hand_words.hpp"

#include <QCoreApplication>
#include <cmath>

#include "eyebridge/base/units.hpp"

namespace eyebridge::gui {
namespace {

using Kind = hal::Instruction::Kind;

struct HandTexts {
  Q_DECLARE_TR_FUNCTIONS(eyebridge::gui::HandWindow)
};

/// Forward and left are positive.
Way way_of(double along, double turn) {
  if (along == 0.0 && turn == 0.0) return Way::Stand;
  if (turn == 0.0) return along > 0.0 ? Way::Forward : Way::Backward;
  const bool to_the_left = turn > 0.0;
  if (along == 0.0) return to_the_left ? Way::TurnLeft : Way::TurnRight;
  if (along > 0.0) return to_the_left ? Way::CurveLeft : Way::CurveRight;
  // Backward, a heading that turns left takes the robot to its right.
  return to_the_left ? Way::BackRight : Way::BackLeft;
}

QString name_of(Way way) {
  switch (way) {
    case Way::Stand:
      return HandTexts::tr("Stand still");
    case Way::Forward:
      return HandTexts::tr("Straight ahead");
    case Way::Backward:
      return HandTexts::tr("Backward");
    case Way::TurnLeft:
      return HandTexts::tr("Turn left");
    case Way::TurnRight:
      return HandTexts::tr("Turn right");
    case Way::CurveLeft:
      return HandTexts::tr("Ahead, to the left");
    case Way::CurveRight:
      return HandTexts::tr("Ahead, to the right");
    case Way::BackLeft:
      return HandTexts::tr("Backward, to the left");
    case Way::BackRight:
      return HandTexts::tr("Backward, to the right");
    case Way::Lost:
      return HandTexts::tr("Lost");
  }
  return {};
}

QString millimetres(double metres) {
  return HandTexts::tr("%1 mm").arg(m_to_mm(std::abs(metres)), 0, 'f', 0);
}
QString degrees(double radians) {
  return QString("%1°").arg(rad_to_deg(std::abs(radians)), 0, 'f', 0);
}

QString both(const QString& one, const QString& other) {
  if (one.isEmpty() || other.isEmpty()) return one + other;
  return one + ", " + other;
}

QString amount_text(double along, double turn) {
  return both(along != 0.0 ? millimetres(along) : QString(),
              turn != 0.0 ? degrees(turn) : QString());
}

QString speed_text(const Twist& speed) {
  return both(speed.linear != 0.0 ? millimetres(speed.linear) + "/s" : QString(),
              speed.angular != 0.0 ? degrees(speed.angular) + "/s" : QString());
}

}  // namespace

HandWords words_for(const hal::Instruction& instruction) {
  switch (instruction.kind) {
    case Kind::Lost:
      return {Way::Lost,
              HandTexts::tr("Show me a marker"),
              QString::fromStdString(instruction.reason),
              {}};
    case Kind::Stand:
      return {Way::Stand, name_of(Way::Stand), {}, {}};
    case Kind::Speed: {
      const Way way = way_of(instruction.speed.linear, instruction.speed.angular);
      if (way == Way::Stand) return {way, name_of(way), {}, {}};
      return {way, speed_text(instruction.speed), name_of(way), {}};
    }
    case Kind::Goal: {
      const Way way = way_of(instruction.distance, instruction.angle);
      if (way == Way::Stand) return {way, name_of(way), {}, {}};
      return {way, amount_text(instruction.distance, instruction.angle), name_of(way),
              speed_text(instruction.speed)};
    }
  }
  return {};
}

}  // namespace eyebridge::gui
