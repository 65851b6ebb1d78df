#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "eyebridge/hal/environment.hpp"

namespace eyebridge::gui {

/// Where robots have been. One thread.
class Trails {
 public:
  static constexpr std::size_t kLongest = 5000;  ///< Points of a robot; older ones go.

  /// Adds where the robots are, unless that is where they were. A robot that was carried away by
  /// more than a step begins a new piece: see Point::begins.
  void add(const hal::WorldLook& look);
  void clear() {
    robots_.clear();
    ++version_;
  }

  struct Point {
    Vec2 place;
    bool begins = false;  ///< No line leads here.
  };
  /// Where one robot has been.
  struct Trail {
    std::deque<Point> points;
    std::uint64_t gone = 0;  ///< Points that were before them.
  };
  [[nodiscard]] const Trail& of(std::size_t robot) const;
  /// Another one when trails have vanished, but for the oldest points of long ones.
  [[nodiscard]] std::uint64_t version() const { return version_; }

 private:
  std::vector<Trail> robots_;
  std::uint64_t version_ = 0;
  double last_time_ = 0.0;
};

}  // namespace eyebridge::gui
