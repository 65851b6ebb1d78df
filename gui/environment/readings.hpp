#pragma once

#include <QTableWidget>

#include "plan/mirror.hpp"

namespace eyebridge::gui {

/// What one robot is doing and what its sensors see, without error: a row each.
class Readings final : public QTableWidget {
  Q_OBJECT
 public:
  explicit Readings(QWidget* parent);

  /// Of the robot with this index, or of none.
  void show_robot(const hal::WorldLook& look, Mirror& mirror, std::optional<std::size_t> robot);

 private:
  void put(const QString& name, const QString& value);
  void put_sensors(const hal::RobotLook& robot, Mirror& mirror, std::size_t index);

  int next_ = 0;  ///< The row that put() fills.
};

}  // namespace eyebridge::gui
