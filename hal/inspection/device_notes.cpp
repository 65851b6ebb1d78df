#include "eyebridge/hal/device_notes.hpp"

#include <utility>

#include <time.h>

namespace eyebridge::hal {

NoteCell& DeviceNotes::add(std::string kind, int id, std::string name, Quantity quantity) {
  NotedValue& row = values_.emplace_back();
  row.kind = std::move(kind);
  row.id = id;
  row.name = std::move(name);
  row.quantity = quantity;
  return row.cell;
}

SoundNote DeviceNotes::sound() const {
  const std::lock_guard lock(mutex_);
  return sound_;
}

void DeviceNotes::put_sound(SoundNote sound) {
  sound.stamp = stamp();
  const std::lock_guard lock(mutex_);
  sound.count = sound_.count + 1;
  sound_ = std::move(sound);
}

Time DeviceNotes::stamp() const noexcept {
  if (is_virtual_) return clock_.now();
  // Other clocks may have to ask another process; this one is read in five nanoseconds.
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC_COARSE, &now);
  return std::chrono::seconds(now.tv_sec) + std::chrono::nanoseconds(now.tv_nsec);
}

Time DeviceNotes::time_of(Time stamp) const { return is_virtual_ ? stamp : clock_.at(stamp); }

}  // namespace eyebridge::hal
