#pragma once

#include <bit>
#include <cstdint>

#include "eyebridge/base/hash.hpp"
#include "eyebridge/base/pose.hpp"
#include "eyebridge/camera/view.hpp"
#include "eyebridge/hal/drive.hpp"
#include "eyebridge/world/world.hpp"

namespace eyebridge::hal {

/// What happened in a run, in 64 bits: where all bodies were every kStepsALook steps, and what
/// sensors answered to programs. Two runs that are not the same differ in it, also where they end
/// alike. One thread.
class RunTrace {
 public:
  static constexpr std::uint64_t kStepsALook = 10;

  void add(double value) { mix(StateHash::bits_of(value)); }
  void add(bool value) { mix(value ? 1 : 0); }
  void add(std::uint16_t value) { mix(value); }
  void add(std::int32_t value) { mix(static_cast<std::uint32_t>(value)); }
  void add(Vec2 value) {
    add(value.x);
    add(value.y);
  }
  void add(const Pose& value) {
    const auto y = std::bit_cast<std::uint64_t>(value.y);
    mix(std::bit_cast<std::uint64_t>(value.x) + std::rotl(y, 21));
    hash_ ^= std::bit_cast<std::uint64_t>(value.theta);  // which is there last
  }
  void add(const Twist& value) { add(Vec2{value.linear, value.angular}); }
  void add(const DriveStatus& value) {
    mix(static_cast<std::uint64_t>(value.progress));
    add(value.remaining);
    mix(value.stalled_left ? 1U : 0U);
    mix(value.stalled_right ? 1U : 0U);
  }
  void add(const camera::Eye& value) {
    add(Pose{value.x, value.y, value.heading});
    add(Vec2{value.z, value.pitch});
  }
  /// What a picture suffers: the picture itself follows from that, the eye and the world.
  void add(const camera::ImageNoise& value) {
    const robot::CameraError& error = value.error;
    for (const double amount : {error.salt_and_pepper, error.sigma, error.coloured, error.blur,
                                error.exposure, error.exposure_sigma}) {
      add(amount);
    }
    mix(value.seed);
  }
  void add(const world::World& world) {
    for (world::BodyId body = 0; body < world.body_count(); ++body) {
      if (world.is_there(body)) add(world.position(body));
    }
  }
  [[nodiscard]] std::uint64_t value() const { return hash_; }

 private:
  // One multiplication a reading, and nothing behind it: programs in virtual time make ten million
  // of readings a second, and who unlocks the world waits for it. The factor is 2^64 by the golden
  // ratio.
  void mix(std::uint64_t bits) { hash_ = (std::rotl(hash_, 29) ^ bits) * 0x9E3779B97F4A7C15U; }

  std::uint64_t hash_ = 0;
};

}  // namespace eyebridge::hal
