#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "eyebridge/base/units.hpp"
#include "eyebridge/files/floor_plan.hpp"
#include "eyebridge/files/foreign_worlds.hpp"
#include "floor_around.hpp"
#include "left_out.hpp"
#include "stage_entities.hpp"
#include "svg_style.hpp"
#include "world_limits.hpp"

namespace eyebridge::files {
namespace {

constexpr double kDefaultSize = 0.1;  // metres, of a model that does not say it
constexpr int kDarkest = 127;         // greys up to this one are wall
constexpr double kPixelTolerance = 0.75;
constexpr int kMostPoints = 10000;  // of one block
constexpr int kMostBlocks = 10000;  // of one model

/// Walls of a model about its middle, before they are stretched to its size.
struct StageOutline {
  std::vector<std::vector<Vec2>> lines;  ///< Each closed.
  bool is_box = false;                   ///< One rectangle: a wall with a thickness says it, too.
};

/// A `size`: along x and y, and how high; metres.
struct StageSize {
  double x = 0;
  double y = 0;
  double z = 0;
};

class StageReader {
 public:
  StageReader(const std::string& file, const NamedFiles& files, std::vector<Warning>& warnings,
              std::vector<SourceLocation>* start_places)
      : file_(file), files_(files), warnings_(file, warnings), start_places_(start_places) {}

  world::WorldModel read(std::string_view text) {
    const StageEntity world = read_stage_entities(
        text, file_, [this](const std::string& name, const SourceLocation& where) {
          return include(name, where);
        });
    read_units(world);
    for (const auto& [name, property] : world.properties) {
      if (name != "unit_length" && name != "unit_angle") {
        left_out_.add(property.where, "settings of Stage");
      }
    }
    for (const StageEntity& child : world.children) entity(child, {}, 0);
    if (model_.walls.empty()) warnings_.add(1, 1, "a world without walls");
    left_out_.say(warnings_);
    if (!floor_around(model_)) {
      throw ConfigError({file_, 1, 1},
                        "nothing that spans a floor: expected a model with a bitmap, "
                        "blocks or a size");
    }
    return std::move(model_);
  }

 private:
  std::optional<std::string> include(const std::string& name, const SourceLocation& where) {
    try {
      return files_.text(name, where);
    } catch (const ConfigError& error) {
      warnings_.add(where.line, where.column, error.text() + "; what it defines is not known");
      return std::nullopt;
    }
  }

  void read_units(const StageEntity& world) {
    length_ =
        unit_of(world, "unit_length", {{"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}}, "m, cm or mm");
    angle_ = unit_of(world, "unit_angle", {{"degrees", kPi / 180}, {"radians", 1.0}},
                     "degrees or radians");
  }
  /// The first of `units` where the file says none.
  static double unit_of(const StageEntity& world, const char* key,
                        std::initializer_list<std::pair<const char*, double>> units,
                        const char* expected) {
    const auto found = world.properties.find(key);
    if (found == world.properties.end()) return units.begin()->second;
    const std::string word = text_of(found->second);
    for (const auto& [name, value] : units) {
      if (word == name) return value;
    }
    throw ConfigError(found->second.where,
                      std::string(key) + " is " + in_quotes(word) + ": expected " + expected);
  }

  void entity(const StageEntity& e, const Pose& frame, int depth) {
    if (e.base == "window") return left_out_.add(e.where, "settings of Stage");
    if (e.base == "block") return;  // read with its model
    const Pose pose = transform(frame, pose_of(e, "pose"));
    if (is_too_far(pose.position())) {
      throw ConfigError(e.where, "lies more than 10 km from the origin");
    }
    if (e.base == "position") return robot(e, pose);
    if (e.base != "model") {
      return left_out_.add(e.where, "'" + e.type + "', which is " +
                                        (depth == 0 ? "defined in no file" : "a device") +
                                        " (only models and robots are)");
    }
    model(e, pose);
    for (const StageEntity& child : e.children) entity(child, pose, depth + 1);
  }

  void robot(const StageEntity& e, const Pose& pose) {
    if (model_.starts.size() >= kMostStarts) throw ConfigError(e.where, "more than 10000 robots");
    model_.starts.push_back({0, pose});
    if (start_places_ != nullptr) start_places_->push_back(e.where);
    left_out_.add(e.where, "a robot: where it stands is a start");
  }

  void model(const StageEntity& e, const Pose& pose) {
    if (const auto found = e.properties.find("obstacle_return");
        found != e.properties.end() && number_of(found->second, 1) == 0) {
      return left_out_.add(found->second.where, "a model that is no obstacle");
    }
    say_what_is_not_read(e);
    const StageSize size = size_of(e);
    const Pose origin = transform(pose, pose_of(e, "origin"));
    world::Wall wall;
    wall.height = std::clamp(size.z, 0.001, 100.0);
    wall.colour = colour_of(e);
    const StageOutline outline = outline_of(e);
    if (outline.is_box) return add_box(e, origin, size, wall);
    add_lines(e, outline, origin, size, wall);
  }

  void say_what_is_not_read(const StageEntity& e) {
    constexpr std::array<std::string_view, 10> kRead = {
        "pose",  "size",  "origin",  "bitmap",   "name",
        "color", "block", "polygon", "boundary", "obstacle_return"};
    for (const auto& [name, property] : e.properties) {
      const std::string& key = name;  // clang 14: no structured binding in a lambda
      if (std::ranges::any_of(kRead, [&](auto begin) { return key.starts_with(begin); })) continue;
      left_out_.add(property.where, key.starts_with("gui_")
                                        ? "how Stage shows a model (gui_...)"
                                        : "the property '" + key + "' of a model");
    }
  }

  void add_box(const StageEntity& e, const Pose& pose, const StageSize& size, world::Wall wall) {
    const bool is_long = size.x >= size.y;
    const Vec2 half =
        Heading::from_angle(pose.theta).rotate(is_long ? Vec2{size.x / 2, 0} : Vec2{0, size.y / 2});
    wall.thickness = is_long ? size.y : size.x;
    wall.a = pose.position() - half;
    wall.b = pose.position() + half;
    add(e, wall);
  }

  /// Stage moves and stretches all blocks of a model together until they fill its size.
  void add_lines(const StageEntity& e, const StageOutline& outline, const Pose& pose,
                 const StageSize& size, world::Wall wall) {
    Vec2 low{1e300, 1e300};
    Vec2 high{-1e300, -1e300};
    for (const auto& line : outline.lines) {
      for (const Vec2 p : line) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
      }
    }
    const Vec2 middle = 0.5 * (low + high);
    const auto stretch = [](double to, double from) { return from > 0 ? to / from : 0; };
    const Vec2 scale{stretch(size.x, high.x - low.x), stretch(size.y, high.y - low.y)};
    const Heading heading = Heading::from_angle(pose.theta);
    for (const auto& line : outline.lines) {
      for (std::size_t i = 0; i < line.size(); ++i) {
        const auto at = [&](std::size_t k) {
          const Vec2 p = line[k % line.size()] - middle;
          return pose.position() + heading.rotate({p.x * scale.x, p.y * scale.y});
        };
        wall.a = at(i);
        wall.b = at(i + 1);
        if (wall.a != wall.b && !(line.size() == 2 && i == 1)) add(e, wall);
      }
    }
  }

  void add(const StageEntity& e, const world::Wall& wall) {
    add_wall(model_, wall, [&](const std::string& what) { throw ConfigError(e.where, what); });
  }

  // Shapes.
  StageOutline outline_of(const StageEntity& e) {
    StageOutline outline;
    picture_size_ = {};
    if (const auto bitmap = e.properties.find("bitmap");
        bitmap != e.properties.end() && !text_of(bitmap->second).empty()) {
      read_bitmap(bitmap->second, outline);
    }
    for (const StageEntity& child : e.children) {
      if (child.base == "block") read_block(child, "", child.where, outline);
    }
    for (const char* plural : {"block", "polygon"}) {
      read_numbered(e, plural, outline);
    }
    if (const auto edge = e.properties.find("boundary");
        edge != e.properties.end() && number_of(edge->second, 0) != 0) {
      outline.lines.push_back(rim_of(outline));
    }
    outline.is_box = outline.lines.empty();
    return outline;
  }

  /// The rim of the bitmap, or of all blocks.
  std::vector<Vec2> rim_of(const StageOutline& outline) const {
    if (picture_size_.x > 0) {
      return {{0, 0}, {picture_size_.x, 0}, picture_size_, {0, picture_size_.y}};
    }
    Vec2 low{0, 0};
    Vec2 high{1, 1};
    for (const auto& line : outline.lines) {
      for (const Vec2 p : line) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
      }
    }
    return {low, {high.x, low.y}, high, {low.x, high.y}};
  }

  void read_bitmap(const StageProperty& property, StageOutline& outline) {
    const std::string name = text_of(property);
    const GreyPicture picture = files_.picture(name, property.values.front().where);
    picture_size_ = {static_cast<double>(picture.columns), static_cast<double>(picture.rows)};
    for (const auto& corners : outlines_of(picture, kDarkest, kPixelTolerance, name)) {
      std::vector<Vec2> line;
      for (const PixelCorner& corner : corners) {
        line.push_back(
            {static_cast<double>(corner.x), static_cast<double>(picture.rows - corner.y)});
      }
      outline.lines.push_back(std::move(line));
    }
    if (outline.lines.empty()) {
      throw ConfigError(property.values.front().where,
                        in_quotes(name) + " has nothing dark: a model without walls");
    }
  }

  /// "polygons 2 polygon[0].points 4 polygon[0].point[0] [0 0] ...", as Stage 2 writes them.
  void read_numbered(const StageEntity& e, const std::string& kind, StageOutline& outline) {
    const auto found = e.properties.find(kind + "s");
    if (found == e.properties.end()) return;
    const double count = number_of(found->second, 0);
    if (!(count >= 0) || count > kMostBlocks) {
      throw ConfigError(found->second.where, kind + "s: expected 0 to 10000");
    }
    for (int i = 0; i < static_cast<int>(count); ++i) {
      read_block(e, kind + "[" + std::to_string(i) + "].", found->second.where, outline);
    }
  }

  void read_block(const StageEntity& e, const std::string& prefix, const SourceLocation& where,
                  StageOutline& outline) {
    const auto count = e.properties.find(prefix + "points");
    if (count == e.properties.end()) throw ConfigError(where, "a block without 'points'");
    const double points = number_of(count->second, 0);
    if (!(points >= 3) || points > kMostPoints) {
      throw ConfigError(count->second.where, "points: expected 3 to 10000");
    }
    std::vector<Vec2> line;
    for (int i = 0; i < static_cast<int>(points); ++i) {
      const std::string key = prefix + "point[" + std::to_string(i) + "]";
      const auto point = e.properties.find(key);
      if (point == e.properties.end()) throw ConfigError(count->second.where, "expected " + key);
      const std::vector<double> xy = numbers_of(point->second);
      if (xy.size() != 2) throw ConfigError(point->second.where, key + ": expected 2 numbers");
      line.push_back({xy[0], xy[1]});
    }
    outline.lines.push_back(std::move(line));
  }

  // Values.
  StageSize size_of(const StageEntity& e) const {
    const auto found = e.properties.find("size");
    if (found == e.properties.end()) {
      return {kDefaultSize, kDefaultSize, world::Wall::kDefaultHeight};
    }
    const std::vector<double> v = numbers_of(found->second);
    if (v.size() != 2 && v.size() != 3) {
      throw ConfigError(found->second.where, "size: expected 2 or 3 numbers");
    }
    for (const double side : {v[0] * length_, v[1] * length_}) {
      if (!(side > 0) || side > mm_to_m(kMaxMillimetres)) {
        throw ConfigError(found->second.where, "size: expected more than 0, at most 10 km");
      }
    }
    return {v[0] * length_, v[1] * length_,
            v.size() == 3 ? v[2] * length_ : world::Wall::kDefaultHeight};
  }

  /// [x y heading], or with the height before the heading.
  Pose pose_of(const StageEntity& e, const char* key) const {
    const auto found = e.properties.find(key);
    if (found == e.properties.end()) return {};
    const std::vector<double> v = numbers_of(found->second);
    if (v.size() != 3 && v.size() != 4) {
      throw ConfigError(found->second.where, std::string(key) + ": expected 3 or 4 numbers");
    }
    return {v[0] * length_, v[1] * length_, wrap_angle(v.back() * angle_)};
  }

  Rgb colour_of(const StageEntity& e) {
    if (const auto rgba = e.properties.find("color_rgba"); rgba != e.properties.end()) {
      const std::vector<double> v = numbers_of(rgba->second);
      if (v.size() >= 3) {
        const auto byte = [](double share) {
          return static_cast<std::uint8_t>(std::lround(std::clamp(share, 0.0, 1.0) * 255));
        };
        return {byte(v[0]), byte(v[1]), byte(v[2])};
      }
    }
    if (const auto color = e.properties.find("color"); color != e.properties.end()) {
      const SvgPaint paint = read_svg_paint(text_of(color->second));
      if (paint.kind == SvgPaint::Kind::Colour) return paint.colour;
      left_out_.add(color->second.where, "the colour " + in_quotes(text_of(color->second)));
    }
    return world::Wall::kDefaultColour;
  }

  static std::string text_of(const StageProperty& property) {
    return property.values.size() == 1 ? property.values.front().text : "";
  }
  static double number_of(const StageProperty& property, double otherwise) {
    return property.values.size() == 1 ? property.values.front().number.value_or(otherwise)
                                       : otherwise;
  }
  static std::vector<double> numbers_of(const StageProperty& property) {
    std::vector<double> numbers;
    for (const StageValue& value : property.values) {
      if (!value.number || std::fabs(*value.number) > 1e9) {
        throw ConfigError(value.where, "found " + in_quotes(value.text) + ": expected a number");
      }
      numbers.push_back(*value.number);
    }
    return numbers;
  }

  const std::string& file_;
  const NamedFiles& files_;
  Warnings warnings_;
  std::vector<SourceLocation>* start_places_;
  LeftOut left_out_;
  world::WorldModel model_;
  Vec2 picture_size_;  ///< Of the bitmap read last, pixels.
  double length_ = 1.0;
  double angle_ = kPi / 180;
};

}  // namespace

world::WorldModel read_stage(std::string_view text, const std::string& file,
                             const NamedFiles& files, std::vector<Warning>& warnings,
                             std::vector<SourceLocation>* start_places) {
  return StageReader(file, files, warnings, start_places).read(text);
}

}  // namespace eyebridge::files
