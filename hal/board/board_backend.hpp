#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "board/board_actuators.hpp"
#include "board/board_clock.hpp"
#include "board/board_drive.hpp"
#include "board/board_lidar.hpp"
#include "board/board_lines.hpp"
#include "board/board_link.hpp"
#include "board/board_sensors.hpp"
#include "board/board_tables.hpp"
#include "eyebridge/hal/backend.hpp"

namespace eyebridge::hal {

/// One robot that is a real board. No world, no camera view, no compass, gyroscope or
/// accelerometer, no switches: null.
class BoardBackend final : public Backend {
 public:
  /// `line_clock` is the one that `link` lives in. Of `tables`, the devices that the board has.
  BoardBackend(std::unique_ptr<Clock> line_clock, std::unique_ptr<BoardLink> link,
               const BoardTables& tables);
  /// Stops the motors.
  ~BoardBackend() override;

  /// Starts the thread "eb:board", which calls step() every 10 ms of the line's clock; not where
  /// that is virtual: who moves it calls step().
  void start();
  /// What has to be done every 10 ms: looking after the link, v-omega on the host, the trace.
  void step();

  Clock& clock() override { return clock_; }
  [[nodiscard]] int robot_id() const override { return 1; }
  Device* find(DeviceKind kind, int id) override;
  WorldControl* world() override { return nullptr; }
  camera::View* camera_view() override { return nullptr; }
  camera::Source* camera_source() override { return nullptr; }
  /// A point every 100 ms: each costs readings that the program does not get. Points that cannot be
  /// read are left out.
  void trace_to(TraceSink* sink) override;
  /// The encoders' ticks per metre, as the HDT says.
  std::vector<DeviceFacts> facts_of(std::string_view kind) override;
  Result<void> stop() noexcept override;

  [[nodiscard]] BoardLink& link() { return *link_; }

 private:
  void run();
  void trace();

  const std::unique_ptr<Clock> line_clock_;
  const std::unique_ptr<BoardLink> link_;
  BoardClock clock_;  ///< The program's.
  std::unique_ptr<DriveController> controller_;
  std::optional<BoardDrive> drive_;
  BoardLidar lidar_;
  BoardDigital digital_;
  BoardAnalog analog_;
  BoardIdentity identity_;
  BoardRemote remote_;
  std::map<int, BoardRangeSensor> range_sensors_;
  std::map<int, BoardRangeMatrix> range_matrices_;
  std::map<int, BoardMotor> motors_;
  std::map<int, BoardEncoder> encoders_;
  std::map<int, BoardServo> servos_;
  std::vector<DeviceFacts> encoder_facts_;

  std::uint32_t generation_ = 0;  // only step()'s
  Time next_point_{0};
  std::vector<double> ranges_;
  std::mutex tracing_;
  TraceSink* sink_ = nullptr;
  std::atomic<bool> ending_ = false;
  std::thread thread_;
};

}  // namespace eyebridge::hal
