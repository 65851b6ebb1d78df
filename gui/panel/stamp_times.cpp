#include "panel/stamp_times.hpp"

#include <algorithm>
#include <chrono>

namespace eyebridge::gui {

StampTimes::StampTimes(const hal::DeviceNotes& notes) : notes_(notes), last_(now()) {
  before_ = last_;
}

void StampTimes::look() {
  if (notes_.is_virtual()) return;
  before_ = last_;
  last_ = now();
}

Time StampTimes::time_of(Time stamp) const {
  if (notes_.is_virtual()) return stamp;
  if (stamp < before_.stamp) return std::min(notes_.time_of(stamp), before_.time);
  if (stamp >= last_.stamp) return last_.time;
  const std::chrono::duration<double> passed = stamp - before_.stamp;
  const std::chrono::duration<double> all = last_.stamp - before_.stamp;
  return before_.time +
         std::chrono::duration_cast<Time>((last_.time - before_.time) * (passed / all));
}

}  // namespace eyebridge::gui
