#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "eyebridge/base/unique_fd.hpp"
#include "terminal/colours.hpp"
#include "terminal/lcd_view.hpp"

namespace eyebridge::robios {

/// The LCD in the lowest rows of a terminal, ten times a second of wall time at most, by a thread
/// of its own: the robot's clock may stand still while a person looks.
///
/// What the program and its children write to the terminal goes to the rows above, where it
/// scrolls (into the terminal's history, as ever): the rows below are kept out of it by a scrolling
/// region, and each picture leaves the cursor where the program had it. Only what changed is sent,
/// in one write, and never more than kMostBytesPerSecond for long. Nothing is drawn while the
/// process is in the background. A window of another size is cleared and drawn anew. At the end the
/// last picture stays, and the terminal goes on below it.
class TerminalPanel {
 public:
  static constexpr int kMostBytesPerSecond = 64'000;

  /// `terminal` is open for reading and writing; `screen` is lent for the object's life.
  TerminalPanel(UniqueFd terminal, const Screen& screen, ColourDepth depth);
  ~TerminalPanel();
  TerminalPanel(const TerminalPanel&) = delete;
  TerminalPanel& operator=(const TerminalPanel&) = delete;

  /// Begins to draw. Call it when the process has installed its handlers of signals: those that
  /// restore the terminal are set only for signals that nobody handles.
  void start();
  /// Draws the last picture and ends the thread. What is left to do is release_terminal()'s.
  /// Idempotent.
  void stop() noexcept;
  /// Draws what has changed, if anything. How many bytes were sent; 0 too when the terminal is
  /// gone.
  std::size_t draw();

  /// The LCD pixel under a character of the window, as drawn last. Any thread.
  [[nodiscard]] std::optional<TouchPoint> pixel_at(int column, int row) const;
  /// The terminal, lent.
  [[nodiscard]] int descriptor() const { return terminal_.get(); }

 private:
  struct WindowSize {
    int columns = 0;
    int rows = 0;
    friend bool operator==(const WindowSize&, const WindowSize&) = default;
  };

  void run();
  [[nodiscard]] WindowSize window_size() const;
  [[nodiscard]] std::string opening(const LcdView& view) const;
  bool send(const std::string& text);

  const UniqueFd terminal_;
  const Screen& screen_;
  const ColourDepth depth_;

  std::mutex drawing_;     // one picture at a time
  bool attached_ = false;  // the region is set, and no other program had the terminal since
  bool gone_ = false;
  int interruptions_ = 0;
  WindowSize window_;
  std::uint64_t revision_ = 0;
  CellGrid shown_;

  mutable std::mutex mutex_;  // the rest
  LcdView view_;
  std::condition_variable changed_;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace eyebridge::robios
