#include "pictures/canvas.hpp"

#include <algorithm>
#include <cmath>
#include <new>

#include <cairo.h>

#include "eyebridge/base/units.hpp"
#include "pictures/cairo_picture.hpp"

namespace eyebridge::camera {
namespace {

struct FreeCairo {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* pen) const { cairo_destroy(pen); }
};

}  // namespace

struct Canvas::Sheet {
  std::unique_ptr<cairo_surface_t, FreeCairo> surface;
  std::unique_ptr<cairo_t, FreeCairo> pen;

  Sheet(int width, int height)
      : surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height)),
        pen(cairo_create(surface.get())) {
    if (cairo_status(pen.get()) != CAIRO_STATUS_SUCCESS) throw std::bad_alloc();
  }

  /// The pen in `colour`, at the start of a new path: text leaves a point behind.
  [[nodiscard]] cairo_t* with(Rgb colour) const {
    cairo_new_path(pen.get());
    cairo_set_source_rgb(pen.get(), colour.r / 255.0, colour.g / 255.0, colour.b / 255.0);
    return pen.get();
  }
};

Canvas::Canvas(Vec2 low, Vec2 high, int longest_side, Rgb paper) : low_(low), high_(high) {
  const Vec2 size{std::max(high.x - low.x, 1e-3), std::max(high.y - low.y, 1e-3)};
  const double side = std::max(longest_side, 64);
  // Two borders beside the map; above it one and below it two.
  scale_ = std::min((side - 2.0 * kBorder) / size.x, (side - 3.0 * kBorder) / size.y);
  const auto pixels = [&](double metres) {
    return std::max(1, static_cast<int>(std::ceil(metres * scale_ - 1e-9)));
  };
  sheet_ = std::make_unique<Sheet>(pixels(size.x) + 2 * kBorder, pixels(size.y) + 3 * kBorder);
  cairo_paint(sheet_->with(paper));
}

Canvas::~Canvas() = default;

Vec2 Canvas::at(Vec2 point) const {
  return {kBorder + scale_ * (point.x - low_.x), kBorder + scale_ * (high_.y - point.y)};
}

void Canvas::fill_rectangle(Vec2 low, Vec2 high, Rgb colour) {
  cairo_t* pen = sheet_->with(colour);
  const Vec2 corner = at({low.x, high.y});
  cairo_rectangle(pen, corner.x, corner.y, to_pixels(high.x - low.x), to_pixels(high.y - low.y));
  cairo_fill(pen);
}

void Canvas::outline_rectangle(Vec2 low, Vec2 high, Rgb colour) {
  cairo_t* pen = sheet_->with(colour);
  const Vec2 corner = at({low.x, high.y});
  cairo_set_line_width(pen, 1.0);
  cairo_rectangle(pen, corner.x, corner.y, to_pixels(high.x - low.x), to_pixels(high.y - low.y));
  cairo_stroke(pen);
}

void Canvas::line(Vec2 a, Vec2 b, double width, Rgb colour) {
  const Vec2 ends[] = {a, b};
  cairo_set_line_cap(sheet_->pen.get(),
                     width > kThinLine ? CAIRO_LINE_CAP_BUTT : CAIRO_LINE_CAP_SQUARE);
  path(ends, width, colour);
}

void Canvas::path(std::span<const Vec2> points, double width, Rgb colour) {
  if (points.size() < 2) return;
  cairo_t* pen = sheet_->with(colour);
  cairo_set_line_width(pen, width);
  cairo_set_line_join(pen, CAIRO_LINE_JOIN_ROUND);
  // Cairo's stroker takes time that grows with the square of a path's length: draw it in pieces.
  constexpr std::size_t kPiece = 200;
  for (std::size_t first = 0; first + 1 < points.size(); first += kPiece) {
    const std::size_t last = std::min(first + kPiece, points.size() - 1);
    for (std::size_t i = first; i <= last; ++i) {
      const Vec2 p = at(points[i]);
      cairo_line_to(pen, p.x, p.y);
    }
    cairo_stroke(pen);
  }
}

void Canvas::disc(Vec2 centre, double radius, Rgb colour) {
  cairo_t* pen = sheet_->with(colour);
  const Vec2 p = at(centre);
  cairo_arc(pen, p.x, p.y, to_pixels(radius), 0.0, 2.0 * kPi);
  cairo_fill(pen);
}

void Canvas::ring(Vec2 centre, double radius, Rgb colour) {
  cairo_t* pen = sheet_->with(colour);
  const Vec2 p = at(centre);
  cairo_set_line_width(pen, 1.0);
  cairo_arc(pen, p.x, p.y, to_pixels(radius), 0.0, 2.0 * kPi);
  cairo_stroke(pen);
}

void Canvas::polygon(std::span<const Vec2> corners, Rgb colour) {
  cairo_t* pen = sheet_->with(colour);
  for (const Vec2 corner : corners) {
    const Vec2 p = at(corner);
    cairo_line_to(pen, p.x, p.y);
  }
  cairo_fill(pen);
}

void Canvas::text(Vec2 where, const std::string& text, double size, Rgb colour) {
  cairo_t* pen = sheet_->with(colour);
  cairo_select_font_face(pen, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_BOLD);
  cairo_set_font_size(pen, size);
  cairo_text_extents_t extents;
  cairo_text_extents(pen, text.c_str(), &extents);
  const Vec2 p = at(where);
  cairo_move_to(pen, p.x - extents.x_bearing - 0.5 * extents.width,
                p.y - extents.y_bearing - 0.5 * extents.height);
  cairo_show_text(pen, text.c_str());
}

void Canvas::scale_bar(double length, const std::string& label, Rgb colour) {
  cairo_t* pen = sheet_->with(colour);
  const double right = kBorder + to_pixels(length);
  const double y = cairo_image_surface_get_height(sheet_->surface.get()) - kBorder + 0.5;
  cairo_set_line_width(pen, 2.0);
  cairo_set_line_cap(pen, CAIRO_LINE_CAP_BUTT);
  cairo_move_to(pen, kBorder, y - 5.0);
  cairo_line_to(pen, kBorder, y);
  cairo_line_to(pen, right, y);
  cairo_line_to(pen, right, y - 5.0);
  cairo_stroke(pen);
  cairo_select_font_face(pen, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(pen, 12.0);
  cairo_move_to(pen, right + 6.0, y);
  cairo_show_text(pen, label.c_str());
}

Frame Canvas::picture() const { return cairo_picture(sheet_->surface.get()); }

}  // namespace eyebridge::camera
