#include "person.hpp"

#include <QTest>
#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include <xcb/xtest.h>

namespace eyebridge::gui::testing {
namespace {

constexpr int kPatience_ms = 30'000;

template <class Reply>
std::unique_ptr<Reply, void (*)(void*)> owned(Reply* reply) {
  return {reply, std::free};
}

}  // namespace

Person::Person(const char* display)
    : connection_(xcb_connect(display, nullptr), xcb_disconnect),
      root_(xcb_setup_roots_iterator(xcb_get_setup(connection_.get())).data->root) {}

xcb_atom_t Person::atom(const char* name) {
  const auto length = static_cast<std::uint16_t>(std::char_traits<char>::length(name));
  const auto reply = owned(xcb_intern_atom_reply(
      connection_.get(), xcb_intern_atom(connection_.get(), 0, length, name), nullptr));
  return reply->atom;
}

std::string Person::text_of(xcb_window_t window, const char* property) {
  const auto cookie = xcb_get_property(connection_.get(), 0, window, atom(property),
                                       XCB_GET_PROPERTY_TYPE_ANY, 0, 1024);
  const auto reply = owned(xcb_get_property_reply(connection_.get(), cookie, nullptr));
  if (!reply) return "";  // it is gone
  return {static_cast<const char*>(xcb_get_property_value(reply.get())),
          static_cast<std::size_t>(xcb_get_property_value_length(reply.get()))};
}

std::vector<Person::Named> Person::windows() {
  std::vector<Named> out;
  const auto tree = owned(
      xcb_query_tree_reply(connection_.get(), xcb_query_tree(connection_.get(), root_), nullptr));
  const xcb_window_t* const all = xcb_query_tree_children(tree.get());
  for (int i = 0; i < xcb_query_tree_children_length(tree.get()); ++i) {
    const auto cookie = xcb_get_window_attributes(connection_.get(), all[i]);
    const auto facts = owned(xcb_get_window_attributes_reply(connection_.get(), cookie, nullptr));
    if (facts && facts->map_state == XCB_MAP_STATE_VIEWABLE) {
      out.push_back({all[i], text_of(all[i], "_NET_WM_NAME")});
    }
  }
  return out;
}

std::vector<std::string> Person::titles() {
  std::vector<std::string> out;
  for (const Named& window : windows()) out.push_back(window.title);
  return out;
}

std::optional<xcb_window_t> Person::find(const std::string& title) {
  for (const Named& window : windows()) {
    if (window.title.find(title) != std::string::npos) return window.window;
  }
  return {};
}

xcb_window_t Person::window(const std::string& title) {
  std::optional<xcb_window_t> found;
  if (!QTest::qWaitFor([&] { return (found = find(title)).has_value(); }, kPatience_ms)) {
    throw std::runtime_error("no window '" + title + "'");
  }
  return *found;
}

void Person::wait_until_gone(const std::string& title) {
  if (!QTest::qWaitFor([&] { return !find(title); }, kPatience_ms)) {
    throw std::runtime_error("the window '" + title + "' stays");
  }
}

void Person::fake(std::uint8_t type, std::uint8_t detail, QPoint place) {
  xcb_test_fake_input(connection_.get(), type, detail, XCB_CURRENT_TIME, root_,
                      static_cast<std::int16_t>(place.x()), static_cast<std::int16_t>(place.y()),
                      0);
  xcb_flush(connection_.get());
}

std::uint8_t Person::key_of(std::uint32_t symbol) {
  const xcb_setup_t* const setup = xcb_get_setup(connection_.get());
  const auto count = static_cast<std::uint8_t>(setup->max_keycode - setup->min_keycode + 1);
  const auto cookie = xcb_get_keyboard_mapping(connection_.get(), setup->min_keycode, count);
  const auto map = owned(xcb_get_keyboard_mapping_reply(connection_.get(), cookie, nullptr));
  const xcb_keysym_t* const symbols = xcb_get_keyboard_mapping_keysyms(map.get());
  for (int i = 0; i < count; ++i) {
    if (symbols[i * map->keysyms_per_keycode] != symbol) continue;
    return static_cast<std::uint8_t>(setup->min_keycode + i);
  }
  throw std::runtime_error("no such key");
}

void Person::press(xcb_window_t window, std::uint32_t symbol) {
  xcb_set_input_focus(connection_.get(), XCB_INPUT_FOCUS_PARENT, window, XCB_CURRENT_TIME);
  const std::uint8_t key = key_of(symbol);
  fake(XCB_KEY_PRESS, key);
  fake(XCB_KEY_RELEASE, key);
}

void Person::type(xcb_window_t window, char character) {
  press(window, static_cast<std::uint32_t>(character));
}

void Person::type_alt(xcb_window_t window, char character) {
  constexpr std::uint32_t kLeftAlt = 0xffe9;  // of keysymdef.h
  type_with(kLeftAlt, window, character);
}

void Person::type_control(xcb_window_t window, char character) {
  constexpr std::uint32_t kLeftControl = 0xffe3;
  type_with(kLeftControl, window, character);
}

void Person::type_with(std::uint32_t modifier, xcb_window_t window, char character) {
  const std::uint8_t key = key_of(modifier);
  fake(XCB_KEY_PRESS, key);
  type(window, character);
  fake(XCB_KEY_RELEASE, key);
}

void Person::click(xcb_window_t window, QPoint place) {
  const auto cookie = xcb_translate_coordinates(connection_.get(), window, root_,
                                                static_cast<std::int16_t>(place.x()),
                                                static_cast<std::int16_t>(place.y()));
  const auto there = owned(xcb_translate_coordinates_reply(connection_.get(), cookie, nullptr));
  const QPoint on_screen(there->dst_x, there->dst_y);
  fake(XCB_MOTION_NOTIFY, 0, on_screen);
  fake(XCB_BUTTON_PRESS, 1, on_screen);
  fake(XCB_BUTTON_RELEASE, 1, on_screen);
}

void Person::close(xcb_window_t window) {
  xcb_client_message_event_t message{};
  message.response_type = XCB_CLIENT_MESSAGE;
  message.format = 32;
  message.window = window;
  message.type = atom("WM_PROTOCOLS");
  message.data.data32[0] = atom("WM_DELETE_WINDOW");
  xcb_send_event(connection_.get(), 0, window, XCB_EVENT_MASK_NO_EVENT,
                 reinterpret_cast<const char*>(&message));
  xcb_flush(connection_.get());
}

QRect Person::place(xcb_window_t window) {
  const auto reply = owned(xcb_get_geometry_reply(
      connection_.get(), xcb_get_geometry(connection_.get(), window), nullptr));
  if (!reply) throw std::runtime_error("the window is gone");
  return {reply->x, reply->y, reply->width, reply->height};
}

QImage Person::picture(xcb_window_t window) {
  const auto size = owned(xcb_get_geometry_reply(
      connection_.get(), xcb_get_geometry(connection_.get(), window), nullptr));
  const auto cookie = xcb_get_image(connection_.get(), XCB_IMAGE_FORMAT_Z_PIXMAP, window, 0, 0,
                                    size->width, size->height, ~0U);
  const auto image = owned(xcb_get_image_reply(connection_.get(), cookie, nullptr));
  if (!image) throw std::runtime_error("the window cannot be seen");
  return QImage(xcb_get_image_data(image.get()), size->width, size->height, QImage::Format_RGB32)
      .copy();
}

}  // namespace eyebridge::gui::testing
