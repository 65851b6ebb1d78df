#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "eyebridge/base/colour.hpp"
#include "eyebridge/base/pose.hpp"
#include "eyebridge/camera/fiducials.hpp"
#include "eyebridge/camera/frame.hpp"

namespace eyebridge::camera {

/// A4 paper that is drawn on in millimetres from its top left corner, x to the right, y down: the
/// pages of a PDF, or a single page as a picture.
class Paper {
 public:
  static constexpr double kWidth = 210.0;
  static constexpr double kHeight = 297.0;
  static constexpr double kMargin = 10.0;  ///< That printers leave white.

  /// Pages of a PDF. Throws std::runtime_error naming the file and the reason.
  explicit Paper(const std::filesystem::path& pdf);
  /// A picture with so many pixels a millimetre.
  explicit Paper(double pixels_per_mm);
  ~Paper();
  Paper(const Paper&) = delete;
  Paper& operator=(const Paper&) = delete;

  /// Ends the present page of a PDF.
  void next_page();
  /// Writes the PDF to its end. Throws std::runtime_error when that failed, now or before.
  void finish();
  /// What has been drawn, Rgb24; of a picture only.
  [[nodiscard]] Frame picture() const;

  void fill(Vec2 corner, Vec2 size, Rgb colour);
  /// Dashed lines are for scissors.
  void outline(Vec2 corner, Vec2 size, double width, Rgb colour, bool dashed = false);
  void line(Vec2 a, Vec2 b, double width, Rgb colour);
  /// With a head at `b`.
  void arrow(Vec2 a, Vec2 b, double width, Rgb colour);
  /// From `at` on to the right, its baseline there; `size` of the font.
  void text(Vec2 at, const std::string& text, double size, Rgb colour, bool bold = false);
  void centred_text(Vec2 at, const std::string& text, double size, Rgb colour, bool bold = false);
  /// The black square of `id`, its top left corner at `corner`, no margin. Throws what
  /// fiducial_bits() throws.
  void fiducial(Vec2 corner, double size, FiducialFamily family, int id);
  /// A bar of 100 mm in the page's lower margin, by which one sees that it was printed true to
  /// size.
  void ruler();

 private:
  struct Sheet;
  std::unique_ptr<Sheet> sheet_;
};

}  // namespace eyebridge::camera
