#include "map_world.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "eyebridge/files/floor_plan.hpp"
#include "map_frame.hpp"

namespace eyebridge::files {
namespace {

/// Pixels that a wall may miss the outline by: the steps of a slanted wall are half a pixel deep.
constexpr double kTolerance = 0.75;

/// Pixels that nobody may stand near: occupied or unknown. Chessboard distance to the next, in two
/// sweeps (Rosenfeld and Pfaltz, Journal of the ACM 13, 1966).
std::vector<int> room_around(const MapFiles& map) {
  const int columns = map.picture.columns;
  const int rows = map.picture.rows;
  const auto at = [columns](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(x);
  };
  std::vector<int> room(map.picture.greys.size());
  const auto value = [&](int x, int y) {
    return x < 0 || y < 0 || x >= columns || y >= rows ? 0 : room[at(x, y)];
  };
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      room[at(x, y)] = !is_free(map.description, map.picture.greys[at(x, y)])
                           ? 0
                           : 1 + std::min({value(x - 1, y), value(x - 1, y - 1), value(x, y - 1),
                                           value(x + 1, y - 1)});
    }
  }
  for (int y = rows - 1; y >= 0; --y) {
    for (int x = columns - 1; x >= 0; --x) {
      if (room[at(x, y)] == 0) continue;
      room[at(x, y)] =
          std::min(room[at(x, y)], 1 + std::min({value(x + 1, y), value(x + 1, y + 1),
                                                 value(x, y + 1), value(x - 1, y + 1)}));
    }
  }
  return room;
}

/// The place with most room, up to a metre, and of those the one nearest to the middle.
std::optional<Vec2> start_in(const MapFiles& map, const MapFrame& frame) {
  const std::vector<int> room = room_around(map);
  const int enough = static_cast<int>(std::ceil(1.0 / map.description.resolution));
  const int most = std::min(*std::ranges::max_element(room), enough);
  if (most == 0) return std::nullopt;
  const double middle_x = map.picture.columns / 2.0;
  const double middle_y = map.picture.rows / 2.0;
  double nearest = -1;
  Vec2 best;
  std::size_t i = 0;
  for (int y = 0; y < map.picture.rows; ++y) {
    for (int x = 0; x < map.picture.columns; ++x, ++i) {
      if (room[i] < most) continue;
      const Vec2 away{x + 0.5 - middle_x, y + 0.5 - middle_y};
      if (nearest >= 0 && norm_squared(away) >= nearest) continue;
      nearest = norm_squared(away);
      best = frame.place(x + 0.5, y + 0.5);
    }
  }
  return best;
}

}  // namespace

world::WorldModel world_of(const MapFiles& map, const std::string& file,
                           std::vector<Warning>& warnings) {
  const int columns = map.picture.columns;
  const int rows = map.picture.rows;
  const MapFrame frame(map.description, columns, rows);
  std::vector<char> occupied;
  occupied.reserve(map.picture.greys.size());
  for (const std::uint8_t grey : map.picture.greys) {
    occupied.push_back(is_occupied(map.description, grey) ? 1 : 0);
  }
  world::WorldModel model;
  model.corner = frame.low();
  model.width = frame.high().x - frame.low().x;
  model.height = frame.high().y - frame.low().y;
  for (const auto& outline : outlines_of(columns, rows, occupied, kTolerance, file)) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const PixelCorner& a = outline[i];
      const PixelCorner& b = outline[(i + 1) % outline.size()];
      if (outline.size() == 2 && i == 1) break;  // a pixel alone: a line across it, once
      world::Wall wall;
      wall.a = frame.place(a.x, a.y);
      wall.b = frame.place(b.x, b.y);
      model.walls.push_back(wall);
    }
  }
  if (model.walls.empty()) {
    warnings.push_back({{file, 0, 0}, "a map without walls: no pixel is dark enough"});
  }
  if (const auto start = start_in(map, frame)) {
    model.starts.push_back({0, {start->x, start->y, 0}});
  }
  return model;
}

}  // namespace eyebridge::files
