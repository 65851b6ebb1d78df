#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "eyebridge/base/units.hpp"
#include "eyebridge/robot/arc.hpp"
#include "grids.hpp"

namespace eyebridge::planning::test {

/// A differential drive that does exactly as it is told, in a room that knows how near it came to
/// blocked cells.
class Driving {
 public:
  Driving(const BlockedRaster& room, const Pose& start) : room_(room), pose_(start) { look(); }

  [[nodiscard]] const Pose& pose() const { return pose_; }
  /// Metres, if less than 0.3 in a room of 5 cm.
  [[nodiscard]] double nearest() const { return nearest_; }
  [[nodiscard]] double seconds() const { return seconds_; }
  [[nodiscard]] double way() const { return way_; }

  /// Drives `twist` for `period` seconds: an arc, in eight exact pieces.
  void drive(const Twist& twist, double period) {
    constexpr int kPieces = 8;
    for (int i = 0; i < kPieces; ++i) {
      const world::Arc arc =
          robot::arc_of({twist.linear * period / kPieces, twist.angular * period / kPieces});
      const Heading heading = Heading::from_angle(pose_.theta);
      const Vec2 to = pose_.position() + heading.rotate(arc.displacement);
      way_ += twist.linear * period / kPieces;
      pose_ = {to.x, to.y, wrap_angle(pose_.theta + twist.angular * period / kPieces)};
      look();
    }
    seconds_ += period;
  }

 private:
  void look() { nearest_ = std::min(nearest_, nearest_square(room_, pose_.position(), 6)); }

  const BlockedRaster& room_;
  Pose pose_;
  double nearest_ = std::numeric_limits<double>::infinity();
  double seconds_ = 0.0;
  double way_ = 0.0;
};

/// 4 x 4 m with walls around it and `boxes` blocks of up to 0.6 x 0.6 m.
inline BlockedRaster furnished_room(Random& random, int boxes) {
  BlockedRaster room({{0, 0}, 0.05, 80, 80});
  for (int i = 0; i < 80; ++i) {
    room[{i, 0}] = room[{i, 79}] = room[{0, i}] = room[{79, i}] = 1;
  }
  for (int i = 0; i < boxes; ++i) {
    const Cell corner = random_cell(room.geometry, random);
    const int columns = 2 + static_cast<int>(10 * random.uniform());
    const int rows = 2 + static_cast<int>(10 * random.uniform());
    for (int row = corner.row; row < std::min(80, corner.row + rows); ++row) {
      for (int column = corner.column; column < std::min(80, corner.column + columns); ++column) {
        room[{column, row}] = 1;
      }
    }
  }
  return room;
}

/// The centre of a free cell, metres; there is one.
inline Vec2 random_place(const BlockedRaster& blocked, Random& random) {
  for (;;) {
    const Cell cell = random_cell(blocked.geometry, random);
    if (blocked[cell] == 0) return blocked.geometry.centre_of(cell);
  }
}

}  // namespace eyebridge::planning::test
