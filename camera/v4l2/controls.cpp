#include "v4l2/controls.hpp"

#include <charconv>
#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

#include <linux/videodev2.h>

#include "eyebridge/base/text.hpp"
#include "v4l2/open_errors.hpp"

namespace eyebridge::camera {
namespace {

using Control = v4l2_query_ext_ctrl;

bool is_of_one_number(const Control& control) {
  switch (control.type) {
    case V4L2_CTRL_TYPE_INTEGER:
    case V4L2_CTRL_TYPE_BOOLEAN:
    case V4L2_CTRL_TYPE_MENU:
    case V4L2_CTRL_TYPE_BUTTON:
    case V4L2_CTRL_TYPE_INTEGER64:
    case V4L2_CTRL_TYPE_BITMASK:
    case V4L2_CTRL_TYPE_INTEGER_MENU:
      return true;
    default:
      return false;
  }
}

bool is_choice(const Control& control) {
  return control.type == V4L2_CTRL_TYPE_BOOLEAN || control.type == V4L2_CTRL_TYPE_MENU ||
         control.type == V4L2_CTRL_TYPE_INTEGER_MENU;
}

std::string key_of(const Control& control) {
  return control_key({control.name, strnlen(control.name, sizeof control.name)});
}

std::vector<Control> controls_of(const VideoHandle& camera) {
  constexpr int kMost = 1024;
  std::vector<Control> out;
  Control control{};
  for (int i = 0; i < kMost; ++i) {
    const std::uint32_t last = control.id;
    control = {};
    control.id = last | V4L2_CTRL_FLAG_NEXT_CTRL;
    if (camera.control(VIDIOC_QUERY_EXT_CTRL, control) < 0) break;
    const bool is_there = (control.flags & V4L2_CTRL_FLAG_DISABLED) == 0;
    if (is_there && is_of_one_number(control)) out.push_back(control);
  }
  return out;
}

/// The items of a menu: "0 manual_mode".
std::vector<std::pair<std::int64_t, std::string>> items_of(const VideoHandle& camera,
                                                           const Control& control) {
  std::vector<std::pair<std::int64_t, std::string>> out;
  const bool is_number = control.type == V4L2_CTRL_TYPE_INTEGER_MENU;
  for (std::int64_t index = control.minimum; index <= control.maximum; ++index) {
    v4l2_querymenu item{};
    item.id = control.id;
    item.index = static_cast<std::uint32_t>(index);
    if (camera.control(VIDIOC_QUERYMENU, item) < 0) continue;
    const auto* name = reinterpret_cast<const char*>(item.name);
    out.emplace_back(index, is_number ? std::to_string(item.value)
                                      : control_key({name, strnlen(name, sizeof item.name)}));
  }
  return out;
}

std::optional<std::int64_t> whole_number(std::string_view text) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

[[noreturn]] void refuse(const VideoHandle& camera, const std::string& key,
                         const std::string& value, const std::string& expected) {
  throw camera_error(camera.path(),
                     "found " + key + "=" + in_quotes(value) + ", expected " + expected);
}

std::int64_t menu_value(const VideoHandle& camera, const Control& control, const std::string& key,
                        const std::string& text) {
  std::string expected;
  const std::optional<std::int64_t> number = whole_number(text);
  for (const auto& [index, name] : items_of(camera, control)) {
    if (number == index || name == text) return index;
    expected += (expected.empty() ? "one of " : ", ") + std::to_string(index) + " (" + name + ")";
  }
  refuse(camera, key, text, expected);
}

std::int64_t value_of(const VideoHandle& camera, const Control& control, const std::string& key,
                      const std::string& text) {
  if (control.type == V4L2_CTRL_TYPE_MENU || control.type == V4L2_CTRL_TYPE_INTEGER_MENU) {
    return menu_value(camera, control, key, text);
  }
  if (control.type == V4L2_CTRL_TYPE_BOOLEAN) {
    if (text == "on" || text == "1") return 1;
    if (text == "off" || text == "0") return 0;
    refuse(camera, key, text, "on or off");
  }
  if (control.type == V4L2_CTRL_TYPE_BUTTON) return 1;
  const bool is_mask = control.type == V4L2_CTRL_TYPE_BITMASK;
  const std::int64_t least = is_mask ? 0 : control.minimum;
  const std::int64_t most = is_mask ? static_cast<std::uint32_t>(control.maximum) : control.maximum;
  const std::optional<std::int64_t> number = whole_number(text);
  if (!number || *number < least || *number > most) {
    const std::string step = control.step > 1 ? " in steps of " + std::to_string(control.step) : "";
    refuse(camera, key, text,
           "a whole number from " + std::to_string(least) + " to " + std::to_string(most) + step);
  }
  return *number;
}

void set_control(const VideoHandle& camera, const Control& control, const std::string& key,
                 const std::string& text) {
  if ((control.flags & V4L2_CTRL_FLAG_READ_ONLY) != 0) {
    throw camera_error(camera.path(), key + " can only be read");
  }
  v4l2_ext_control one{};
  one.id = control.id;
  const std::int64_t value = value_of(camera, control, key, text);
  if (control.type == V4L2_CTRL_TYPE_INTEGER64) {
    one.value64 = value;
  } else {
    one.value = static_cast<std::int32_t>(value);
  }
  v4l2_ext_controls all{};
  all.which = V4L2_CTRL_WHICH_CUR_VAL;
  all.count = 1;
  all.controls = &one;
  if (const int result = camera.control(VIDIOC_S_EXT_CTRLS, all); result < 0) {
    const bool is_off = (control.flags & V4L2_CTRL_FLAG_INACTIVE) != 0;
    throw call_error(camera.path(),
                     "setting " + key + "=" + text +
                         (is_off ? " (the camera controls it by itself now: switch that off)" : ""),
                     -result);
  }
}

}  // namespace

std::string control_key(std::string_view name) {
  std::string out;
  for (const char c : name) {
    const bool is_capital = c >= 'A' && c <= 'Z';
    if (is_capital || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) {
      out += is_capital ? static_cast<char>(c - 'A' + 'a') : c;
    } else if (!out.empty() && out.back() != '_') {
      out += '_';
    }
  }
  if (!out.empty() && out.back() == '_') out.pop_back();
  return out;
}

void set_controls(const VideoHandle& camera,
                  const std::map<std::string, std::string, std::less<>>& values) {
  if (values.empty()) return;
  const std::vector<Control> controls = controls_of(camera);
  std::map<std::string, const Control*, std::less<>> by_key;
  for (const Control& control : controls) by_key.emplace(key_of(control), &control);
  for (const auto& [key, value] : values) {
    if (by_key.contains(key)) continue;
    std::string known;
    for (const auto& [name, control] : by_key) known += ", " + name;
    throw camera_error(camera.path(), "it has no control " + in_quotes(key) +
                                          ", expected one of size, fps, format" + known);
  }
  for (const bool choices : {true, false}) {
    for (const auto& [key, value] : values) {
      const Control& control = *by_key.find(key)->second;
      if (is_choice(control) == choices) set_control(camera, control, key, value);
    }
  }
}

}  // namespace eyebridge::camera
