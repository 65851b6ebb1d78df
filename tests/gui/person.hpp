#pragma once

#include <QImage>
#include <QPoint>
#include <QRect>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <xcb/xcb.h>

namespace eyebridge::gui::testing {

/// Somebody at the display, who has mouse and keyboard and sees what there is: the windows of other
/// processes, too. What he waits for comes within half a minute, or the test fails.
class Person {
 public:
  /// At the display that DISPLAY names, or at another.
  explicit Person(const char* display = nullptr);

  /// Waits for a window whose title has this in it.
  xcb_window_t window(const std::string& title);
  /// Returns when there is none any more.
  void wait_until_gone(const std::string& title);
  [[nodiscard]] std::vector<std::string> titles();
  /// Presses a key in the window, by its symbol of keysymdef.h.
  void press(xcb_window_t window, std::uint32_t symbol);
  /// Types a character into the window.
  void type(xcb_window_t window, char character);
  /// The same with Alt.
  void type_alt(xcb_window_t window, char character);
  /// The same with Control.
  void type_control(xcb_window_t window, char character);
  /// Clicks there, pixels from the window's upper left corner.
  void click(xcb_window_t window, QPoint place);
  /// As by the cross in the frame, which a window manager would draw.
  void close(xcb_window_t window);
  /// Where it is on the screen.
  [[nodiscard]] QRect place(xcb_window_t window);
  [[nodiscard]] QImage picture(xcb_window_t window);

 private:
  struct Named {
    xcb_window_t window;
    std::string title;
  };
  [[nodiscard]] std::vector<Named> windows();
  [[nodiscard]] std::optional<xcb_window_t> find(const std::string& title);
  [[nodiscard]] xcb_atom_t atom(const char* name);
  [[nodiscard]] std::string text_of(xcb_window_t window, const char* property);
  /// The key that gives this symbol; throws where there is none.
  [[nodiscard]] std::uint8_t key_of(std::uint32_t symbol);
  void type_with(std::uint32_t modifier, xcb_window_t window, char character);
  void fake(std::uint8_t type, std::uint8_t detail, QPoint place = {});

  std::unique_ptr<xcb_connection_t, void (*)(xcb_connection_t*)> connection_;
  xcb_window_t root_;
};

}  // namespace eyebridge::gui::testing
