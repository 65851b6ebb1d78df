#include "panel/inspector_words.hpp"

#include <QCoreApplication>

#include "eyebridge/base/units.hpp"
#include "eyebridge/hal/drive.hpp"

namespace eyebridge::gui {
namespace {

using hal::Quantity;

struct InspectorWords {
  Q_DECLARE_TR_FUNCTIONS(eyebridge::gui::Inspector)
};

QString number(double value, int digits) {
  const QString text = QString::number(value, 'f', digits);
  return text.startsWith('-') && text.toDouble() == 0.0 ? text.mid(1) : text;  // no "-0"
}

QString progress_text(double value) {
  switch (static_cast<hal::DriveProgress>(static_cast<int>(value))) {
    case hal::DriveProgress::Done:
      return InspectorWords::tr("done");
    case hal::DriveProgress::Driving:
      return InspectorWords::tr("driving");
    case hal::DriveProgress::Failed:
      return InspectorWords::tr("given up");
  }
  return {};
}

QString yes_no(double value) {
  return value != 0.0 ? InspectorWords::tr("yes") : InspectorWords::tr("no");
}

}  // namespace

std::vector<ShownPart> parts_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::Pose:
      return {{InspectorWords::tr("x"), "mm"},
              {InspectorWords::tr("y"), "mm"},
              {InspectorWords::tr("heading"), "°"}};
    case Quantity::Speed:
      return {{InspectorWords::tr("speed"), "mm/s"}, {InspectorWords::tr("turning"), "°/s"}};
    case Quantity::WantedSpeed:
      return {{InspectorWords::tr("speed set"), "mm/s"},
              {InspectorWords::tr("turning set"), "°/s"}};
    case Quantity::Goal:
      return {{InspectorWords::tr("goal: way"), "mm"},
              {InspectorWords::tr("goal: angle"), "°"},
              {InspectorWords::tr("goal: speed"), ""}};
    case Quantity::Progress:
      return {{InspectorWords::tr("movement"), ""},
              {InspectorWords::tr("to go"), "mm"},
              {InspectorWords::tr("left stalled"), ""},
              {InspectorWords::tr("right stalled"), ""}};
    case Quantity::Duty:
      return {{InspectorWords::tr("power"), "%"}};
    case Quantity::TickRate:
      return {{InspectorWords::tr("speed set"), "ticks/s"}};
    case Quantity::Gains:
      return {{"P", ""}, {"I", ""}, {"D", ""}};
    case Quantity::Ticks:
      return {{InspectorWords::tr("count"), "ticks"}};
    case Quantity::Position:
      return {{InspectorWords::tr("position"), "/ 255"}};
    case Quantity::Distance:
      return {{InspectorWords::tr("distance"), "mm"}};
    case Quantity::Raw:
      return {{InspectorWords::tr("raw"), ""}};
    case Quantity::Switch:
      return {{InspectorWords::tr("state"), ""}};
    case Quantity::Nearest:
      return {{InspectorWords::tr("nearest"), "mm"}, {InspectorWords::tr("its bearing"), "°"}};
    case Quantity::Heading:
      return {{InspectorWords::tr("heading"), "°"}};
    case Quantity::TurnRate:
      return {{InspectorWords::tr("turning"), "°/s"}};
    case Quantity::Acceleration:
      return {{InspectorWords::tr("forward"), "mm/s²"}, {InspectorWords::tr("left"), "mm/s²"}};
    case Quantity::Level:
      return {{InspectorWords::tr("read"), ""}};
    case Quantity::WrittenLevel:
      return {{InspectorWords::tr("written"), ""}};
    case Quantity::Lines:
      return {{InspectorWords::tr("lines 16 … 1"), ""}};
    case Quantity::Count:
      return {{InspectorWords::tr("value"), "/ 4095"}};
    case Quantity::Voltage:
      return {{InspectorWords::tr("supply"), "V"}};
    case Quantity::RemoteCode:
      return {{InspectorWords::tr("code"), ""}};
  }
  return {};
}

QString part_text(Quantity quantity, std::size_t part, const hal::NoteCell::Values& values) {
  const double value = values.at(part);
  switch (quantity) {
    case Quantity::Pose:
      return part == 2 ? number(rad_to_deg(value), 1) : number(m_to_mm(value), 0);
    case Quantity::Speed:
    case Quantity::WantedSpeed:
    case Quantity::Nearest:
      return part == 1 ? number(rad_to_deg(value), 1) : number(m_to_mm(value), 0);
    case Quantity::Goal: {
      if (part == 0) return number(m_to_mm(value), 0);
      if (part == 1) return number(rad_to_deg(value), 1);
      // Of a turn on the spot it is an angular one.
      return values[0] != 0.0 ? InspectorWords::tr("%1 mm/s").arg(number(m_to_mm(value), 0))
                              : InspectorWords::tr("%1 °/s").arg(number(rad_to_deg(value), 0));
    }
    case Quantity::Progress:
      if (part == 0) return progress_text(value);
      return part == 1 ? number(m_to_mm(value), 0) : yes_no(value);
    case Quantity::Duty:
      return number(100.0 * value, 0);
    case Quantity::Position:
      return number(255.0 * value, 0);
    case Quantity::Distance:
      return number(m_to_mm(value), 0);
    case Quantity::Heading:
    case Quantity::TurnRate:
      return number(rad_to_deg(value), 1);
    case Quantity::Acceleration:
      return number(m_to_mm(value), 0);
    case Quantity::Switch:
      return yes_no(value);
    case Quantity::Lines:
      return QString::number(static_cast<int>(value), 2).rightJustified(16, '0');
    case Quantity::Voltage:
      return number(value, 2);
    case Quantity::TickRate:
    case Quantity::Gains:
    case Quantity::Ticks:
    case Quantity::Raw:
    case Quantity::Level:
    case Quantity::WrittenLevel:
    case Quantity::Count:
    case Quantity::RemoteCode:
      return number(value, 0);
  }
  return {};
}

QString title_of(const std::string& kind) {
  if (kind == "drive") return InspectorWords::tr("Drive");
  if (kind == "motor") return InspectorWords::tr("Motors");
  if (kind == "encoder") return InspectorWords::tr("Encoders");
  if (kind == "servo") return InspectorWords::tr("Servos");
  if (kind == "psd") return InspectorWords::tr("Distance sensors (PSD)");
  if (kind == "proximity") return InspectorWords::tr("Infrared switches");
  if (kind == "bumper") return InspectorWords::tr("Bumpers");
  if (kind == "lidar") return InspectorWords::tr("LIDAR");
  if (kind == "tof") return InspectorWords::tr("Time-of-flight matrices");
  if (kind == "compass") return InspectorWords::tr("Compass");
  if (kind == "gyroscope") return InspectorWords::tr("Gyroscope");
  if (kind == "accelerometer") return InspectorWords::tr("Accelerometer");
  if (kind == "digital") return InspectorWords::tr("Digital lines");
  if (kind == "analog") return InspectorWords::tr("Analog inputs");
  if (kind == "remote") return InspectorWords::tr("Infrared receiver");
  return QString::fromStdString(kind);
}

QString name_of(const hal::NotedValue& value) {
  const bool is_only = value.kind == "drive" || value.kind == "lidar" || value.kind == "compass" ||
                       value.kind == "gyroscope" || value.kind == "accelerometer" ||
                       value.kind == "remote" || value.quantity == Quantity::Lines ||
                       value.quantity == Quantity::Voltage;
  if (is_only) return {};
  if (value.kind == "digital") return InspectorWords::tr("line %1").arg(value.id);
  if (value.kind == "analog") return InspectorWords::tr("channel %1").arg(value.id);
  if (value.name.empty()) return QString::number(value.id);
  return QString("%1 (%2)").arg(QString::fromStdString(value.name)).arg(value.id);
}

bool is_main(const hal::NotedValue& value) {
  switch (value.quantity) {
    case Quantity::Goal:
    case Quantity::Progress:
    case Quantity::TickRate:
    case Quantity::Gains:
    case Quantity::Raw:
    case Quantity::WrittenLevel:
    case Quantity::Lines:
      return false;
    default:
      return true;
  }
}

}  // namespace eyebridge::gui
