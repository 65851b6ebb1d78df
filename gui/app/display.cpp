#include "app/display.hpp"

#include <cstdlib>
#include <memory>
#include <string_view>

#include <xcb/xcb.h>

namespace eyebridge::gui {
namespace {

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

}  // namespace

bool display_can_be_reached(std::string& why) {
  const std::string platform = variable("QT_QPA_PLATFORM");
  if (!platform.empty() && !platform.starts_with("xcb")) return true;  // who asks for it has it
  const std::string display = variable("DISPLAY");
  if (display.empty()) {
    if (!variable("WAYLAND_DISPLAY").empty()) return true;
    why = "there is no display (DISPLAY is not set)";
    return false;
  }
  // Kept: a server whose last client leaves begins anew, and refuses Qt meanwhile (Xvfb does).
  static const std::unique_ptr<xcb_connection_t, void (*)(xcb_connection_t*)> connection(
      xcb_connect(display.c_str(), nullptr), xcb_disconnect);
  if (xcb_connection_has_error(connection.get()) == 0) return true;
  why = "the display " + display + " cannot be reached";
  return false;
}

}  // namespace eyebridge::gui
