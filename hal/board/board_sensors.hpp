#pragma once

#include <mutex>

#include "board/board_device.hpp"
#include "eyebridge/hal/analog_inputs.hpp"
#include "eyebridge/hal/io_board.hpp"
#include "eyebridge/hal/range_matrix.hpp"
#include "eyebridge/hal/range_sensor.hpp"
#include "eyebridge/hal/remote.hpp"

namespace eyebridge::hal {

/// One distance sensor of a board; its raw reading is that of the converter.
class BoardRangeSensor final : public RangeSensor, private BoardDevice {
 public:
  BoardRangeSensor(BoardLink& link, BoardPsdTable table)
      : BoardDevice(link, table.id), table_(std::move(table)) {}

  Result<double> read() override;
  Result<int> read_raw() override { return link_.psd_raw(id_); }
  [[nodiscard]] double out_of_range() const override { return kBoardOutOfRange; }

 private:
  const BoardPsdTable table_;
};

/// One matrix of ranges of a board.
class BoardRangeMatrix final : public RangeMatrix, private BoardDevice {
 public:
  using BoardDevice::BoardDevice;

  Result<Ranges> read() override { return link_.range_matrix(id_); }
  [[nodiscard]] double out_of_range() const override { return kBoardOutOfRange; }
};

/// The analog inputs of a board.
class BoardAnalog final : public AnalogInputs {
 public:
  explicit BoardAnalog(BoardLink& link) : link_(link) {}

  Result<int> read(int channel) override;
  Result<double> supply_voltage() override { return link_.supply_voltage(); }

 private:
  BoardLink& link_;
};

/// The board itself.
class BoardIdentity final : public IoBoard {
 public:
  explicit BoardIdentity(BoardLink& link) : link_(link) {}
  Result<std::string> version() override { return link_.version(); }

 private:
  BoardLink& link_;
};

/// The infrared receiver of a board, which says which key is held.
class BoardRemote final : public Remote {
 public:
  explicit BoardRemote(BoardLink& link) : link_(link) {}

  /// A key that is held is one press; the same key again is one after it was let go.
  Result<int> read() override;

 private:
  BoardLink& link_;
  std::mutex mutex_;
  int held_ = 0;
};

}  // namespace eyebridge::hal
