#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <string>

#include "board/board_link.hpp"
#include "board/tick_counter.hpp"
#include "eyebridge/bridges/client/can_client.hpp"

namespace eyebridge::hal {

/// A robot on a CAN bus.
class CanLink final : public BoardLink {
 public:
  /// `client` is ready; what the robot has is read off its status now.
  explicit CanLink(std::unique_ptr<bridges::CanClient> client);

  [[nodiscard]] bool has_motor(int id) const override { return id >= 1 && id <= 4; }
  [[nodiscard]] bool has_encoder(int id) const override { return id >= 1 && id <= 4; }
  [[nodiscard]] bool has_servo(int id) const override { return id >= 1 && id <= 14; }
  [[nodiscard]] bool has_psd(int id) const override;
  [[nodiscard]] bool has_digital() const override { return true; }
  [[nodiscard]] bool has_analog() const override { return true; }
  [[nodiscard]] bool has_remote() const override { return true; }
  [[nodiscard]] bool has_lidar() const override { return client_->has_lidar(); }
  [[nodiscard]] bool has_range_matrix(int id) const override {
    return client_->has_range_matrix(id);
  }

  Result<void> motor_duty(int id, int percent) override;
  Result<void> motor_speed(int id, int ticks_per_10ms) override;
  Result<void> motor_pid(int id, int p, int i, int d) override;
  Result<BoardCount> encoder(int id) override;
  Result<void> servo(int id, int position) override;
  Result<int> psd_raw(int id) override;
  Result<double> psd_metres(int id) override;
  Result<void> digital_setup(int port, LineMode mode) override;
  Result<bool> digital_in(int port) override;
  Result<std::uint16_t> digital_in_all() override;
  Result<void> digital_out(int port, bool high) override;
  Result<int> analog(int channel) override;
  Result<double> supply_voltage() override;
  Result<std::string> version() override;
  Result<int> remote_key() override;
  Result<void> scan(BoardScan& out) override;
  Result<RangeMatrix::Ranges> range_matrix(int id) override;
  std::unique_ptr<DriveController> make_drive(const BoardDriveShape& shape) override;
  Result<void> stop() override { return client_->stop(); }
  void look_after() override {}  // the client has a thread of its own
  [[nodiscard]] std::uint32_t generation() const override { return client_->generation(); }

  /// The bridge below, for statistics.
  [[nodiscard]] bridges::CanClient& client() { return *client_; }

 private:
  const std::unique_ptr<bridges::CanClient> client_;
  std::array<bool, 6> psds_{};
  std::mutex mutex_;
  std::array<TickCounter, 4> counters_;
  std::unique_ptr<bridges::can::LidarScan> scan_;
};

}  // namespace eyebridge::hal
