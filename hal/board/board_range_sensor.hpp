#pragma once

#include "board/board_device.hpp"
#include "eyebridge/hal/range_sensor.hpp"

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

}  // namespace eyebridge::hal
