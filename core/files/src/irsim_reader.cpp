#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "eyebridge/base/units.hpp"
#include "eyebridge/files/floor_plan.hpp"
#include "eyebridge/files/foreign_worlds.hpp"
#include "floor_around.hpp"
#include "left_out.hpp"
#include "world_limits.hpp"

namespace eyebridge::files {
namespace {

constexpr std::size_t kLargestIrsim = 4U << 20U;
constexpr std::size_t kMostThings = 10000;  // of a kind
constexpr int kDarkest = 127;
constexpr double kPixelTolerance = 0.75;

/// One shape of an obstacle, about its own pose.
struct IrsimShape {
  std::string name;
  double radius = 0;
  Vec2 size;
  std::vector<Vec2> points;
};

class IrsimReader {
 public:
  IrsimReader(const std::string& file, const NamedFiles& files, std::vector<Warning>& warnings,
              std::vector<SourceLocation>* start_places)
      : file_(file), files_(files), warnings_(file, warnings), start_places_(start_places) {}

  world::WorldModel read(const std::string& text) {
    if (text.size() > kLargestIrsim) throw ConfigError({file_, 0, 0}, "more than 4 MiB of YAML");
    try {
      return read(YAML::Load(text));
    } catch (const YAML::Exception& error) {
      throw ConfigError(where(error.mark), error.msg);
    }
  }

 private:
  world::WorldModel read(const YAML::Node& root) {
    if (!root.IsMap()) throw ConfigError({file_, 1, 1}, "expected 'world:', 'robot:', 'obstacle:'");
    for (const auto& entry : root) {
      const std::string key = scalar(entry.first);
      if (key == "world") {
        world(entry.second);
      } else if (key == "obstacle") {
        each(entry.second, [&](const YAML::Node& node) { things(node, false); });
      } else if (key == "robot") {
        each(entry.second, [&](const YAML::Node& node) { things(node, true); });
      } else {
        leave_out(entry.first, "'" + printable(key) + "'");
      }
    }
    left_out_.say(warnings_);
    if (model_.width <= 0 && !floor_around(model_)) {
      throw ConfigError({file_, 1, 1}, "no floor: expected 'world:' with width and height, metres");
    }
    return std::move(model_);
  }

  [[nodiscard]] SourceLocation where(const YAML::Mark& mark) const {
    return {file_, mark.line + 1, mark.column + 1};
  }
  [[noreturn]] void refuse(const YAML::Node& node, const std::string& what) const {
    throw ConfigError(where(node.Mark()), what);
  }
  void leave_out(const YAML::Node& node, const std::string& what) {
    left_out_.add(where(node.Mark()), what);
  }
  static std::string scalar(const YAML::Node& node) {
    return node.IsDefined() && node.IsScalar() ? node.Scalar() : std::string();
  }

  /// A list, or one thing in its place.
  template <class Take>
  void each(const YAML::Node& node, Take take) {
    if (node.IsNull()) return;
    if (!node.IsSequence()) return take(node);
    for (const YAML::Node& item : node) take(item);
  }

  [[nodiscard]] double number(const YAML::Node& node, const std::string& what) const {
    const std::string text = scalar(node);
    const auto value = parse_number(text);
    if (!value || std::fabs(*value) > mm_to_m(kMaxMillimetres)) {
      refuse(node, in_quotes(text) + " found: expected " + what + ", a number");
    }
    return *value;
  }
  [[nodiscard]] double above_zero(const YAML::Node& node, const std::string& what) const {
    const double value = number(node, what);
    if (!(value > 0)) refuse(node, what + ": expected more than 0");
    return value;
  }
  [[nodiscard]] Vec2 point(const YAML::Node& node) const {
    if (!node.IsSequence() || node.size() < 2) refuse(node, "expected a point, [x, y]");
    return {number(node[0], "x"), number(node[1], "y")};
  }

  // world:
  void world(const YAML::Node& node) {
    if (!node.IsMap()) refuse(node, "world: expected width and height");
    YAML::Node map;
    for (const auto& entry : node) {
      const std::string key = scalar(entry.first);
      if (key == "width") {
        model_.width = above_zero(entry.second, key);
      } else if (key == "height") {
        model_.height = above_zero(entry.second, key);
      } else if (key == "offset") {
        model_.corner = point(entry.second);
      } else if (key == "obstacle_map") {
        map = entry.second;
      } else {
        leave_out(entry.first, "settings of IR-SIM's world");
      }
    }
    if ((model_.width > 0) != (model_.height > 0)) refuse(node, "width and height: expected both");
    if (map.IsDefined() && !map.IsNull()) picture(map);
  }

  /// A picture as large as the floor: what is dark is wall.
  void picture(const YAML::Node& node) {
    const YAML::Node path = node.IsMap() ? node["path"] : node;
    if (!path.IsDefined() || !path.IsScalar()) {
      return leave_out(node, "an obstacle map that is made while IR-SIM runs");
    }
    if (model_.width <= 0) refuse(node, "obstacle_map: expected width and height of the world");
    const GreyPicture grey = files_.picture(path.Scalar(), where(path.Mark()));
    for (const auto& outline : outlines_of(grey, kDarkest, kPixelTolerance, path.Scalar())) {
      std::vector<Vec2> points;
      for (const PixelCorner& corner : outline) {
        points.push_back(model_.corner + Vec2{model_.width * corner.x / grey.columns,
                                              model_.height * (grey.rows - corner.y) / grey.rows});
      }
      lines(node, points, true);
    }
  }

  // robot: and obstacle:
  void things(const YAML::Node& node, bool is_robot) {
    if (!node.IsMap()) refuse(node, "expected a robot or an obstacle: shape, state, ...");
    std::vector<IrsimShape> shapes;
    std::vector<Pose> states;
    std::size_t number_of_them = 1;
    bool is_drawn = false;  // where they are
    for (const auto& entry : node) {
      const std::string key = scalar(entry.first);
      if (key == "shape") {
        if (is_robot) continue;  // ours are those of EyeBot
        each(entry.second, [&](const YAML::Node& shape) {
          if (shape.IsMap() && scalar(shape["random_shape"]) == "true") {
            return leave_out(shape, "shapes that are drawn (random_shape)");
          }
          shapes.push_back(shape_of(shape));
        });
      } else if (key == "state") {
        states = states_of(entry.second);
      } else if (key == "number") {
        const double count = number(entry.second, key);
        if (count < 0 || count > static_cast<double>(kMostThings)) {
          refuse(entry.second, "number: expected 0 to 10000");
        }
        number_of_them = static_cast<std::size_t>(count);
      } else if (key == "distribution") {
        const std::string way =
            entry.second.IsMap() ? scalar(entry.second["name"]) : scalar(entry.second);
        if (way != "manual") {
          is_drawn = true;
          leave_out(entry.first, "places that are drawn (distribution: " + printable(way) + ")");
        }
      } else if (key != "name" && key != "description") {
        leave_out(entry.first,
                  std::string(is_robot ? "a robot's '" : "an obstacle's '") + printable(key) + "'");
      }
    }
    if (states.size() < number_of_them && !states.empty()) {
      leave_out(node, is_robot ? "robots without a state" : "obstacles without a state");
    }
    if (states.empty() && !is_drawn) states.push_back({});  // as IR-SIM: at the origin
    if (number_of_them < states.size()) states.resize(number_of_them);
    for (std::size_t i = 0; i < states.size(); ++i) {
      if (is_robot) {
        start(node, states[i]);
      } else if (!shapes.empty()) {
        obstacle(node, shapes[std::min(i, shapes.size() - 1)], states[i]);
      }
    }
    if (!is_robot && shapes.empty() && !is_drawn) leave_out(node, "obstacles without a shape");
  }

  [[nodiscard]] std::vector<Pose> states_of(const YAML::Node& node) const {
    if (!node.IsSequence() || node.size() == 0) refuse(node, "state: expected [x, y, heading]");
    const auto pose = [&](const YAML::Node& state) {
      const Vec2 p = point(state);
      return Pose{p.x, p.y, state.size() > 2 ? wrap_angle(number(state[2], "heading")) : 0};
    };
    if (!node[0].IsSequence()) return {pose(node)};
    std::vector<Pose> states;
    for (const YAML::Node& state : node) {
      if (states.size() == kMostThings) refuse(state, "more than 10000 of a kind");
      states.push_back(pose(state));
    }
    return states;
  }

  [[nodiscard]] IrsimShape shape_of(const YAML::Node& node) const {
    if (!node.IsMap()) refuse(node, "shape: expected {name: circle, radius: 1}, or another one");
    IrsimShape shape;
    shape.name = scalar(node["name"]);
    if (shape.name == "circle") {
      shape.radius = node["radius"] ? above_zero(node["radius"], "radius") : 0.2;
    } else if (shape.name == "rectangle") {
      shape.size = {node["length"] ? above_zero(node["length"], "length") : 0.2,
                    node["width"] ? above_zero(node["width"], "width") : 0.1};
    } else if (shape.name == "polygon" || shape.name == "linestring") {
      const YAML::Node list = node["vertices"];
      if (!list || !list.IsSequence() || list.size() < 2) {
        refuse(node, "a " + shape.name + " without vertices: expected a list of points");
      }
      for (const YAML::Node& vertex : list) {
        if (shape.points.size() == kMostThings) refuse(vertex, "more than 10000 vertices");
        shape.points.push_back(point(vertex));
      }
    } else {
      refuse(node, "shape " + in_quotes(shape.name) +
                       ": expected circle, rectangle, polygon or linestring");
    }
    return shape;
  }

  void start(const YAML::Node& node, const Pose& pose) {
    if (model_.starts.size() == kMostThings) refuse(node, "more than 10000 robots");
    model_.starts.push_back({0, pose});
    if (start_places_ != nullptr) start_places_->push_back(where(node.Mark()));
    leave_out(node, "a robot: where it stands is a start");
  }

  void obstacle(const YAML::Node& node, const IrsimShape& shape, const Pose& pose) {
    const Heading heading = Heading::from_angle(pose.theta);
    std::vector<Vec2> points;
    for (const Vec2 p : shape.points) points.push_back(pose.position() + heading.rotate(p));
    if (!points.empty()) return lines(node, points, shape.name == "polygon");
    if (shape.radius == 0) {
      const Vec2 half = 0.5 * shape.size.x * heading.forward();
      world::Wall wall{pose.position() - half, pose.position() + half};
      wall.thickness = shape.size.y;
      return add(node, wall);
    }
    world::ObjectSpec can;
    can.kind = world::ObjectKind::Can;
    can.name = "can";
    can.pose = pose;
    can.radius = shape.radius;
    can.height = world::Wall::kDefaultHeight;
    can.colour = world::Wall::kDefaultColour;
    can.matter.fixed = true;
    if (model_.objects.size() == kMostThings) refuse(node, "more than 10000 obstacles");
    model_.objects.push_back(can);
  }

  void lines(const YAML::Node& node, const std::vector<Vec2>& points, bool is_closed) {
    const std::size_t count = points.size();
    const std::size_t sides = is_closed && count > 2 ? count : count - 1;
    for (std::size_t i = 0; i < sides; ++i) add(node, {points[i], points[(i + 1) % count]});
  }
  void add(const YAML::Node& node, const world::Wall& wall) {
    add_wall(model_, wall, [&](const std::string& what) { refuse(node, what); });
  }

  const std::string& file_;
  const NamedFiles& files_;
  Warnings warnings_;
  std::vector<SourceLocation>* start_places_;
  LeftOut left_out_;
  world::WorldModel model_;
};

}  // namespace

world::WorldModel read_irsim(std::string_view text, const std::string& file,
                             const NamedFiles& files, std::vector<Warning>& warnings,
                             std::vector<SourceLocation>* start_places) {
  check_text(text, file);
  return IrsimReader(file, files, warnings, start_places).read(std::string(without_bom(text)));
}

bool is_irsim(std::string_view text) {
  const auto begins_a_line = [&](std::string_view key) {
    return text.starts_with(key) || text.find("\n" + std::string(key)) != std::string_view::npos;
  };
  return !begins_a_line("image:") &&
         (begins_a_line("world:") || begins_a_line("robot:") || begins_a_line("obstacle:"));
}

}  // namespace eyebridge::files
