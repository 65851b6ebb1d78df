#pragma once

#include <QKeySequence>
#include <QPushButton>
#include <QWidget>
#include <span>
#include <vector>

#include "keys.hpp"

namespace eyebridge::gui {

/// A key of the infrared remote control.
struct RemoteButton {
  const char* label;     ///< On it.
  const char* name;      ///< As in eyebot.h, without IRTV_.
  char code;             ///< What the program gets.
  const char* shortcut;  ///< Of the keyboard.
  int row;               ///< Where it is on the control.
  int column;
  const char* colour;  ///< Of the spot on it; null for none.
};

/// All of them, from the top left.
std::span<const RemoteButton> remote_buttons();

/// The infrared remote control of a robot: a button sends its code, which IRTVGet and IRTVRead give
/// the program as those of the key script.
class RemoteControl final : public QWidget {
  Q_OBJECT

 public:
  /// `keys` is lent.
  RemoteControl(robios::Keys& keys, QWidget* parent);

  void press(char code) { keys_.press_remote(code); }
  /// That sends `code`, which is one of remote_buttons().
  [[nodiscard]] QPushButton& button(char code);

 private:
  robios::Keys& keys_;
  std::vector<QPushButton*> buttons_;
};

}  // namespace eyebridge::gui
