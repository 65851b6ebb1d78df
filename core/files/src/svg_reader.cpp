#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <pugixml.hpp>

#include "eyebridge/base/units.hpp"
#include "eyebridge/files/foreign_worlds.hpp"
#include "floor_around.hpp"
#include "left_out.hpp"
#include "svg_path.hpp"
#include "svg_style.hpp"
#include "text.hpp"
#include "world_limits.hpp"

namespace eyebridge::files {
namespace {

constexpr double kTolerance = 0.5;  // millimetres that straight pieces may miss a curve by
constexpr int kMostNested = 200;
constexpr double kThickest = 100;  // metres, of a wall

/// What an element hands on to those in it.
struct Inherited {
  SvgTransform to_page;
  SvgPaint fill{SvgPaint::Kind::Colour, {}};
  SvgPaint stroke{};
  double stroke_width = 1;
};

class SvgReader {
 public:
  SvgReader(std::string_view text, const std::string& file, std::vector<Warning>& warnings,
            std::vector<SourceLocation>* start_places)
      : text_(text), file_(file), warnings_(file, warnings), start_places_(start_places) {}

  world::WorldModel read() {
    pugi::xml_document document;
    const pugi::xml_parse_result result =
        document.load_buffer(text_.data(), text_.size(), pugi::parse_default, pugi::encoding_utf8);
    if (!result) {
      throw ConfigError(place(static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0))),
                        std::string("not well-formed XML: ") + result.description());
    }
    const pugi::xml_node root = document.document_element();
    if (local_name(root) != "svg") throw ConfigError(place(root), "no <svg>: expected a drawing");
    read_page(root);
    Inherited style;
    children_of(root, style_of(root, style), 0);
    if (!has_page_) fit_floor();
    say_what_is_left();
    return std::move(model_);
  }

 private:
  // Where things are in the file.
  [[nodiscard]] SourceLocation place(std::size_t offset) const {
    const std::string_view before = text_.substr(0, std::min(offset, text_.size()));
    const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
    return {file_, static_cast<int>(std::ranges::count(before, '\n')) + 1,
            static_cast<int>(before.size() - line_start) + 1};
  }
  [[nodiscard]] SourceLocation place(const pugi::xml_node& node) const {
    return place(static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0)));
  }
  [[noreturn]] void refuse(const pugi::xml_node& node, const std::string& what) const {
    throw ConfigError(place(node), "<" + printable(node.name()) + ">: " + what);
  }
  void warn(const pugi::xml_node& node, const std::string& what) {
    const SourceLocation where = place(node);
    warnings_.add(where.line, where.column, what);
  }
  void leave_out(const pugi::xml_node& node, const std::string& what) {
    left_out_.add(place(node), what);
  }
  void say_what_is_left() {
    left_out_.say(warnings_);
    if (model_.walls.empty()) warnings_.add(1, 1, "a drawing without walls");
  }

  static std::string_view local_name(const pugi::xml_node& node) {
    const std::string_view name = node.name();
    return name.substr(name.find(':') + 1);  // npos + 1 is 0
  }

  // The page.
  void read_page(const pugi::xml_node& root) {
    const auto width = length_of(root, "width");
    const auto height = length_of(root, "height");
    std::optional<std::vector<double>> box;
    if (const char* written = root.attribute("viewBox").value(); *written != '\0') {
      box = numbers(root, written);
      if (box->size() != 4 || (*box)[2] <= 0 || (*box)[3] <= 0) {
        refuse(root, "viewBox: expected 4 numbers, the last two above 0");
      }
    }
    const auto units = [](const std::optional<SvgLength>& length) {
      return length ? length->units() : std::nullopt;
    };
    if (!box && units(width) && units(height)) box = {0, 0, *units(width), *units(height)};
    has_page_ = box.has_value();
    if (box) {
      page_low_ = {(*box)[0], (*box)[1] + (*box)[3]};
      page_size_ = {(*box)[2], (*box)[3]};
    }
    scale_ = page_scale(root, width, height);
    const double metres = mm_to_m(scale_);
    if (const char* corner = root.attribute("data-corner").value(); *corner != '\0') {
      const auto xy = numbers(root, corner);
      if (xy.size() != 2) refuse(root, "data-corner: expected 2 numbers, millimetres");
      model_.corner = {mm_to_m(xy[0]), mm_to_m(xy[1])};
    }
    if (!has_page_) return;
    model_.width = page_size_.x * metres;
    model_.height = page_size_.y * metres;
    check_reach(root, model_.far_corner());
    if (!(model_.width >= 0.001) || !(model_.height >= 0.001)) {
      refuse(root, "a page smaller than a millimetre");
    }
  }

  /// Millimetres a unit of the drawing.
  double page_scale(const pugi::xml_node& root, const std::optional<SvgLength>& width,
                    const std::optional<SvgLength>& height) {
    const auto mm = [](const std::optional<SvgLength>& length) {
      return length ? length->millimetres() : std::nullopt;
    };
    std::optional<double> scale;
    if (has_page_ && mm(width)) scale = *mm(width) / page_size_.x;
    if (has_page_ && mm(height)) {
      // As a viewer does that shows all of a drawing (preserveAspectRatio: meet).
      const double other = *mm(height) / page_size_.y;
      scale = scale ? std::min(*scale, other) : other;
    }
    if (scale && *scale > 0) return *scale;
    warn(root,
         "no size in millimetres: a unit of the drawing is taken as 1 mm; expected "
         "width=\"...mm\", height and viewBox");
    return 1.0;
  }

  std::optional<SvgLength> length_of(const pugi::xml_node& node, const char* name) const {
    const char* written = node.attribute(name).value();
    if (*written == '\0') return std::nullopt;
    const auto length = read_svg_length(written);
    if (!length || std::fabs(length->value) > 1e9) {
      refuse(node, std::string(name) + " is " + in_quotes(written) + ": expected a length");
    }
    return length;
  }
  /// In units of the drawing; per cents are of the page.
  double units_of(const pugi::xml_node& node, const char* name, double otherwise = 0) const {
    const auto length = length_of(node, name);
    if (!length) return otherwise;
    if (const auto units = length->units()) return *units;
    if (length->unit == "%" && has_page_) {
      const std::string_view which = name;
      const double of = which.find('x') != std::string_view::npos || which == "width"
                            ? page_size_.x
                            : page_size_.y;
      return length->value / 100 * of;
    }
    refuse(node, std::string(name) + " is " + in_quotes(node.attribute(name).value()) +
                     ": expected a unit such as mm, or none");
  }
  std::vector<double> numbers(const pugi::xml_node& node, const char* text) const {
    try {
      return read_svg_numbers(text);
    } catch (const SvgPathError& error) {
      refuse(node, error.what());
    }
  }

  // Elements.
  void children_of(const pugi::xml_node& parent, const Inherited& style, int depth) {
    if (depth > kMostNested) refuse(parent, "groups nested more than 200 deep");
    for (const pugi::xml_node& node : parent.children()) {
      if (node.type() == pugi::node_element) element(node, style, depth);
    }
  }

  void element(const pugi::xml_node& node, const Inherited& outer, int depth) {
    const std::string_view name = local_name(node);
    constexpr std::array<std::string_view, 6> kSilent = {"defs", "metadata",  "title",
                                                         "desc", "namedview", "script"};
    if (std::ranges::find(kSilent, name) != kSilent.end()) return;
    if (name == "style") return leave_out(node, "style sheets (styles of elements are read)");
    if (is_hidden(node)) return leave_out(node, "hidden elements");
    const Inherited style = style_of(node, outer);
    if (name == "g" || name == "a") return children_of(node, style, depth + 1);
    const bool is_start = std::string_view(node.attribute("class").value()) == "start";
    if (is_start && name == "circle") return take_start(node, style);
    const auto lines = lines_of(node, name, style);
    if (!lines) return leave_out(node, "<" + printable(name) + ">");
    for (const SvgLine& line : *lines) add_walls(node, line, style);
  }

  static bool is_hidden(const pugi::xml_node& node) {
    return property(node, "display") == "none" || property(node, "visibility") == "hidden" ||
           property(node, "opacity") == "0";
  }

  /// A property, of `style` or an attribute of its own; empty: neither.
  static std::string property(const pugi::xml_node& node, std::string_view name) {
    std::string_view style = node.attribute("style").value();
    while (!style.empty()) {
      const std::size_t end = std::min(style.find(';'), style.size());
      const std::string_view rule = style.substr(0, end);
      const std::size_t colon = rule.find(':');
      if (colon != std::string_view::npos && trimmed(rule.substr(0, colon)) == name) {
        return std::string(trimmed(rule.substr(colon + 1)));
      }
      style.remove_prefix(std::min(end + 1, style.size()));
    }
    return node.attribute(std::string(name).c_str()).value();
  }
  Inherited style_of(const pugi::xml_node& node, const Inherited& outer) {
    Inherited style = outer;
    try {
      style.to_page = outer.to_page.after(read_svg_transform(node.attribute("transform").value()));
    } catch (const SvgPathError& error) {
      refuse(node, std::string("transform: ") + error.what());
    }
    if (const std::string fill = property(node, "fill"); !fill.empty() && fill != "inherit") {
      style.fill = read_svg_paint(fill);
    }
    if (const std::string stroke = property(node, "stroke");
        !stroke.empty() && stroke != "inherit") {
      style.stroke = read_svg_paint(stroke);
    }
    if (const std::string width = property(node, "stroke-width"); !width.empty()) {
      const auto length = read_svg_length(width);
      const auto units = length ? length->units() : std::nullopt;
      if (!units || *units < 0) {
        refuse(node, "stroke-width is " + in_quotes(width) + ": expected a length, at least 0");
      }
      style.stroke_width = *units;
    }
    return style;
  }

  /// What an element draws, in its own units; nothing: no shape.
  std::optional<std::vector<SvgLine>> lines_of(const pugi::xml_node& node, std::string_view name,
                                               const Inherited& style) const {
    const double longer = style.to_page.scale() * scale_;
    const double tolerance = longer > 0 ? kTolerance / longer : kTolerance;
    const auto units = [&](const char* key, double otherwise = 0) {
      return units_of(node, key, otherwise);
    };
    if (name == "path") {
      try {
        return read_svg_path(node.attribute("d").value(), tolerance);
      } catch (const SvgPathError& error) {
        refuse(node, "d: character " + std::to_string(error.offset() + 1) + ": " + error.what());
      }
    }
    if (name == "rect") {
      const Vec2 at{units("x"), units("y")};
      const Vec2 size{units("width"), units("height")};
      if (size.x < 0 || size.y < 0) refuse(node, "a size below 0");
      if (size.x == 0 && size.y == 0) return std::vector<SvgLine>{};
      return std::vector<SvgLine>{
          {{at, at + Vec2{size.x, 0}, at + size, at + Vec2{0, size.y}}, true}};
    }
    if (name == "circle" || name == "ellipse") {
      const double rx = units(name == "circle" ? "r" : "rx");
      const double ry = name == "circle" ? rx : units("ry");
      if (rx < 0 || ry < 0) refuse(node, "a radius below 0");
      if (rx == 0 || ry == 0) return std::vector<SvgLine>{};
      return std::vector<SvgLine>{svg_ellipse({units("cx"), units("cy")}, rx, ry, tolerance)};
    }
    if (name == "line") {
      return std::vector<SvgLine>{
          {{{units("x1"), units("y1")}, {units("x2"), units("y2")}}, false}};
    }
    if (name == "polyline" || name == "polygon") {
      const std::vector<double> list = numbers(node, node.attribute("points").value());
      if (list.size() % 2 != 0) refuse(node, "points: expected pairs of numbers");
      SvgLine line{{}, name == "polygon"};
      for (std::size_t i = 0; i < list.size(); i += 2)
        line.points.push_back({list[i], list[i + 1]});
      return std::vector<SvgLine>{line};
    }
    return std::nullopt;
  }

  [[nodiscard]] Vec2 in_world(const pugi::xml_node& node, Vec2 p) const {
    const double metres = mm_to_m(scale_);
    const Vec2 world =
        model_.corner + Vec2{(p.x - page_low_.x) * metres, (page_low_.y - p.y) * metres};
    check_reach(node, world);
    return world;
  }
  void check_reach(const pugi::xml_node& node, Vec2 world) const {
    if (is_too_far(world)) refuse(node, "lies more than 10 km from the origin");
  }

  void add_walls(const pugi::xml_node& node, const SvgLine& line, const Inherited& style) {
    const bool is_line = local_name(node) == "line";
    const bool is_filled = style.fill.kind != SvgPaint::Kind::None && !is_line;
    const bool is_stroked = style.stroke.kind != SvgPaint::Kind::None && style.stroke_width > 0;
    if (!is_filled && !is_stroked) return leave_out(node, "shapes that nothing fills or strokes");
    // An outline that is filled is the rim of something, however wide its stroke is.
    const SvgPaint& paint = is_filled ? style.fill : style.stroke;
    if (paint.kind == SvgPaint::Kind::Colour && paint.colour == Rgb{255, 255, 255} &&
        (!is_filled || !is_stroked)) {
      return leave_out(node, "white shapes (white is the paper)");
    }
    if (paint.kind == SvgPaint::Kind::Other) leave_out(node, "colours (gradients, other names)");
    world::Wall wall;
    if (paint.kind == SvgPaint::Kind::Colour && paint.colour != Rgb{}) wall.colour = paint.colour;
    if (!is_filled) {
      wall.thickness = mm_to_m(style.stroke_width * style.to_page.scale() * scale_);
      if (!(wall.thickness <= kThickest)) refuse(node, "a stroke wider than 100 m");
    }
    const std::size_t count = line.points.size();
    const std::size_t sides = line.closed || is_filled ? count : count - 1;
    for (std::size_t i = 0; i < sides && count > 1; ++i) {
      wall.a = in_world(node, style.to_page.apply(line.points[i]));
      wall.b = in_world(node, style.to_page.apply(line.points[(i + 1) % count]));
      if (count == 2 && i == 1) continue;  // the way back
      add_wall(model_, wall, [&](const std::string& what) { refuse(node, what); });
    }
  }

  void take_start(const pugi::xml_node& node, const Inherited& style) {
    if (model_.starts.size() >= kMostStarts) refuse(node, "more than 10000 starts");
    const Vec2 at =
        in_world(node, style.to_page.apply({units_of(node, "cx"), units_of(node, "cy")}));
    double heading = 0;
    if (const char* written = node.attribute("data-heading").value(); *written != '\0') {
      const auto list = numbers(node, written);
      if (list.size() != 1) refuse(node, "data-heading: expected degrees");
      heading = deg_to_rad(list[0]);
    }
    model_.starts.push_back({0, {at.x, at.y, wrap_angle(heading)}});
    if (start_places_ != nullptr) start_places_->push_back(place(node));
  }

  void fit_floor() {
    if (!floor_around(model_)) {
      throw ConfigError({file_, 1, 1}, "no page and no walls: expected width, height and viewBox");
    }
    warnings_.add(1, 1, "no page: the floor reaches around the walls");
  }

  std::string_view text_;
  const std::string& file_;
  Warnings warnings_;
  std::vector<SourceLocation>* start_places_;
  LeftOut left_out_;
  world::WorldModel model_;
  bool has_page_ = false;
  Vec2 page_low_;     ///< Its lower left corner, in units of the drawing.
  Vec2 page_size_;    ///< In units of the drawing.
  double scale_ = 1;  ///< Millimetres a unit.
};

}  // namespace

world::WorldModel read_svg(std::string_view text, const std::string& file,
                           std::vector<Warning>& warnings,
                           std::vector<SourceLocation>* start_places) {
  return SvgReader(text, file, warnings, start_places).read();
}

}  // namespace eyebridge::files
