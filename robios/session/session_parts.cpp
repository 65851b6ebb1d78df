#include "session_parts.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "eyebridge/hal/url.hpp"
#include "terminal/terminal_panel.hpp"

namespace eyebridge::robios {

std::string name_among_several(const hal::Config& config) {
  const hal::ConfigValue& value = config.value("hal");
  const hal::BackendUrl url = hal::parse_backend_url(value.text, value.where);
  const auto robot = url.options.find("robot");
  return url.scheme == "remote" && robot != url.options.end() ? "robot " + robot->second : "";
}

std::string text_of(const Screen& screen) {
  std::string text;
  for (const std::string& row : screen.text_rows()) text += row + '\n';
  for (std::string label : screen.menu_labels()) {
    std::ranges::replace(label, '\n', '/');
    text += '[' + label + ']';
  }
  return text + '\n';
}

std::unique_ptr<Keys> make_keys(const hal::Config& config, int robot, Clock& clock, Screen& screen,
                                std::unique_ptr<KeyInput> input) {
  auto script = hal::from_setting(config, "keys", parse_key_script);
  std::erase_if(script,
                [robot](const ScriptedKey& key) { return key.robot != 0 && key.robot != robot; });
  auto keys = std::make_unique<Keys>(clock, std::move(script), std::move(input));
  keys->set_touch_map([&screen](int x, int y) { return screen.key_at(x, y); });
  return keys;
}

std::unique_ptr<KeyInput> person_at(const TerminalPanel* panel) {
  if (panel == nullptr) return terminal_keys();
  return std::make_unique<TerminalKeys>(
      panel->descriptor(), [panel](int column, int row) { return panel->pixel_at(column, row); });
}

}  // namespace eyebridge::robios
