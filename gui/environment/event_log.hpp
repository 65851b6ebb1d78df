#pragma once

#include <QListWidget>

#include "eyebridge/hal/environment.hpp"

namespace eyebridge::gui {

/// What happened, the newest last: the last hundred, as in EyeSim.
class EventLog final : public QListWidget {
  Q_OBJECT
 public:
  static constexpr int kLongest = 100;

  explicit EventLog(QWidget* parent);

  /// The collisions that `look` brought.
  void add(const hal::WorldLook& look);
  void add(const QString& text);
};

}  // namespace eyebridge::gui
