#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "eyebridge/base/pose.hpp"

namespace eyebridge::robot {

/// How far the rays of one robot's sensors go, kept until something moves.
///
/// Programs read their sensors one by one, and a fan of eight rays takes little more time than one:
/// the first reading after a move measures all sensors that were read lately.
class KnownRays {
 public:
  /// The sensors with these numbers are remembered: 0 to kMost - 1.
  static constexpr std::size_t kMost = 64;

  /// What the ranges depend on.
  struct Moment {
    std::uint64_t world = 0;  ///< World::version().
    Heading heading;          ///< Of the robot. `world` covers its position.

    friend bool operator==(const Moment&, const Moment&) = default;
  };

  /// Notes that `sensor` is read. Returns the sensors to measure now and to keep(), one bit for
  /// each; 0 where its range is known.
  std::uint64_t ask(const Moment& moment, std::size_t sensor);
  void keep(std::size_t sensor, double range);
  /// Metres.
  [[nodiscard]] double range(std::size_t sensor) const { return ranges_[sensor]; }

 private:
  /// A program whose decision takes several steps asks for some of its sensors in each.
  static constexpr std::size_t kMoments = 4;

  Moment moment_;
  std::uint64_t known_ = 0;
  std::array<std::uint64_t, kMoments> asked_{};  ///< At this moment, and at those before.
  std::vector<double> ranges_;
};

}  // namespace eyebridge::robot
