#include "pictures/paper.hpp"

#include <cassert>
#include <cmath>
#include <stdexcept>

#include <cairo-pdf.h>
#include <cairo.h>

#include "eyebridge/base/own_results.hpp"
#include "pictures/cairo_picture.hpp"

namespace eyebridge::camera {
namespace {

constexpr double kPointsPerMm = 72.0 / 25.4;
constexpr Rgb kPrintBlack{0, 0, 0};

struct Free {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* pen) const { cairo_destroy(pen); }
};

}  // namespace

struct Paper::Sheet {
  std::string file;  ///< Of a PDF.
  std::unique_ptr<cairo_surface_t, Free> surface;
  std::unique_ptr<cairo_t, Free> pen;

  Sheet(cairo_surface_t* made, double scale) : surface(made), pen(cairo_create(made)) {
    cairo_scale(pen.get(), scale, scale);
  }

  void check() const {
    cairo_status_t status = cairo_status(pen.get());
    if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_status(surface.get());
    if (status == CAIRO_STATUS_SUCCESS) return;
    throw std::runtime_error((file.empty() ? "" : file + ": cannot be written: ") +
                             cairo_status_to_string(status));
  }

  [[nodiscard]] cairo_t* with(Rgb colour) const {
    cairo_new_path(pen.get());
    cairo_set_dash(pen.get(), nullptr, 0, 0.0);
    cairo_set_source_rgb(pen.get(), colour.r / 255.0, colour.g / 255.0, colour.b / 255.0);
    return pen.get();
  }

  [[nodiscard]] cairo_t* writing(double size, Rgb colour, bool bold) const {
    cairo_t* with_colour = with(colour);
    cairo_select_font_face(with_colour, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(with_colour, size);
    return with_colour;
  }
};

namespace {

const std::filesystem::path& replaceable(const std::filesystem::path& pdf) {
  check_replaceable(pdf, "PDF", "%PDF");
  return pdf;
}

}  // namespace

Paper::Paper(const std::filesystem::path& pdf)
    : sheet_(std::make_unique<Sheet>(
          cairo_pdf_surface_create(replaceable(pdf).c_str(), kWidth * kPointsPerMm,
                                   kHeight * kPointsPerMm),
          kPointsPerMm)) {
  sheet_->file = pdf.string();
  sheet_->check();
  // What every printer knows; newer cairos write 1.7 otherwise.
  cairo_pdf_surface_restrict_to_version(sheet_->surface.get(), CAIRO_PDF_VERSION_1_4);
}

Paper::Paper(double pixels_per_mm)
    : sheet_(std::make_unique<Sheet>(
          cairo_image_surface_create(CAIRO_FORMAT_RGB24,
                                     static_cast<int>(std::lround(kWidth * pixels_per_mm)),
                                     static_cast<int>(std::lround(kHeight * pixels_per_mm))),
          pixels_per_mm)) {
  sheet_->check();
  cairo_paint(sheet_->with({255, 255, 255}));
}

Paper::~Paper() = default;

void Paper::next_page() { cairo_show_page(sheet_->pen.get()); }

void Paper::finish() {
  cairo_surface_finish(sheet_->surface.get());
  sheet_->check();
}

Frame Paper::picture() const {
  cairo_surface_t* surface = sheet_->surface.get();
  assert(cairo_surface_get_type(surface) == CAIRO_SURFACE_TYPE_IMAGE);
  return cairo_picture(surface);
}

void Paper::fill(Vec2 corner, Vec2 size, Rgb colour) {
  cairo_t* pen = sheet_->with(colour);
  cairo_rectangle(pen, corner.x, corner.y, size.x, size.y);
  cairo_fill(pen);
}

void Paper::outline(Vec2 corner, Vec2 size, double width, Rgb colour, bool dashed) {
  cairo_t* pen = sheet_->with(colour);
  const double dashes[] = {2.0, 2.0};
  if (dashed) cairo_set_dash(pen, dashes, 2, 0.0);
  cairo_set_line_width(pen, width);
  cairo_rectangle(pen, corner.x, corner.y, size.x, size.y);
  cairo_stroke(pen);
}

void Paper::line(Vec2 a, Vec2 b, double width, Rgb colour) {
  cairo_t* pen = sheet_->with(colour);
  cairo_set_line_width(pen, width);
  cairo_set_line_cap(pen, CAIRO_LINE_CAP_ROUND);
  cairo_move_to(pen, a.x, a.y);
  cairo_line_to(pen, b.x, b.y);
  cairo_stroke(pen);
}

void Paper::arrow(Vec2 a, Vec2 b, double width, Rgb colour) {
  const double length = norm(b - a);
  const Vec2 along = (1.0 / length) * (b - a);
  const Vec2 aside{-along.y, along.x};
  const double head = 3.5 * width;
  line(a, b - head * along, width, colour);
  cairo_t* pen = sheet_->with(colour);
  for (const Vec2 p :
       {b, b - head * along + 0.6 * head * aside, b - head * along - 0.6 * head * aside}) {
    cairo_line_to(pen, p.x, p.y);
  }
  cairo_fill(pen);
}

void Paper::text(Vec2 at, const std::string& text, double size, Rgb colour, bool bold) {
  cairo_t* pen = sheet_->writing(size, colour, bold);
  cairo_move_to(pen, at.x, at.y);
  cairo_show_text(pen, text.c_str());
}

void Paper::centred_text(Vec2 at, const std::string& text, double size, Rgb colour, bool bold) {
  cairo_t* pen = sheet_->writing(size, colour, bold);
  cairo_text_extents_t extents;
  cairo_text_extents(pen, text.c_str(), &extents);
  cairo_move_to(pen, at.x - extents.x_bearing - 0.5 * extents.width,
                at.y - extents.y_bearing - 0.5 * extents.height);
  cairo_show_text(pen, text.c_str());
}

void Paper::fiducial(Vec2 corner, double size, FiducialFamily family, int id) {
  const FiducialBits bits = fiducial_bits(family, id);
  const int cells = cells_of(family);
  cairo_t* pen = sheet_->with(kPrintBlack);
  const double cell = size / cells;
  // All black cells as one path: no seams between neighbours.
  for (int row = 0; row < cells; ++row) {
    for (int column = 0; column < cells; ++column) {
      if (bits[static_cast<std::size_t>(row * cells + column)] != 0) continue;
      cairo_rectangle(pen, corner.x + column * cell, corner.y + row * cell, cell, cell);
    }
  }
  cairo_fill(pen);
}

void Paper::ruler() {
  const double y = kHeight - kMargin;
  line({kMargin, y}, {kMargin + 100.0, y}, 0.3, kPrintBlack);
  for (int mm = 0; mm <= 100; mm += 10) {
    line({kMargin + mm, y}, {kMargin + mm, y - (mm % 50 == 0 ? 2.5 : 1.5)}, 0.3, kPrintBlack);
  }
  text({kMargin + 104.0, y}, "100 mm, if printed at 100 % (\"actual size\")", 3.2, kPrintBlack);
}

}  // namespace eyebridge::camera
