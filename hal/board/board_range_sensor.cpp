#include "board/board_range_sensor.hpp"

#include "board/board_units.hpp"

namespace eyebridge::hal {

Result<double> BoardRangeSensor::read() {
  if (table_.metres.empty()) return link_.psd_metres(id_);
  return link_.psd_raw(id_).map([this](int raw) { return to_metres(table_, raw); });
}

}  // namespace eyebridge::hal
