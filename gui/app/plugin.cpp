// What the session loads (robios/windows/open_windows.cpp).

#include <string>
#include <utility>

#include "app/display.hpp"
#include "app/gui_windows.hpp"

extern "C" __attribute__((visibility("default"))) eyebridge::robios::Windows*
eyebridge_open_windows(int version, eyebridge::robios::WindowsStart start, std::string& why) {
  using namespace eyebridge;
  if (version != robios::kWindowsVersion) {
    why = "the plug-in is of another version; expected that of this EyeBridge";
    return nullptr;
  }
  if (!gui::display_can_be_reached(why)) return nullptr;
  // Never destroyed: whatever runs at the end of the process may still ask for it.
  return new gui::GuiWindows(std::move(start));
}
