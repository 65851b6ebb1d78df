#include "lcd.hpp"

#include <algorithm>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge::robios {
namespace {

constexpr int kSmallest = 160;
constexpr int kLargest = 4096;

// Flags of LCDSetMode(), as in eyebot.h.
constexpr int kAutoRefresh = 0x0001;
constexpr int kScrolling = 0x0002;
constexpr int kLineFeed = 0x0004;
constexpr int kShowMenu = 0x0008;
/// The opposite of a flag is the flag, eight bits up.
constexpr int off(int flag) { return flag << 8; }

struct ImageMode {
  int width;
  int height;
};
constexpr std::array<ImageMode, 6> kImageModes{
    {{160, 120}, {320, 240}, {640, 480}, {1296, 730}, {1920, 1080}, {2592, 1944}}};

int checked(int size, const char* what) {
  if (size < kSmallest || size > kLargest) {
    throw ConfigError({"screen size", 0, 0}, std::string(what) + " " + std::to_string(size) +
                                                 ", expected " + std::to_string(kSmallest) + ".." +
                                                 std::to_string(kLargest) + " pixels");
  }
  return size;
}

}  // namespace

Lcd::Lcd(int width, int height)
    : width_(checked(width, "width")),
      height_(checked(height, "height")),
      canvas_(width, height),
      text_(width, height - kMenuHeight),
      soft_keys_(width) {}

template <class Draw>
void Lcd::draw(Draw&& change) {
  const std::lock_guard lock(mutex_);
  change();
  if (auto_refresh_) {
    ++revision_;
  }
}

void Lcd::print(std::string_view text) {
  draw([&] { text_.print(canvas_, text); });
}

void Lcd::print_at(int row, int column, std::string_view text) {
  draw([&] {
    text_.set_position(row, column);
    text_.print(canvas_, text);
  });
}

void Lcd::clear() {
  draw([&] {
    canvas_.area(0, 0, width_ - 1, height_ - 1, {}, true);
    text_.clear();
  });
}

void Lcd::set_position(int row, int column) {
  const std::lock_guard lock(mutex_);
  text_.set_position(row, column);
}

TextPosition Lcd::position() const {
  const std::lock_guard lock(mutex_);
  return text_.position();
}

void Lcd::set_text_colours(Rgb ink, Rgb paper) {
  const std::lock_guard lock(mutex_);
  text_.set_colours(ink, paper);
}

Result<void> Lcd::set_font(int font, int variation) {
  if (font < 0 || font > 2 || variation < 0 || variation > 2) {
    return fail(Errc::OutOfRange, "font " + std::to_string(font) + ", variation " +
                                      std::to_string(variation) + ", expected 0..2 each");
  }
  const std::lock_guard lock(mutex_);
  text_.set_font(static_cast<FontFamily>(font), static_cast<FontStyle>(variation));
  return {};
}

Result<void> Lcd::set_font_size(int size) {
  const auto sizes = font_sizes();
  if (std::find(sizes.begin(), sizes.end(), size) == sizes.end()) {
    return fail(Errc::OutOfRange,
                "font size " + std::to_string(size) + ", expected 8, 10, 12, 14, 18 or 24");
  }
  const std::lock_guard lock(mutex_);
  text_.set_font_size(size);
  return {};
}

void Lcd::set_mode(int flags) {
  const auto chosen = [flags](int flag, bool current) {
    if ((flags & off(flag)) != 0) {
      return false;
    }
    return (flags & flag) != 0 || current;
  };
  const std::lock_guard lock(mutex_);
  if ((flags & (kScrolling | off(kScrolling))) != 0) {
    text_.set_scrolling(chosen(kScrolling, true));
  }
  if ((flags & (kLineFeed | off(kLineFeed))) != 0) {
    text_.set_wrapping(chosen(kLineFeed, true));
  }
  const bool refreshed = auto_refresh_;
  menu_shown_ = chosen(kShowMenu, menu_shown_);
  auto_refresh_ = chosen(kAutoRefresh, auto_refresh_);
  if (refreshed && !auto_refresh_) {
    frozen_ = canvas_.pixels();
  }
  ++revision_;
}

void Lcd::set_menu(const std::array<std::string_view, kSoftKeys>& labels) {
  const std::lock_guard lock(mutex_);
  soft_keys_.set_all(labels);
  menu_shown_ = true;
  ++revision_;
}

Result<void> Lcd::set_menu_label(int position, std::string_view label, Rgb ink, Rgb paper) {
  const std::lock_guard lock(mutex_);
  auto done = soft_keys_.set_one(position, label, ink, paper);
  if (done) {
    menu_shown_ = true;
    ++revision_;
  }
  return done;
}

int Lcd::key_at(int x, int y) const {
  const std::lock_guard lock(mutex_);
  return menu_shown_ && y >= height_ - kMenuHeight && y < height_ ? soft_keys_.key_at(x) : 0;
}

void Lcd::pixel(int x, int y, Rgb colour) {
  draw([&] { canvas_.pixel(x, y, colour); });
}

Result<Rgb> Lcd::pixel_at(int x, int y) const {
  const std::lock_guard lock(mutex_);
  if (!canvas_.contains(x, y)) {
    return fail(Errc::OutOfRange, "no pixel " + std::to_string(x) + ", " + std::to_string(y));
  }
  const int strip = height_ - kMenuHeight;
  if (menu_shown_ && y >= strip) {
    return soft_keys_.picture().at(x, y - strip);
  }
  if (!auto_refresh_) {
    return frozen_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                   static_cast<std::size_t>(x)];
  }
  return canvas_.at(x, y);
}

void Lcd::line(int x1, int y1, int x2, int y2, Rgb colour) {
  draw([&] { canvas_.line(x1, y1, x2, y2, colour); });
}

void Lcd::area(int x1, int y1, int x2, int y2, Rgb colour, bool fill) {
  draw([&] { canvas_.area(x1, y1, x2, y2, colour, fill); });
}

Result<void> Lcd::circle(int x, int y, int radius, Rgb colour, bool fill) {
  if (radius < 0) {
    return fail(Errc::OutOfRange, "radius " + std::to_string(radius) + ", expected at least 0");
  }
  draw([&] { canvas_.circle(x, y, radius, colour, fill); });
  return {};
}

void Lcd::invert_pixel(int x, int y) {
  draw([&] { canvas_.invert_pixel(x, y); });
}

void Lcd::invert_line(int x1, int y1, int x2, int y2) {
  draw([&] { canvas_.invert_line(x1, y1, x2, y2); });
}

void Lcd::invert_area(int x1, int y1, int x2, int y2) {
  draw([&] { canvas_.invert_area(x1, y1, x2, y2); });
}

Result<void> Lcd::set_image_mode(int mode) {
  if (mode < 0 || mode >= static_cast<int>(kImageModes.size())) {
    return fail(Errc::OutOfRange, "image mode " + std::to_string(mode) + ", expected 0..5");
  }
  const ImageMode& size = kImageModes.at(static_cast<std::size_t>(mode));
  const std::lock_guard lock(mutex_);
  window_ = {0, 0, size.width, size.height};
  window_placed_ = false;
  return {};
}

Result<void> Lcd::set_image_window(const ImageWindow& window) {
  if (window.width < 1 || window.height < 1 || window.width > kLargest ||
      window.height > kLargest) {
    return fail(Errc::OutOfRange, "image of " + std::to_string(window.width) + " x " +
                                      std::to_string(window.height) + ", expected 1 to " +
                                      std::to_string(kLargest) + " pixels each way");
  }
  const std::lock_guard lock(mutex_);
  window_ = window;
  window_placed_ = true;
  return {};
}

void Lcd::follow_camera(int width, int height) {
  const std::lock_guard lock(mutex_);
  if (!window_placed_) {
    window_ = {0, 0, width, height};
  }
}

ImageWindow Lcd::image_window() const {
  const std::lock_guard lock(mutex_);
  return window_;
}

void Lcd::image(const std::uint8_t* rgb) {
  draw([&] {
    canvas_.picture(window_.x, window_.y, window_.width, window_.height, rgb, 3,
                    [](const std::uint8_t* p) {
                      return Rgb{p[0], p[1], p[2]};
                    });
  });
}

void Lcd::image_grey(const std::uint8_t* grey) {
  draw([&] {
    canvas_.picture(window_.x, window_.y, window_.width, window_.height, grey, 1,
                    [](const std::uint8_t* p) {
                      return Rgb{*p, *p, *p};
                    });
  });
}

void Lcd::image_binary(const std::uint8_t* bits) {
  draw([&] {
    canvas_.picture(window_.x, window_.y, window_.width, window_.height, bits, 1,
                    [](const std::uint8_t* p) {
                      return *p == 0 ? Rgb{255, 255, 255} : Rgb{0, 0, 0};
                    });
  });
}

void Lcd::refresh() {
  const std::lock_guard lock(mutex_);
  if (!auto_refresh_) {
    frozen_ = canvas_.pixels();
    ++revision_;
  }
}

camera::Frame Lcd::snapshot() const {
  const std::lock_guard lock(mutex_);
  camera::Frame frame;
  frame.width = width_;
  frame.height = height_;
  frame.stride = 3 * width_;
  frame.format = camera::PixelFormat::Rgb24;
  frame.sequence = revision_;
  const std::vector<Rgb>& shown = auto_refresh_ ? canvas_.pixels() : frozen_;
  const std::vector<Rgb>& strip = soft_keys_.picture().pixels();
  const std::size_t covered = menu_shown_ ? shown.size() - strip.size() : shown.size();
  frame.bytes.resize(shown.size() * 3);
  std::uint8_t* out = frame.bytes.data();
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const Rgb pixel = i < covered ? shown[i] : strip[i - covered];
    *out++ = pixel.r;
    *out++ = pixel.g;
    *out++ = pixel.b;
  }
  return frame;
}

std::vector<std::string> Lcd::text_rows() const {
  const std::lock_guard lock(mutex_);
  return text_.rows_as_text();
}

std::array<std::string, kSoftKeys> Lcd::menu_labels() const {
  const std::lock_guard lock(mutex_);
  std::array<std::string, kSoftKeys> labels;
  for (std::size_t key = 0; key < labels.size(); ++key) {
    labels.at(key) = soft_keys_.label(key);
  }
  return labels;
}

std::uint64_t Lcd::revision() const {
  const std::lock_guard lock(mutex_);
  return revision_;
}

}  // namespace eyebridge::robios
