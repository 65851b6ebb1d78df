#pragma once

#include <array>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "canvas.hpp"
#include "eyebridge/base/colour.hpp"
#include "eyebridge/base/result.hpp"
#include "eyebridge/camera/frame.hpp"
#include "font.hpp"
#include "screen.hpp"
#include "soft_keys.hpp"
#include "text_screen.hpp"

namespace eyebridge::robios {

/// Place and size of the images that LCDImage() and its sisters show, in pixels.
struct ImageWindow {
  int x = 0;
  int y = 0;
  int width = 320;
  int height = 240;

  friend bool operator==(const ImageWindow&, const ImageWindow&) = default;
};

/// The robot's screen: a framebuffer with a text cursor, and a strip of four soft keys over its
/// lower edge.
///
/// Text lives on a grid of cells that ends above the strip, whether or not it is shown, so that the
/// number of rows never changes under a program. Any thread: every call locks for itself.
class Lcd final : public Screen {
 public:
  /// 80 columns of 24 rows in the first font (7 x 15 pixels), and the strip: programs put text at
  /// columns 50 to 60 beside a picture of 320 x 240.
  static constexpr int kDefaultWidth = 560;
  static constexpr int kDefaultHeight = 400;

  /// Both 160..4096 pixels, else ConfigError.
  explicit Lcd(int width = kDefaultWidth, int height = kDefaultHeight);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

  /// Prints at the cursor; UTF-8 or Latin-1, see TextScreen::print().
  void print(std::string_view text);
  /// Moves the cursor and prints, as one step.
  void print_at(int row, int column, std::string_view text);
  /// Black, cursor home, white on black text. The menu stays.
  void clear();
  void set_position(int row, int column);
  [[nodiscard]] TextPosition position() const;
  void set_text_colours(Rgb ink, Rgb paper);
  /// RoBIOS numbers (HELVETICA 0 …, NORMAL 0 …); OutOfRange for others.
  Result<void> set_font(int font, int variation);
  /// One of font_sizes(), else OutOfRange. What was printed stays; the cursor keeps its row and
  /// column, counted in the new cells.
  Result<void> set_font_size(int size);
  /// Flags of LCDSetMode(): a flag and its opposite switch on and off, others are ignored.
  void set_mode(int flags);

  /// Labels the soft keys (LCDMenu) and shows them.
  void set_menu(const std::array<std::string_view, kSoftKeys>& labels);
  /// One label (LCDMenuI), shown at once. Position 1..4, or 0..3 in programs that once gave 0;
  /// else OutOfRange.
  Result<void> set_menu_label(int position, std::string_view label, Rgb ink, Rgb paper);
  /// Mask of the soft key under a pixel (1, 2, 4, 8), or 0: outside the strip, or no menu shown.
  [[nodiscard]] int key_at(int x, int y) const override;

  void pixel(int x, int y, Rgb colour);
  /// What is shown there, the menu included. OutOfRange outside the screen.
  [[nodiscard]] Result<Rgb> pixel_at(int x, int y) const;
  void line(int x1, int y1, int x2, int y2, Rgb colour);
  void area(int x1, int y1, int x2, int y2, Rgb colour, bool fill);
  /// OutOfRange for a negative radius.
  Result<void> circle(int x, int y, int radius, Rgb colour, bool fill);

  /// Every colour there becomes its opposite.
  void invert_pixel(int x, int y);
  void invert_line(int x1, int y1, int x2, int y2);
  void invert_area(int x1, int y1, int x2, int y2);

  /// LCDImageSize(): window at 0, 0 of a camera mode's size; OutOfRange for an unknown mode.
  Result<void> set_image_mode(int mode);
  /// LCDImageStart(); OutOfRange for a size below 1.
  Result<void> set_image_window(const ImageWindow& window);
  /// CAMInit() tells the camera's size: the window follows at 0, 0 unless LCDImageStart() placed
  /// it.
  void follow_camera(int width, int height);
  [[nodiscard]] ImageWindow image_window() const;
  /// The data has the window's size, R, G, B a pixel; only what is visible is read.
  void image(const std::uint8_t* rgb);
  /// One byte a pixel, 0 black.
  void image_grey(const std::uint8_t* grey);
  /// One byte a pixel, 0 white, all else black.
  void image_binary(const std::uint8_t* bits);

  /// Shows what was drawn while LCD_NOAUTOREFRESH is set.
  void refresh();
  [[nodiscard]] camera::Frame snapshot() const override;
  [[nodiscard]] std::vector<std::string> text_rows() const override;
  [[nodiscard]] std::array<std::string, kSoftKeys> menu_labels() const override;
  [[nodiscard]] std::uint64_t revision() const override;

 private:
  template <class Draw>
  void draw(Draw&& change);

  const int width_;
  const int height_;
  mutable std::mutex mutex_;
  Canvas canvas_;            // what is drawn, without the strip
  std::vector<Rgb> frozen_;  // what is shown while auto_refresh_ is off
  TextScreen text_;
  SoftKeys soft_keys_;
  bool menu_shown_ = false;
  bool auto_refresh_ = true;
  bool window_placed_ = false;
  ImageWindow window_;
  std::uint64_t revision_ = 0;
};

}  // namespace eyebridge::robios
