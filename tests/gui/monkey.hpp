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
  /// Lets go of what an act waits for: text that is dragged waits for a real mouse's button, a menu
  /// for an answer. Does nothing between acts.
  void let_go();
  /// Closes the dialog that is open, if one is.
  void close_dialog();
  int below(int bound);

 private:
  void act_now();
  [[nodiscard]] QWidget& any_widget();
  [[nodiscard]] Qt::KeyboardModifiers any_modifiers();
  [[nodiscard]] Qt::Key any_key();
  void drag(QWidget& widget, Qt::MouseButton button, Qt::KeyboardModifiers keys, QPoint place);
  void turn_wheel(QWidget& widget, Qt::KeyboardModifiers keys, QPoint place);
  void choose_from_menu();

  const std::vector<QWidget*> windows_;
  std::mt19937 random_;
  bool acts_ = false;
};

}  // namespace eyebridge::gui::testing
