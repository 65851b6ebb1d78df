#pragma once

#include <QWidget>
#include <random>
#include <vector>

namespace eyebridge::gui::testing {

/// Somebody who clicks and types at random, in all windows at once.
class Monkey {
 public:
  /// The windows are lent.
  Monkey(std::vector<QWidget*> windows, unsigned seed);

  /// One thing: a click, a drag, a turn of the wheel, a key, or an entry of a menu.
  void act();
  /// Closes the dialog that is open, if one is.
  void answer_dialog();
  int below(int bound);

 private:
  [[nodiscard]] QWidget& any_widget();
  [[nodiscard]] Qt::KeyboardModifiers any_modifiers();
  [[nodiscard]] Qt::Key any_key();
  void drag(QWidget& widget, Qt::MouseButton button, Qt::KeyboardModifiers keys, QPoint place);
  void turn_wheel(QWidget& widget, Qt::KeyboardModifiers keys, QPoint place);
  void choose_from_menu();

  const std::vector<QWidget*> windows_;
  std::mt19937 random_;
};

}  // namespace eyebridge::gui::testing
