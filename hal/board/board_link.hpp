#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "board/board_tables.hpp"
#include "board/drive_controller.hpp"
#include "eyebridge/base/result.hpp"
#include "eyebridge/hal/digital_lines.hpp"
#include "eyebridge/hal/lidar.hpp"
#include "eyebridge/hal/range_matrix.hpp"

namespace eyebridge::hal {

/// A scan as a board gives it.
struct BoardScan {
  LidarShape shape;
  std::vector<double> ranges;  ///< Metres, left-most first; kBoardOutOfRange where nothing is seen.
};

/// What an encoder had counted, and when: on the clock of the line.
struct BoardCount {
  std::int32_t ticks = 0;  ///< Since the link was opened, also across a restart of the board; wraps
                           ///< as 32 bits do.
  Time at{0};
  Time within{0};  ///< It may have been so much later: how long the answer took.
};

/// A board, whatever line and protocol it is behind. Numbers are the board's: see board_units.hpp.
///
/// Every call fails with Timeout or Disconnected while the board cannot be reached, Unsupported
/// where it has no such thing. Any thread.
class BoardLink {
 public:
  virtual ~BoardLink() = default;

  // What there is; settled when the link is opened.
  [[nodiscard]] virtual bool has_motor(int id) const = 0;
  /// Of its motors: it holds a speed itself.
  [[nodiscard]] virtual bool has_speed_control() const { return true; }
  [[nodiscard]] virtual bool has_encoder(int id) const = 0;
  [[nodiscard]] virtual bool has_servo(int id) const = 0;
  [[nodiscard]] virtual bool has_psd(int id) const = 0;
  /// May become true later: when a first scan is announced.
  [[nodiscard]] virtual bool has_lidar() const { return false; }
  /// May become true later: when a first reading comes.
  [[nodiscard]] virtual bool has_range_matrix(int /*id*/) const { return false; }

  /// Any of the digital ports' functions; likewise of the analog ones.
  [[nodiscard]] virtual bool has_digital() const = 0;
  [[nodiscard]] virtual bool has_analog() const = 0;
  [[nodiscard]] virtual bool has_remote() const = 0;

  virtual Result<void> motor_duty(int id, int percent) = 0;
  virtual Result<void> motor_speed(int id, int ticks_per_10ms) = 0;
  virtual Result<void> motor_pid(int id, int p, int i, int d) = 0;
  virtual Result<BoardCount> encoder(int id) = 0;
  virtual Result<void> servo(int id, int position) = 0;
  /// 0 … 4095.
  virtual Result<int> psd_raw(int id) = 0;
  /// Metres by the board's own table. Unsupported when it has none.
  virtual Result<double> psd_metres(int id) = 0;
  // Ports count from 0, channels as AnalogInputs does.
  virtual Result<void> digital_setup(int port, LineMode mode) = 0;
  virtual Result<bool> digital_in(int port) = 0;
  virtual Result<std::uint16_t> digital_in_all() = 0;
  virtual Result<void> digital_out(int port, bool high) = 0;
  virtual Result<int> analog(int channel) = 0;
  /// Volts.
  virtual Result<double> supply_voltage() = 0;
  /// Of the firmware, printable.
  virtual Result<std::string> version() = 0;
  /// Code of the key of the remote control that is held, or 0.
  virtual Result<int> remote_key() = 0;
  virtual Result<void> scan(BoardScan& /*out*/) {
    return fail(Errc::Unsupported, "this board has no LIDAR");
  }
  virtual Result<RangeMatrix::Ranges> range_matrix(int id) {
    return fail(Errc::Unsupported, "this board has no range matrix " + std::to_string(id));
  }

  /// What drives the wheels if the board can itself; null when the host has to. Lent: the link must
  /// outlive it.
  virtual std::unique_ptr<DriveController> make_drive(const BoardDriveShape& shape) = 0;

  /// All motors stand. Fails with why that is not known: the board cannot be reached, or does not
  /// answer.
  virtual Result<void> stop() = 0;
  /// To be called every 10 ms by one thread: keeps the link alive and finds lost boards again.
  virtual void look_after() = 0;
  /// Grows whenever the board forgot what it was told, or stands where it was driving.
  [[nodiscard]] virtual std::uint32_t generation() const = 0;
};

}  // namespace eyebridge::hal
