#pragma once

#include <QComboBox>
#include <QLineEdit>
#include <QWidget>
#include <functional>

#include "environment/place_button.hpp"
#include "eyebridge/hal/environment.hpp"

namespace eyebridge::gui {

/// Asks for one more thing in the world: which, how it behaves, and then where, which a person
/// shows by mouse.
class AddThingPanel final : public QWidget {
  Q_OBJECT
 public:
  /// `environment` is lent.
  AddThingPanel(hal::Environment& environment, QWidget* parent);

  /// Puts it at `pose`.
  void add(const Pose& pose);
  /// Down while a place is to be shown.
  [[nodiscard]] PlaceButton& place_button() { return *place_; }

  /// Told what became of a thing.
  std::function<void(const QString&)> on_answer;

 private:
  hal::Environment& environment_;
  QComboBox* thing_;
  QLineEdit* more_;
  PlaceButton* place_;
};

}  // namespace eyebridge::gui
