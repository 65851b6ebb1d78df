// Text and labels on the screen; pictures are in lcd_graphics.cpp.

#include <array>
#include <cstdarg>
#include <cstdio>
#include <memory>
#include <string>

#include <fmt/format.h>

#include "call.hpp"
#include "classic_lcd.hpp"
#include "eyebot.h"

namespace {

using namespace eyebridge;
using robios::Session;
using robios::classic::call;
using robios::classic::doing;

// A screen holds 112 characters: what is longer is a mistake in a format.
constexpr int kLongestText = 4095;

Result<std::string> formatted_text(const char* format, va_list arguments) {
  if (format == nullptr) return robios::null_pointer();
  std::string text(kLongestText + 1, '\0');
  const int length = std::vsnprintf(text.data(), text.size(), format, arguments);
  if (length < 0) {
    return fail(Errc::OutOfRange, fmt::format("the format \"{:.60}\" cannot be printed", format));
  }
  text.resize(static_cast<std::size_t>(std::min(length, kLongestText)));
  return text;
}

Result<void> show(Session& session, const std::string& text) {
  robios::classic::lcd(session).print(text);
  if (text.find('\a') != std::string::npos) AUBeep();
  return {};
}

int print(const robios::Call& name, const std::string& text) {
  return doing(name, 1, [&](Session& session) { return show(session, text); });
}

Result<void> set_label(Session& session, int pos, const char* label) {
  if (pos < 1 || pos > 4) {
    return fail(Errc::OutOfRange, fmt::format("menu position {}, expected 1 … 4", pos));
  }
  if (label != nullptr) {
    robios::classic::lcd(session).set_label(static_cast<std::size_t>(pos - 1), label);
  }
  return {};
}

}  // namespace

std::unique_ptr<eyebridge::robios::Screen> eyebridge::robios::make_screen(
    const hal::Config& config) {
  const hal::ConfigValue& size = config.value("lcd");
  if (!size.is_default()) {
    throw ConfigError(size.where, fmt::format("found {}, but the screen of classic RoBIOS has "
                                              "always 128x64 pixels: leave the setting out",
                                              size.text));
  }
  return std::make_unique<MonoLcd>();
}

eyebridge::robios::MonoLcd& eyebridge::robios::classic::lcd(Session& session) {
  return static_cast<MonoLcd&>(session.screen());
}

void eyebridge::robios::publish_globals(Session&) {}  // this generation shows none

int LCDPrintf(const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  const int result = doing("LCDPrintf", 1, [&](Session& session) {
    return formatted_text(format, arguments).and_then([&](const std::string& text) {
      return show(session, text);
    });
  });
  va_end(arguments);
  return result;
}

int LCDSetPrintf(int row, int column, const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  const int result = doing("LCDSetPrintf", 1, [&](Session& session) {
    return formatted_text(format, arguments).and_then([&](const std::string& text) {
      return robios::classic::lcd(session).print_at(row, column, text);
    });
  });
  va_end(arguments);
  return result;
}

int LCDClear(void) {
  return doing("LCDClear", 1, [](Session& session) -> Result<void> {
    robios::classic::lcd(session).clear();
    return {};
  });
}

int LCDPutChar(char c) { return print("LCDPutChar", std::string(1, c)); }

int LCDSetChar(int row, int column, char c) {
  return doing("LCDSetChar", 1, [&](Session& session) {
    return robios::classic::lcd(session).print_at(row, column, std::string(1, c));
  });
}

int LCDPutString(const char* s) {
  return doing("LCDPutString", 1, [&](Session& session) -> Result<void> {
    if (s == nullptr) return robios::null_pointer();
    return show(session, s);
  });
}

int LCDSetString(int row, int column, const char* s) {
  return doing("LCDSetString", 1, [&](Session& session) -> Result<void> {
    if (s == nullptr) return robios::null_pointer();
    return robios::classic::lcd(session).print_at(row, column, s);
  });
}

int LCDPutHex(int val) {
  return print("LCDPutHex", fmt::format("{:X}", static_cast<unsigned>(val)));
}
int LCDPutHex1(int val) { return print("LCDPutHex1", fmt::format("{:02X}", val & 0xFF)); }
int LCDPutInt(int val) { return print("LCDPutInt", std::to_string(val)); }

int LCDPutIntS(int val, int spaces) {
  return print("LCDPutIntS", fmt::format("{:>{}}", val, std::clamp(spaces, 0, kLongestText)));
}

int LCDPutFloat(float val) { return print("LCDPutFloat", fmt::format("{:f}", val)); }

int LCDPutFloatS(float val, int spaces, int decimals) {
  return print("LCDPutFloatS", fmt::format("{:>{}.{}f}", val, std::clamp(spaces, 0, kLongestText),
                                           std::clamp(decimals, 0, 9)));
}

int LCDMode(int mode) {
  return doing("LCDMode", 1, [&](Session& session) -> Result<void> {
    robios::classic::lcd(session).set_mode((mode & SCROLLING) != 0, (mode & CURSOR) != 0);
    return {};
  });
}

int LCDSetPos(int row, int column) {
  return doing("LCDSetPos", 1, [&](Session& session) {
    return robios::classic::lcd(session).set_position(row, column);
  });
}

int LCDGetPos(int* row, int* column) {
  return doing("LCDGetPos", 1, [&](Session& session) -> Result<void> {
    if (row == nullptr || column == nullptr) return robios::null_pointer();
    const robios::TextPosition position = robios::classic::lcd(session).position();
    *row = position.row;
    *column = position.column;
    return {};
  });
}

int LCDMenu(const char* s1, const char* s2, const char* s3, const char* s4) {
  return doing("LCDMenu", 1, [&](Session& session) -> Result<void> {
    int pos = 0;
    for (const char* label : {s1, s2, s3, s4}) static_cast<void>(set_label(session, ++pos, label));
    return {};
  });
}

int LCDMenuI(int pos, const char* string) {
  return doing("LCDMenuI", 1, [&](Session& session) { return set_label(session, pos, string); });
}
