#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>

#include "key_script.hpp"
#include "terminal/input_decoder.hpp"

namespace eyebridge::robios {

/// One thing a person did: a key pressed, or a place touched.
struct KeyEvent {
  int key = 0;  ///< Mask of one key (1, 2, 4, 8); 0 for none.
  std::optional<TouchPoint> touch;
  int remote = 0;  ///< What the same key is on a remote control, or 0.

  friend bool operator==(const KeyEvent&, const KeyEvent&) = default;
};

/// Where a person's key presses and touches come from.
class KeyInput {
 public:
  virtual ~KeyInput() = default;
  /// The next event, waiting at most `timeout` of real time; an empty one if there is none. With a
  /// timeout of 0 an input that costs much to look at may be left alone for a millisecond.
  virtual KeyEvent poll(std::chrono::milliseconds timeout) = 0;
  /// False once nothing can come any more: the input has ended.
  [[nodiscard]] virtual bool open() const = 0;
  /// Whether touches can come, too.
  [[nodiscard]] virtual bool has_touches() const = 0;
};

/// The LCD pixel under a character of the terminal's window (column and row from 0), or nothing.
using TouchMap = std::function<std::optional<TouchPoint>(int column, int row)>;

/// Keys 1 to 4 and those of a remote control typed at a terminal, taken without Enter and without
/// echo, and clicks of the mouse; all else is dropped. The terminal is switched over at the first
/// poll(), so that programs that want no keys can read lines, and restored when the object ends, at
/// exit, and by restore_terminal(). One at a time.
class TerminalKeys final : public KeyInput {
 public:
  /// `descriptor` is a terminal, lent for the object's life. Without `touch_map` the mouse is left
  /// to the terminal.
  explicit TerminalKeys(int descriptor, TouchMap touch_map = nullptr);
  ~TerminalKeys() override;
  TerminalKeys(const TerminalKeys&) = delete;
  TerminalKeys& operator=(const TerminalKeys&) = delete;

  KeyEvent poll(std::chrono::milliseconds timeout) override;
  [[nodiscard]] bool open() const override { return open_; }
  [[nodiscard]] bool has_touches() const override { return touch_map_ != nullptr; }

 private:
  bool wait_for_input(std::chrono::milliseconds timeout);
  [[nodiscard]] KeyEvent event_of(const TerminalEvent& event) const;

  int descriptor_;
  TouchMap touch_map_;
  InputDecoder decoder_;
  std::chrono::steady_clock::time_point looked_{};  // when nothing was there
  bool open_ = true;
};

/// TerminalKeys on standard input if that is a terminal, else null.
std::unique_ptr<KeyInput> terminal_keys();

}  // namespace eyebridge::robios
