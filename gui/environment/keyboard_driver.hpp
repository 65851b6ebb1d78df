#pragma once

#include <set>

#include "eyebridge/base/drive_goal.hpp"
#include "eyebridge/robot/robot_model.hpp"

namespace eyebridge::gui {

/// Arrow keys as a joystick: as long as they are down.
class KeyboardDriver {
 public:
  /// Whether `key`, a Qt::Key, is one of the four.
  static bool knows(int key);

  void press(int key) { down_.insert(key); }
  /// False where it was not down: who pressed it meant another robot, or nobody was driving.
  bool release(int key) { return down_.erase(key) > 0; }
  void release_all() { down_.clear(); }
  [[nodiscard]] bool any() const { return !down_.empty(); }

  /// What the keys that are down mean for a robot like `model`: half of its speed, ahead or back,
  /// and a third of its turning speed; keys that are each other's opposite mean nothing.
  [[nodiscard]] Twist twist(const robot::RobotModel& model) const;

 private:
  [[nodiscard]] double axis(int positive, int negative) const;

  std::set<int> down_;
};

}  // namespace eyebridge::gui
