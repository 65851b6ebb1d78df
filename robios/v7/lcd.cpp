#include "lcd.hpp"

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

#include "convert.hpp"
#include "globals.hpp"
#include "guarded.hpp"
#include <eyebot.h>

using eyebridge::Errc;
using eyebridge::fail;
using eyebridge::Result;
using eyebridge::Rgb;
using eyebridge::robios::Call;
using eyebridge::robios::guarded;
using eyebridge::robios::Lcd;
using eyebridge::robios::null_pointer;
using eyebridge::robios::Session;
using eyebridge::robios::to_rgb;

int LCD_INITIAL = 1;
int IM_TYPE = QVGA;
int IM_LEFT = 0;
int IM_TOP = 0;
int IM_WIDTH = QVGA_X;
int IM_LENGTH = QVGA_Y;

void eyebridge::robios::publish_image_window(const ImageWindow& window, int mode) {
  EYEBRIDGE_VARIABLE(IM_TYPE) = mode;
  EYEBRIDGE_VARIABLE(IM_LEFT) = window.x;
  EYEBRIDGE_VARIABLE(IM_TOP) = window.y;
  EYEBRIDGE_VARIABLE(IM_WIDTH) = window.width;
  EYEBRIDGE_VARIABLE(IM_LENGTH) = window.height;
}

std::unique_ptr<eyebridge::robios::Screen> eyebridge::robios::make_screen(
    const hal::Config& config) {
  const auto [width, height] = config.size("lcd");
  return std::make_unique<Lcd>(width, height);
}

Lcd& Session::lcd() { return static_cast<Lcd&>(screen()); }

namespace {

constexpr int kLcdFailed = 1;
// A screen holds a few thousand characters: what is longer is a mistake in a format.
constexpr int kLongestText = 65535;

/// Most calls just draw: they cannot fail.
template <class Draw>
int drawing(const Call& call, Draw&& draw) {
  return guarded(call, kLcdFailed, [&](Session& session) -> Result<int> {
    draw(session.lcd());
    return 0;
  });
}

/// For calls whose arguments may be wrong.
template <class Change>
int changing(const Call& call, Change&& change) {
  return guarded(call, kLcdFailed, [&](Session& session) -> Result<int> {
    return change(session.lcd()).map([] { return 0; });
  });
}

/// Calls `print` with the text that a format and its arguments give.
template <class Print>
Result<int> formatted(const char* format, va_list arguments, Print&& print) {
  if (format == nullptr) {
    return null_pointer();
  }
  // Most texts are short: those need no memory.
  std::array<char, 256> small;
  va_list again;
  va_copy(again, arguments);
  const int length = std::vsnprintf(small.data(), small.size(), format, again);
  va_end(again);
  if (length < 0) {
    return fail(Errc::OutOfRange, std::string("the format \"") + format + "\" cannot be printed");
  }
  const auto size = static_cast<std::size_t>(std::min(length, kLongestText));
  if (size < small.size()) {
    print(std::string_view(small.data(), size));
    return 0;
  }
  std::string text(size + 1, '\0');
  std::vsnprintf(text.data(), text.size(), format, arguments);
  text.resize(size);
  print(text);
  return 0;
}

const char* or_empty(const char* text) { return text == nullptr ? "" : text; }

/// For LCDImage() and its sisters.
template <class Show>
int showing(const Call& call, const BYTE* data, Show&& show) {
  return guarded(call, kLcdFailed, [&](Session& session) -> Result<int> {
    if (data == nullptr) {
      return null_pointer();
    }
    show(session.lcd());
    return 0;
  });
}

}  // namespace

int LCDPrintf(const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  const int result = guarded("LCDPrintf", kLcdFailed, [&](Session& session) -> Result<int> {
    return formatted(format, arguments, [&](std::string_view text) { session.lcd().print(text); });
  });
  va_end(arguments);
  return result;
}

int LCDSetPrintf(int row, int column, const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  const int result = guarded("LCDSetPrintf", kLcdFailed, [&](Session& session) -> Result<int> {
    return formatted(format, arguments,
                     [&](std::string_view text) { session.lcd().print_at(row, column, text); });
  });
  va_end(arguments);
  return result;
}

int LCDClear(void) {
  return drawing("LCDClear", [](Lcd& lcd) { lcd.clear(); });
}

int LCDSetPos(int row, int column) {
  return drawing("LCDSetPos", [&](Lcd& lcd) { lcd.set_position(row, column); });
}

int LCDGetPos(int* row, int* column) {
  return guarded("LCDGetPos", kLcdFailed, [&](Session& session) -> Result<int> {
    if (row == nullptr || column == nullptr) {
      return null_pointer();
    }
    const auto position = session.lcd().position();
    *row = position.row;
    *column = position.column;
    return 0;
  });
}

int LCDSetColor(COLOR fg, COLOR bg) {
  return drawing("LCDSetColor", [&](Lcd& lcd) { lcd.set_text_colours(to_rgb(fg), to_rgb(bg)); });
}

int LCDSetFont(int font, int variation) {
  return changing("LCDSetFont", [&](Lcd& lcd) { return lcd.set_font(font, variation); });
}

int LCDSetFontSize(int fontsize) {
  return changing("LCDSetFontSize", [&](Lcd& lcd) { return lcd.set_font_size(fontsize); });
}

int LCDSetMode(int mode) {
  return drawing("LCDSetMode", [&](Lcd& lcd) { lcd.set_mode(mode); });
}

int LCDMenu(const char* st1, const char* st2, const char* st3, const char* st4) {
  return drawing("LCDMenu", [&](Lcd& lcd) {
    lcd.set_menu({or_empty(st1), or_empty(st2), or_empty(st3), or_empty(st4)});
  });
}

int LCDMenuI(int pos, const char* string, COLOR fg, COLOR bg) {
  return changing("LCDMenuI", [&](Lcd& lcd) {
    return lcd.set_menu_label(pos, or_empty(string), to_rgb(fg), to_rgb(bg));
  });
}

int LCDGetSize(int* x, int* y) {
  return guarded("LCDGetSize", kLcdFailed, [&](Session& session) -> Result<int> {
    if (x == nullptr || y == nullptr) {
      return null_pointer();
    }
    *x = session.lcd().width();
    *y = session.lcd().height();
    return 0;
  });
}

int LCDPixel(int x, int y, COLOR col) {
  return drawing("LCDPixel", [&](Lcd& lcd) { lcd.pixel(x, y, to_rgb(col)); });
}

COLOR LCDGetPixel(int x, int y) {
  return guarded("LCDGetPixel", COLOR{0}, [&](Session& session) -> Result<COLOR> {
    return session.lcd().pixel_at(x, y).map(
        [](Rgb pixel) { return pixel.r << 16 | pixel.g << 8 | pixel.b; });
  });
}

int LCDLine(int x1, int y1, int x2, int y2, COLOR col) {
  return drawing("LCDLine", [&](Lcd& lcd) { lcd.line(x1, y1, x2, y2, to_rgb(col)); });
}

int LCDArea(int x1, int y1, int x2, int y2, COLOR col, int fill) {
  return drawing("LCDArea", [&](Lcd& lcd) { lcd.area(x1, y1, x2, y2, to_rgb(col), fill != 0); });
}

int LCDCircle(int x1, int y1, int size, COLOR col, int fill) {
  return changing("LCDCircle",
                  [&](Lcd& lcd) { return lcd.circle(x1, y1, size, to_rgb(col), fill != 0); });
}

int LCDPixelInvert(int x, int y) {
  return drawing("LCDPixelInvert", [&](Lcd& lcd) { lcd.invert_pixel(x, y); });
}

int LCDLineInvert(int x1, int y1, int x2, int y2) {
  return drawing("LCDLineInvert", [&](Lcd& lcd) { lcd.invert_line(x1, y1, x2, y2); });
}

int LCDAreaInvert(int x1, int y1, int x2, int y2) {
  return drawing("LCDAreaInvert", [&](Lcd& lcd) { lcd.invert_area(x1, y1, x2, y2); });
}

int LCDImageSize(int t) {
  return changing("LCDImageSize", [&](Lcd& lcd) {
    return lcd.set_image_mode(t).map(
        [&] { eyebridge::robios::publish_image_window(lcd.image_window(), t); });
  });
}

int LCDImageStart(int x, int y, int xs, int ys) {
  return changing("LCDImageStart", [&](Lcd& lcd) {
    return lcd.set_image_window({x, y, xs, ys}).map([&] {
      eyebridge::robios::publish_image_window({x, y, xs, ys}, EYEBRIDGE_VARIABLE(IM_TYPE));
    });
  });
}

int LCDImage(BYTE* img) {
  return showing("LCDImage", img, [&](Lcd& lcd) { lcd.image(img); });
}

int LCDImageGray(BYTE* g) {
  return showing("LCDImageGray", g, [&](Lcd& lcd) { lcd.image_grey(g); });
}

int LCDImageBinary(BYTE* b) {
  return showing("LCDImageBinary", b, [&](Lcd& lcd) { lcd.image_binary(b); });
}

int LCDRefresh(void) {
  return drawing("LCDRefresh", [](Lcd& lcd) { lcd.refresh(); });
}

int XInitThreads(void) { return 1; }

// In no manual, but in the published library, and old programs call them without a declaration.
extern "C" {
__attribute__((visibility("default"))) int LCDInit(void) { return 0; }
__attribute__((visibility("default"))) int LCDRelease(void) { return 0; }
}
