#include "terminal/terminal_panel.hpp"

#include <cerrno>
#include <chrono>
#include <string>

#include <fmt/format.h>
#include <pthread.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "eyebridge/base/deaf_thread.hpp"
#include "terminal/cell_writer.hpp"
#include "terminal/terminal_mode.hpp"

namespace eyebridge::robios {
namespace {

constexpr std::chrono::milliseconds kPeriod{100};
// What a terminal is taken for that does not tell.
constexpr int kUsualColumns = 80;
constexpr int kUsualRows = 24;

// ECMA-48 and DEC: cursor and attributes saved and restored, one line down, at the end scrolling.
constexpr char kSave[] = "\x1b\x37";
constexpr char kRestore[] = "\x1b\x38";
constexpr char kDown[] = "\x1b\x44";

}  // namespace

TerminalPanel::TerminalPanel(UniqueFd terminal, const Screen& screen, ColourDepth depth)
    : terminal_(std::move(terminal)), screen_(screen), depth_(depth) {}

TerminalPanel::~TerminalPanel() { stop(); }

void TerminalPanel::start() {
  draw();
  thread_ = deaf_thread([this] { run(); });
}

void TerminalPanel::run() {
  pthread_setname_np(pthread_self(), "eb:panel");
  std::unique_lock lock(mutex_);
  while (!stopping_) {
    lock.unlock();
    const std::size_t sent = draw();
    lock.lock();
    const std::chrono::milliseconds busy(1000 * sent / kMostBytesPerSecond);
    changed_.wait_for(lock, std::max(kPeriod, busy), [this] { return stopping_; });
  }
}

void TerminalPanel::stop() noexcept {
  {
    const std::lock_guard lock(mutex_);
    if (stopping_) return;
    stopping_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
  try {
    draw();
  } catch (const std::exception&) {  // out of memory: the picture before stays
  }
}

TerminalPanel::WindowSize TerminalPanel::window_size() const {
  winsize size{};
  if (ioctl(terminal_.get(), TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0) {
    return {kUsualColumns, kUsualRows};
  }
  return {size.ws_col, size.ws_row};
}

std::size_t TerminalPanel::draw() {
  const std::lock_guard drawing(drawing_);
  if (gone_) return 0;
  const bool background = in_background(terminal_.get());
  if (background || interruptions_ != terminal_interruptions()) {
    interruptions_ = terminal_interruptions();
    attached_ = false;
  }
  if (background) return 0;
  const WindowSize window = window_size();
  const std::uint64_t revision = screen_.revision();
  if (attached_ && window == window_ && revision == revision_) return 0;

  const ScreenShot shot = screen_.shot();
  const LcdView view = view_of(shot, window.columns, window.rows);
  std::string text;
  if (!attached_ || window != window_ || view.columns != shown_.columns ||
      view.rows != shown_.rows) {
    text = opening(view);
    shown_ = {};
  }
  CellGrid grid = cells_of(shot, view);
  const std::string changes = changed_cells(shown_, grid, view.top, depth_);
  if (!changes.empty()) text += kSave + changes + kRestore;
  {
    const std::lock_guard lock(mutex_);
    view_ = view;
  }
  if (!text.empty() && !send(text)) return 0;
  attached_ = true;
  window_ = window;
  revision_ = revision;
  shown_ = std::move(grid);
  return text.size();
}

std::string TerminalPanel::opening(const LcdView& view) const {
  if (view.rows == 0) return attached_ ? "\x1b[0m\x1b[r\x1b[2J\x1b[H" : "";
  const std::string region = fmt::format("\x1b[1;{}r", view.top);
  if (attached_) {
    // What a terminal did to its rows when its size changed is anybody's guess.
    return fmt::format("\x1b[0m\x1b[r\x1b[2J{}\x1b[{};1H", region, view.top);
  }
  // Room below the cursor, wherever it is, without moving it in its line.
  std::string text;
  for (int row = 0; row < view.rows; ++row) text += kDown;
  return text + fmt::format("\x1b[{}A", view.rows) + kSave + region + kRestore;
}

bool TerminalPanel::send(const std::string& text) {
  if (!switch_to_panel(terminal_.get())) return false;
  std::size_t sent = 0;
  while (sent < text.size()) {
    const ssize_t count = write(terminal_.get(), text.data() + sent, text.size() - sent);
    if (count > 0) {
      sent += static_cast<std::size_t>(count);
    } else if (count < 0 && errno != EINTR) {
      gone_ = true;
      return false;
    }
  }
  return true;
}

std::optional<TouchPoint> TerminalPanel::pixel_at(int column, int row) const {
  const std::lock_guard lock(mutex_);
  return pixel_under(view_, column, row);
}

}  // namespace eyebridge::robios
