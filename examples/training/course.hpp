#pragma once

#include <array>
#include <cstddef>

#include "eyebridge/base/pose.hpp"

/// How far a robot is on its way round a rectangle of corridors, counter-clockwise: what training
/// rewards. Metres.
class Course {
 public:
  /// The middle of the corridors of worlds/corridor.wld, corner by corner from the start.
  static constexpr std::array<eyebridge::Vec2, 4> kCorners = {
      {{0.3, 0.3}, {3.3, 0.3}, {3.3, 2.1}, {0.3, 2.1}}};

  static double length() {
    double sum = 0;
    for (std::size_t leg = 0; leg < kCorners.size(); ++leg) sum += length_of(leg);
    return sum;
  }

  /// Whoever comes near the corner ahead goes on to the next.
  void see(eyebridge::Vec2 here) {
    while (leg_ < kCorners.size() && norm(end_of(leg_) - here) < 0.3) behind_ += length_of(leg_++);
    const double ahead = finished() ? 0 : length_of(leg_) - norm(end_of(leg_) - here);
    progress_ = behind_ + (ahead > 0 ? ahead : 0);
  }

  [[nodiscard]] bool finished() const { return leg_ == kCorners.size(); }
  [[nodiscard]] double progress() const { return progress_; }  ///< Along the middle.

 private:
  static eyebridge::Vec2 end_of(std::size_t leg) { return kCorners[(leg + 1) % kCorners.size()]; }
  static double length_of(std::size_t leg) { return norm(end_of(leg) - kCorners[leg]); }

  std::size_t leg_ = 0;
  double behind_ = 0;
  double progress_ = 0;
};
