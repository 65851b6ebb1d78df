#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace eyebridge::robios {

/// What a person did at a terminal.
struct TerminalEvent {
  int key = 0;     ///< Mask of the key typed (1, 2, 4, 8); 0 for a click.
  int column = 0;  ///< Of the character clicked on, from 0 at the left of the window.
  int row = 0;     ///< From 0 at its top.
  int remote =
      0;  ///< Code (IRTV_5, IRTV_OK) of a key of the remote control; 0 for none. 1 to 4 are both.

  friend bool operator==(const TerminalEvent&, const TerminalEvent&) = default;
};

/// Finds keys and mouse clicks in what a terminal sends: the characters 1 to 4, those that stand
/// for a remote control (digits, r g y b for the colours, arrows, Enter for OK, p for power), and
/// presses of the first mouse button as SGR reports (ESC [ < button ; column ; row M) or, from
/// terminals that know no better, in X10's form (ESC [ M and three bytes). Formats: XTerm Control
/// Sequences, "Mouse Tracking". Everything else is dropped: other keys, releases, the wheel,
/// motion, unknown and broken sequences, of which no byte is ever taken for a key.
///
/// Pure: any bytes, one after the other; no allocation. One thread.
class InputDecoder {
 public:
  /// Takes the next byte; an event when this byte completes one.
  std::optional<TerminalEvent> push(std::uint8_t byte);

 private:
  enum class State { Ground, Escape, Function, Control, OldMouse };

  void begin_control();
  [[nodiscard]] static std::optional<TerminalEvent> typed(std::uint8_t byte);
  std::optional<TerminalEvent> control_byte(std::uint8_t byte);
  [[nodiscard]] std::optional<TerminalEvent> sgr_click() const;

  State state_ = State::Ground;
  // Of a control sequence: whether it began with '<' and has nothing but numbers since, and these.
  bool is_sgr_ = false;
  bool is_bare_ = false;  // nothing came yet
  std::array<int, 3> numbers_{};
  std::size_t count_ = 0;  // numbers begun; more than numbers_.size() is no click
  std::array<std::uint8_t, 3> old_mouse_{};
};

}  // namespace eyebridge::robios
