#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "eyebridge/base/pose.hpp"
#include "eyebridge/mapping/raster.hpp"

namespace eyebridge::robios {

/// A robot in a map.
struct MapRobot {
  int number = 1;       ///< From 1.
  Pose pose;            ///< Where it is in that map.
  double radius = 0.0;  ///< Metres.
};

/// A map as a window shows it.
struct MapLook {
  mapping::Raster<std::uint8_t> grey;  ///< As mapping::picture_of() makes it.
  std::vector<MapRobot> robots;
};

/// Where whoever has a map lays its latest look, and windows take it from. Any thread; neither
/// waits for the other's work.
class MapBoard {
 public:
  void show(MapLook look) {
    auto next = std::make_shared<const MapLook>(std::move(look));
    const std::lock_guard lock(mutex_);
    look_.swap(next);
  }
  /// Null before the first one.
  [[nodiscard]] std::shared_ptr<const MapLook> look() const {
    const std::lock_guard lock(mutex_);
    return look_;
  }

 private:
  mutable std::mutex mutex_;
  std::shared_ptr<const MapLook> look_;
};

}  // namespace eyebridge::robios
