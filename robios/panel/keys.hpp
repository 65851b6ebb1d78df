#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/result.hpp"
#include "key_input.hpp"
#include "key_script.hpp"

namespace eyebridge::robios {

/// What a program was given last of each kind, and when on its clock.
struct GivenKeys {
  int key = 0;  ///< Mask of one key; 0: none so far.
  Time key_at{0};
  int remote = 0;  ///< Code of the remote control; 0: none so far.
  Time remote_at{0};
  std::optional<TouchPoint> touch;
  Time touch_at{0};
};

/// The four keys, the touch screen and the remote control of one robot: from a script, a terminal,
/// a window.
///
/// A press is an event: it waits in a queue until one call has reported it. Any thread.
class Keys {
 public:
  /// Waits until a moment on the robot's clock; may return late, and runs the robot's timers.
  using WaitUntil = std::function<void(Time)>;

  /// `clock` is lent for the object's life; `script` is sorted by time; `terminal` may be null.
  Keys(Clock& clock, std::vector<ScriptedKey> script, std::unique_ptr<KeyInput> terminal);

  /// The mask of the soft key under a screen pixel, or 0 (Lcd::key_at); none until set.
  void set_touch_map(std::function<int(int x, int y)> key_at);
  /// A window that will call press() or touch() is there, or gone: as long as it is, wait() waits.
  void set_window(bool attached);

  /// A key of the window or of a test; `key` is a mask of one key, anything else is ignored.
  void press(int key);
  /// A touch at LCD pixels. On a soft key it counts as that key as well.
  void touch(int x, int y);

  /// The oldest press not reported yet (1, 2, 4 or 8), or 0. Never waits.
  int read();
  /// Waits for a press of one of the keys in `mask` and returns it; presses of other keys are
  /// dropped, presses not reported yet count. On a virtual clock time jumps to the next scripted
  /// key, and stands still while a person is waited for. OutOfRange for a mask without a key;
  /// Unsupported when no key can come any more.
  Result<int> wait(int mask, const WaitUntil& wait_until);

  /// The last touch not reported yet. Never waits.
  std::optional<TouchPoint> read_touch();
  /// As wait(), for a touch.
  Result<TouchPoint> wait_touch(const WaitUntil& wait_until);

  /// A key of the remote control of a window or of a test: its code, 1 … 255; else ignored. What is
  /// typed at the terminal counts from the program's first call about the remote control on.
  void press_remote(int code);
  /// The oldest code not reported yet, or 0. Never waits.
  int read_remote();
  /// As wait(), for a code of the remote control.
  Result<int> wait_remote(const WaitUntil& wait_until);
  /// Forgets the codes that nobody has asked for.
  void flush_remote();

  /// For people to look at.
  [[nodiscard]] GivenKeys given() const;

 private:
  enum class Wanted { Key, Touch, Remote };

  template <class Take>
  auto wait_for(Wanted wanted, const WaitUntil& wait_until, Take take)
      -> Result<typename decltype(take())::value_type>;
  void take_script();
  void take_terminal(std::chrono::milliseconds timeout);
  void add_touch(TouchPoint point);
  void begin_remote();
  void take_remote(int typed);
  std::optional<int> next_remote();
  std::optional<int> next_key(int mask);
  std::optional<TouchPoint> next_touch();

  Clock& clock_;
  mutable std::mutex mutex_;
  std::mutex terminal_mutex_;  // never taken while mutex_ is held
  std::condition_variable pressed_;
  std::vector<ScriptedKey> script_;
  std::size_t next_ = 0;  // in script_
  std::unique_ptr<KeyInput> terminal_;
  std::function<int(int, int)> key_at_;
  bool window_ = false;
  std::uint64_t inputs_ = 0;  ///< How many a window has brought.
  std::deque<int> presses_;
  std::deque<int> remote_;
  bool uses_remote_ = false;  // else letters and digits that are typed are not kept
  std::optional<TouchPoint> last_touch_;
  GivenKeys given_;
};

}  // namespace eyebridge::robios
