#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "eyebridge/base/units.hpp"
#include "eyebridge/files/readers.hpp"
#include "ground.hpp"
#include "text.hpp"
#include "world_limits.hpp"

namespace eyebridge::files {
namespace {

constexpr std::size_t kMaxNesting = 1000;  // one published world nests 83 frames
constexpr std::array<std::string_view, 8> kWorldKeywords = {
    "floor", "width", "height", "push", "pop", "position", "floor_texture", "water"};

struct Frame {
  Pose pose;
  SourceLocation where;
};

class WorldReader {
 public:
  WorldReader(std::string_view text, const std::string& file, std::vector<Warning>& warnings,
              std::vector<SourceLocation>* start_places, Reading reading)
      : statements_(text, file),
        file_(file),
        warnings_(file, warnings),
        start_places_(start_places),
        reading_(reading) {}

  world::WorldModel read() {
    bool any = false;
    read_lines(statements_, warnings_, reading_, [&](const Statement& s) {
      read_statement(s);
      any = true;
    });
    if (!any) {
      throw ConfigError({file_, std::max(1, statements_.line()), 1},
                        "nothing in the file: expected a world ('floor W H', then walls)");
    }
    if (!frames_.empty()) {
      warnings_.add(
          frames_.back().where.line, frames_.back().where.column,
          std::to_string(frames_.size()) + " 'push' without 'pop' at the end of the file");
    }
    finish_size();
    warn_of_walls_outside();
    return std::move(model_);
  }

 private:
  void read_statement(const Statement& s) {
    const std::string keyword = lower(s.text(0));
    if (s.is_number(0)) {
      read_wall(s);
    } else if (keyword == "floor") {
      s.expect_arguments(2, "floor WIDTH HEIGHT");
      set_size(s, width_, 1, "width");
      set_size(s, height_, 2, "height");
    } else if (keyword == "width") {
      s.expect_arguments(1, "width MM");
      set_size(s, width_, 1, "width");
    } else if (keyword == "height") {
      s.expect_arguments(1, "height MM");
      set_size(s, height_, 1, "height");
    } else if (keyword == "push") {
      if (frames_.size() >= kMaxNesting) {
        s.fail(0, "'push' nested " + std::to_string(kMaxNesting + 1) + " deep: expected at most " +
                      std::to_string(kMaxNesting));
      }
      frames_.push_back({read_pose(s, "push X Y PHI"), s.where(0)});
    } else if (keyword == "pop") {
      s.expect_arguments(0, "pop");
      if (frames_.empty()) s.fail(0, "'pop' without 'push': expected a 'push X Y PHI' before it");
      frames_.pop_back();
    } else if (keyword == "position") {
      if (model_.starts.size() >= kMostStarts) s.fail(0, "more than 10000 start positions");
      model_.starts.push_back({0, read_pose(s, "position X Y PHI")});
      if (start_places_ != nullptr) start_places_->push_back(s.where(0));
    } else if (keyword == "floor_texture") {
      s.expect_arguments(1, "floor_texture FILE");
      if (model_.floor_texture)
        warnings_.add(s.line(), 1, "a second floor_texture: this one counts");
      model_.floor_texture = std::string(s.text(1));
    } else if (keyword == "water") {
      read_water(s, model_.water);
    } else {
      const std::string_view near = nearest(keyword, kWorldKeywords);
      s.fail(0, "unknown keyword " + in_quotes(s.text(0)) + ": expected " +
                    (near.empty() ? "a wall (4, 6 or 9 numbers), " + one_of(kWorldKeywords)
                                  : in_quotes(near) + "?"));
    }
  }

  void set_size(const Statement& s, std::optional<double>& size, std::size_t i,
                std::string_view name) {
    if (size) s.fail(0, "the " + std::string(name) + " is given a second time: expected it once");
    size = s.millimetres(i, name, 1, kMaxMillimetres);
    size_where_ = s.where(0);
  }

  /// "KEYWORD x y phi" of the current frame, in the world.
  Pose read_pose(const Statement& s, std::string_view form) {
    s.expect_arguments(3, form);
    Pose pose;
    pose.x = s.millimetres(1, "x");
    pose.y = s.millimetres(2, "y");
    pose.theta = wrap_angle(s.degrees(3, "phi"));
    if (frames_.empty()) return pose;
    pose = transform(frames_.back().pose, pose);
    check_reach(s, pose.position());
    return pose;
  }

  void read_wall(const Statement& s) {
    if (s.size() != 4 && s.size() != 6 && s.size() != 9) {
      const std::string found = std::to_string(s.size());
      s.fail(s.size() > 9 ? 9 : s.size(),
             "wall of " + found +
                 " values: expected 4 (x1 y1 x2 y2), 6 (... thickness height) or "
                 "9 (... red green blue)");
    }
    if (model_.walls.size() >= kMostWalls) {
      s.fail(0, "more than " + std::to_string(kMostWalls) + " walls");
    }
    world::Wall wall;
    wall.a = point(s, {s.millimetres(0, "x1"), s.millimetres(1, "y1")});
    wall.b = point(s, {s.millimetres(2, "x2"), s.millimetres(3, "y2")});
    if (wall.a == wall.b) s.fail(0, "wall of zero length: expected two different ends");
    wall.thickness = world::Wall::kFileThickness;
    if (s.size() >= 6) {
      wall.thickness = s.millimetres(4, "thickness", 0, 1e5);
      wall.height = s.millimetres(5, "height", 0.001, 1e5);
    }
    if (s.size() == 9) {
      const auto channel = [&](std::size_t i, std::string_view name) {
        return static_cast<std::uint8_t>(s.integer(i, name, 0, 255));
      };
      wall.colour = {channel(6, "red"), channel(7, "green"), channel(8, "blue")};
    }
    model_.walls.push_back(wall);
    wall_lines_.push_back(s.line());
  }

  Vec2 point(const Statement& s, Vec2 local) {
    if (frames_.empty()) return local;
    const Pose& frame = frames_.back().pose;
    const Vec2 p = frame.position() + Heading::from_angle(frame.theta).rotate(local);
    check_reach(s, p);
    return p;
  }

  void check_reach(const Statement& s, Vec2 p) {
    if (is_too_far(p)) {
      s.fail(0, "lies more than 10 km from the origin once its 'push' frames are added up");
    }
  }

  void finish_size() {
    if (width_.has_value() != height_.has_value()) {
      throw ConfigError(size_where_, width_ ? "width without height: expected both"
                                            : "height without width: expected both");
    }
    if (width_) {
      model_.width = *width_;
      model_.height = *height_;
      return;
    }
    if (model_.walls.empty()) {
      throw ConfigError({file_, std::max(1, statements_.line()), 1},
                        "no size and no walls up to the end: expected 'floor WIDTH HEIGHT'");
    }
    double left = 0;
    double low = 0;
    for (const world::Wall& wall : model_.walls) {
      for (const Vec2 end : {wall.a, wall.b}) {
        model_.width = std::max(model_.width, end.x);
        model_.height = std::max(model_.height, end.y);
        left = std::min(left, end.x);
        low = std::min(low, end.y);
      }
    }
    // A floor reaches from the origin to the upper right. Walls that lie on the other side of it
    // belong to a file that lost its enclosing frame; moving them would be a guess.
    if (model_.width < 0.001 || model_.height < 0.001) {
      throw ConfigError({file_, wall_lines_.front(), 1},
                        "no size is given and the walls lie at negative coordinates, down to (" +
                            write_millimetres(left) + ", " + write_millimetres(low) +
                            ") mm: expected 'floor WIDTH HEIGHT' and, before the walls, 'push X Y "
                            "0' that moves them onto the floor");
    }
    warnings_.add(wall_lines_.front(), 1,
                  "no size is given: the floor reaches to the farthest walls, " +
                      write_millimetres(model_.width) + " mm x " +
                      write_millimetres(model_.height) + " mm");
  }

  void warn_of_walls_outside() {
    std::size_t outside = 0;
    std::size_t first = 0;
    constexpr double kOutside = 1e-6;  // frames turned by 90 degrees miss their walls by rounding
    for (std::size_t i = 0; i < model_.walls.size(); ++i) {
      const auto out = [&](Vec2 p) {
        return p.x < -kOutside || p.y < -kOutside || p.x > model_.width + kOutside ||
               p.y > model_.height + kOutside;
      };
      if (!out(model_.walls[i].a) && !out(model_.walls[i].b)) continue;
      if (outside++ == 0) first = i;
    }
    if (outside == 0) return;
    warnings_.add(wall_lines_[first], 1,
                  std::to_string(outside) + (outside == 1 ? " wall leaves" : " walls leave") +
                      " the floor of " + write_millimetres(model_.width) + " mm x " +
                      write_millimetres(model_.height) + " mm; this is the first");
  }

  StatementReader statements_;
  const std::string& file_;
  Warnings warnings_;
  std::vector<SourceLocation>* start_places_;
  Reading reading_;
  world::WorldModel model_;
  std::optional<double> width_;
  std::optional<double> height_;
  SourceLocation size_where_;
  std::vector<Frame> frames_;
  std::vector<int> wall_lines_;
};

}  // namespace

world::WorldModel read_world(std::string_view text, const std::string& file,
                             std::vector<Warning>& warnings,
                             std::vector<SourceLocation>* start_places, Reading reading) {
  return WorldReader(text, file, warnings, start_places, reading).read();
}

}  // namespace eyebridge::files
