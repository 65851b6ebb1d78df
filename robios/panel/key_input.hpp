#pragma once

#include <chrono>
#include <memory>

namespace eyebridge::robios {

/// Where a person's key presses come from.
class KeyInput {
 public:
  virtual ~KeyInput() = default;
  /// The next key as a mask (1, 2, 4, 8), waiting at most `timeout` of real time; 0 if none.
  virtual int poll(std::chrono::milliseconds timeout) = 0;
  /// False once no key can come any more: the input has ended.
  [[nodiscard]] virtual bool open() const = 0;
};

/// Keys 1 to 4 typed at a terminal, taken without Enter and without echo; other characters are
/// dropped. The terminal is switched over at the first poll() and restored when the object ends, at
/// exit, and by restore_terminal(). One at a time.
class TerminalKeys final : public KeyInput {
 public:
  /// `descriptor` is a terminal, lent for the object's life.
  explicit TerminalKeys(int descriptor);
  ~TerminalKeys() override;
  TerminalKeys(const TerminalKeys&) = delete;
  TerminalKeys& operator=(const TerminalKeys&) = delete;

  int poll(std::chrono::milliseconds timeout) override;
  [[nodiscard]] bool open() const override { return open_; }

 private:
  int descriptor_;
  bool open_ = true;
};

/// TerminalKeys on standard input if that is a terminal, else null.
std::unique_ptr<KeyInput> terminal_keys();

/// Puts the terminal back as TerminalKeys found it; nothing if it is. Async-signal-safe: for signal
/// handlers. (TerminalKeys brings its own for SIGINT, SIGTERM, SIGHUP and SIGQUIT, but leaves
/// handlers alone that the process has already.)
void restore_terminal() noexcept;

/// As restore_terminal(), for good: no TerminalKeys switches over again, even when a thread of the
/// program still waits for a key while the process ends. Any thread.
void release_terminal() noexcept;

}  // namespace eyebridge::robios
