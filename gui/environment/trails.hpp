#pragma once

#include <cstddef>
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
  void clear() { robots_.clear(); }

  struct Point {
    Vec2 place;
    bool begins = false;  ///< No line leads here.
  };
  [[nodiscard]] const std::deque<Point>& of(std::size_t robot) const;

 private:
  std::vector<std::deque<Point>> robots_;
  double last_time_ = 0.0;
};

}  // namespace eyebridge::gui
