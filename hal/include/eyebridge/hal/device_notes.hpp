#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <string>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/hal/backend.hpp"
#include "eyebridge/hal/note_cell.hpp"
#include "eyebridge/hal/quantity.hpp"

namespace eyebridge::hal {

/// One row of the table: a quantity of a device.
struct NotedValue {
  std::string kind;  ///< "psd": as in recordings and fault scripts.
  int id = 1;        ///< Of a line or channel, where the device has such.
  std::string name;  ///< As the robot's description calls the device; may be empty.
  Quantity quantity = Quantity::Raw;
  NoteCell cell;
};

/// The last sound that a program asked for.
struct SoundNote {
  std::string file;        ///< What is played; empty: a tone.
  double frequency = 0.0;  ///< Of a tone, Hz …
  double length = 0.0;     ///< … and its length, s.
  Time stamp{0};
  std::uint64_t count = 0;  ///< So far; 0: there was none.
};

/// What a program last read from its robot's devices and wrote to them, for people to look at.
/// Looking asks no device. Any thread.
class DeviceNotes {
 public:
  /// `clock`, the program's, is lent.
  explicit DeviceNotes(Clock& clock) : clock_(clock), is_virtual_(clock.is_virtual()) {}

  /// All rows there are: complete before the program's first call. Their addresses stay.
  [[nodiscard]] const std::deque<NotedValue>& values() const { return values_; }
  /// For whoever makes the table.
  NoteCell& add(std::string kind, int id, std::string name, Quantity quantity);

  [[nodiscard]] SoundNote sound() const;
  void put_sound(SoundNote sound);

  /// For a note that is made now. Cheap: some nanoseconds.
  [[nodiscard]] Time stamp() const noexcept;
  /// What the program's clock showed at that stamp: where time is real, to 4 ms. May ask whoever
  /// has the clock.
  [[nodiscard]] Time time_of(Time stamp) const;
  [[nodiscard]] Time now() const { return clock_.now(); }
  /// Whether a stamp is the time itself.
  [[nodiscard]] bool is_virtual() const { return is_virtual_; }

 private:
  Clock& clock_;
  const bool is_virtual_;
  std::deque<NotedValue> values_;
  mutable std::mutex mutex_;  ///< Of the sound alone.
  SoundNote sound_;
};

/// A backend and what is noted of the calls to its devices.
struct NotedBackend {
  std::unique_ptr<Backend> backend;
  std::shared_ptr<DeviceNotes> notes;
};

/// `inner`, every call to whose devices is noted on its way; nothing else changes, and no device is
/// called. A call becomes about 10 ns longer in virtual time, 15 in real time (bench_notes), that
/// of a lidar 1 ns for each point.
NotedBackend with_notes(std::unique_ptr<Backend> inner);

}  // namespace eyebridge::hal
