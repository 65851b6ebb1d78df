#include "hand/hand_words.hpp"

#include <QCoreApplication>
#include <cmath>

#include "eyebridge/base/units.hpp"

namespace eyebridge::gui {
namespace {

using camera::Arrow;
using Kind = hal::Instruction::Kind;

struct HandTexts {
  Q_DECLARE_TR_FUNCTIONS(eyebridge::gui::HandWindow)
};

QString name_of(Arrow arrow) {
  switch (arrow) {
    case Arrow::None:
      return HandTexts::tr("Stand still");
    case Arrow::Forward:
      return HandTexts::tr("Straight ahead");
    case Arrow::Backward:
      return HandTexts::tr("Backward");
    case Arrow::TurnLeft:
      return HandTexts::tr("Turn left");
    case Arrow::TurnRight:
      return HandTexts::tr("Turn right");
    case Arrow::CurveLeft:
      return HandTexts::tr("Ahead, to the left");
    case Arrow::CurveRight:
      return HandTexts::tr("Ahead, to the right");
    case Arrow::BackLeft:
      return HandTexts::tr("Backward, to the left");
    case Arrow::BackRight:
      return HandTexts::tr("Backward, to the right");
    case Arrow::Lost:
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
      return {Arrow::Lost,
              HandTexts::tr("Show me a marker"),
              QString::fromStdString(instruction.reason),
              {}};
    case Kind::Stand:
      return {Arrow::None, name_of(Arrow::None), {}, {}};
    case Kind::Speed: {
      const Arrow arrow = camera::arrow_for(instruction.speed.linear, instruction.speed.angular);
      if (arrow == Arrow::None) return {arrow, name_of(arrow), {}, {}};
      return {arrow, speed_text(instruction.speed), name_of(arrow), {}};
    }
    case Kind::Goal: {
      const Arrow arrow = camera::arrow_for(instruction.distance, instruction.angle);
      if (arrow == Arrow::None) return {arrow, name_of(arrow), {}, {}};
      return {arrow, amount_text(instruction.distance, instruction.angle), name_of(arrow),
              speed_text(instruction.speed)};
    }
  }
  return {};
}

}  // namespace eyebridge::gui
