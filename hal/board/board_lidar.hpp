#pragma once

#include <mutex>
#include <optional>

#include "board/board_device.hpp"
#include "eyebridge/hal/lidar.hpp"

namespace eyebridge::hal {

/// The LIDAR of a board. It scans as it was built: a shape that is set selects rays of its scans.
class BoardLidar final : public Lidar, private BoardDevice {
 public:
  explicit BoardLidar(BoardLink& link) : BoardDevice(link, 1) {}

  /// Besides what Lidar says: at most the board's field of view, and its tilt.
  Result<void> configure(double field_of_view, double tilt, int points) override;
  [[nodiscard]] LidarShape shape() const override;
  Result<void> read(std::span<double> ranges) override;
  [[nodiscard]] double max_range() const override { return kBoardOutOfRange; }

 private:
  mutable std::mutex mutex_;
  std::optional<LidarShape> shape_;  ///< None set: the board's.
};

}  // namespace eyebridge::hal
