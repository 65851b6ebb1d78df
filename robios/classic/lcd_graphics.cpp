#include <array>
#include <cstdint>
#include <vector>

#include <fmt/format.h>

#include "call.hpp"
#include "classic_lcd.hpp"
#include "eyebot.h"
#include "image.hpp"

namespace {

using namespace eyebridge;
using robios::MonoLcd;
using robios::Session;
using robios::classic::call;
using robios::classic::doing;
using Pen = robios::MonoLcd::Pen;

// Of an image what is shown: without its border, and without what would cover the labels.
constexpr int kShownWidth = imagecolumns - 2;
constexpr int kShownHeight = 54;

Result<Pen> pen_of(int colour) {
  static constexpr std::array kPens = {Pen::Clear, Pen::Set, Pen::Invert};
  if (colour < 0 || colour > 2) {
    return fail(Errc::OutOfRange,
                fmt::format("colour {}, expected 0 (clear), 1 (set) or 2 (invert)", colour));
  }
  return kPens.at(static_cast<std::size_t>(colour));
}

/// Runs `draw(lcd, pen)`, which returns nothing.
template <class Draw>
int drawing(const robios::Call& name, int colour, Draw&& draw) {
  return doing(name, 1, [&](Session& session) {
    return pen_of(colour).map([&](Pen pen) { draw(robios::classic::lcd(session), pen); });
  });
}

}  // namespace

int LCDPutGraphic(image* buf) {
  return doing("LCDPutGraphic", 1, [&](Session& session) -> Result<void> {
    if (buf == nullptr) return robios::null_pointer();
    robios::classic::lcd(session).picture(0, 0, kShownWidth, kShownHeight, &(*buf)[1][1],
                                          imagecolumns);
    return {};
  });
}

int LCDPutColorGraphic(colimage* buf) {
  return doing("LCDPutColorGraphic", 1, [&](Session& session) -> Result<void> {
    if (buf == nullptr) return robios::null_pointer();
    constexpr robios::ImageSize kSize{imagecolumns, imagerows};
    std::vector<std::uint8_t> grey(kSize.pixels());
    robios::colour_to_grey(kSize, {&(*buf)[0][0][0], 3 * kSize.pixels()}, grey);
    robios::classic::lcd(session).picture(0, 0, kShownWidth, kShownHeight,
                                          grey.data() + imagecolumns + 1, imagecolumns);
    return {};
  });
}

int LCDPutImage(BYTE* buf) {
  return doing("LCDPutImage", 1, [&](Session& session) -> Result<void> {
    if (buf == nullptr) return robios::null_pointer();
    robios::classic::lcd(session).bitmap(buf);
    return {};
  });
}

int LCDPutImageRGB(int x, int y, int xsize, int ysize, const void* data) {
  return doing("LCDPutImageRGB", 1, [&](Session& session) -> Result<void> {
    if (data == nullptr) return robios::null_pointer();
    if (xsize < 1 || ysize < 1) {
      return fail(Errc::OutOfRange, fmt::format("a picture of {} x {}", xsize, ysize));
    }
    // Only what can be seen is read.
    const int width = static_cast<int>(std::min<std::int64_t>(xsize, std::int64_t{128} - x));
    const int height = static_cast<int>(std::min<std::int64_t>(ysize, std::int64_t{64} - y));
    if (width < 1 || height < 1 || width > 4096 || height > 4096) return {};
    std::vector<std::uint8_t> grey(static_cast<std::size_t>(width) *
                                   static_cast<std::size_t>(height));
    const auto* const rgb = static_cast<const std::uint8_t*>(data);
    for (std::size_t i = 0; i < grey.size(); ++i) {
      const std::size_t row = i / static_cast<std::size_t>(width);
      const std::size_t column = i % static_cast<std::size_t>(width);
      const std::uint8_t* const p = rgb + 3 * (row * static_cast<std::size_t>(xsize) + column);
      grey[i] = robios::grey_of({p[0], p[1], p[2]});
    }
    robios::classic::lcd(session).picture(x, y, width, height, grey.data(),
                                          static_cast<std::size_t>(width));
    return {};
  });
}

int LCDSetPixel(int row, int col, int val) {
  return doing("LCDSetPixel", 1, [&](Session& session) {
    return pen_of(val).and_then(
        [&](Pen pen) { return robios::classic::lcd(session).pixel(col, row, pen); });
  });
}

int LCDInvertPixel(int row, int col) {
  return doing("LCDInvertPixel", 1, [&](Session& session) {
    return robios::classic::lcd(session).pixel(col, row, Pen::Invert);
  });
}

int LCDGetPixel(int row, int col) {
  return call("LCDGetPixel", -1, [&](Session& session) -> Result<int> {
    return robios::classic::lcd(session).pixel_at(col, row).map(
        [](bool black) { return black ? 1 : 0; });
  });
}

int LCDLine(int x1, int y1, int x2, int y2, int col) {
  return drawing("LCDLine", col, [&](MonoLcd& lcd, Pen pen) { lcd.line(x1, y1, x2, y2, pen); });
}

int LCDArea(int x1, int y1, int x2, int y2, int col) {
  if (x1 > x2 || y1 > y2) {
    return doing("LCDArea", 1, [&](Session&) -> Result<void> {
      return fail(
          Errc::OutOfRange,
          fmt::format("{}, {} to {}, {}: expected the upper left corner first", x1, y1, x2, y2));
    });
  }
  return drawing("LCDArea", col, [&](MonoLcd& lcd, Pen pen) { lcd.area(x1, y1, x2, y2, pen); });
}
