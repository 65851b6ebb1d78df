#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "board/board_link.hpp"
#include "board/dbc_map.hpp"
#include "eyebridge/bridges/client/dbc_client.hpp"

namespace eyebridge::hal {

/// A robot with messages of its own: motors 1 (left) and 2 (right), encoders and distances, as its
/// mapping file says. It has no servos, ports or analog inputs.
class DbcLink final : public BoardLink {
 public:
  /// `client` is ready; it was made of `robot.plan`. `clock` is the one of the line.
  DbcLink(std::unique_ptr<bridges::DbcClient> client, DbcRobot robot, Clock& clock);

  [[nodiscard]] bool has_motor(int id) const override { return id == 1 || id == 2; }
  [[nodiscard]] bool has_encoder(int id) const override { return encoders_.contains(id); }
  [[nodiscard]] bool has_servo(int) const override { return false; }
  [[nodiscard]] bool has_psd(int id) const override { return find_range(id) != nullptr; }
  [[nodiscard]] bool has_digital() const override { return false; }
  [[nodiscard]] bool has_analog() const override { return false; }
  [[nodiscard]] bool has_remote() const override { return false; }
  Result<void> motor_duty(int id, int percent) override;
  Result<void> motor_speed(int id, int ticks_per_10ms) override;
  Result<void> motor_pid(int, int, int, int) override { return lacks("gains of its motors"); }
  Result<BoardCount> encoder(int id) override;
  Result<void> servo(int, int) override { return lacks("servos"); }
  Result<int> psd_raw(int id) override;
  Result<double> psd_metres(int id) override;
  Result<void> digital_setup(int, LineMode) override { return lacks("digital lines"); }
  Result<bool> digital_in(int) override { return lacks("digital lines"); }
  Result<std::uint16_t> digital_in_all() override { return lacks("digital lines"); }
  Result<void> digital_out(int, bool) override { return lacks("digital lines"); }
  Result<int> analog(int) override { return lacks("analog inputs"); }
  Result<double> supply_voltage() override { return lacks("its supply voltage"); }
  Result<std::string> version() override { return lacks("its version"); }
  Result<int> remote_key() override { return lacks("a remote control"); }
  std::unique_ptr<DriveController> make_drive(const BoardDriveShape& shape) override;
  Result<void> stop() override { return client_->stop(); }
  void look_after() override {}  // the client has a thread of its own
  [[nodiscard]] std::uint32_t generation() const override { return client_->generation(); }

  /// Where the robot says that it is. Fails as the client does.
  Result<Pose> pose() const;
  /// The bridge below.
  [[nodiscard]] bridges::DbcClient& client() { return *client_; }

 private:
  /// A counter that wraps, as one that does not.
  struct Counter {
    DbcEncoder encoder;
    std::optional<std::uint32_t> generation;
    std::uint64_t last = 0;
    std::int64_t total = 0;
    std::optional<BoardCount> count;  ///< What encoder() gave last.
  };

  tl::unexpected<Error> lacks(const char* what) const;
  Result<void> turn(int id, double metres_per_second);
  [[nodiscard]] const DbcRange* find_range(int id) const;
  Result<double> quantity(const DbcQuantity& quantity) const;

  const DbcRobot robot_;
  const std::unique_ptr<bridges::DbcClient> client_;
  Clock& clock_;
  Time command_period_{0};
  std::mutex mutex_;
  std::map<int, Counter> encoders_;
};

}  // namespace eyebridge::hal
