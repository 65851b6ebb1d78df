#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <optional>

#include "eyebridge/base/clock.hpp"

namespace eyebridge::hal {

/// What a cell holds at one moment.
struct Note {
  std::array<double, 4> values{};  ///< As many as its quantity has, in SI units.
  Time stamp{0};                   ///< See DeviceNotes::time_of().
  std::uint64_t count = 0;         ///< Calls so far; 0: there was none.
  bool has_failed = false;         ///< The last call did: the values are older.
};

/// The last numbers of one kind that passed between a program and a device. Nobody ever waits:
/// where two threads write at once, one of the two stays. Any thread.
class NoteCell {
 public:
  using Values = std::array<double, 4>;

  void put(Time stamp, const Values& values) noexcept {
    if (!begin()) return;
    for (std::size_t i = 0; i < values.size(); ++i) {
      values_[i].store(values[i], std::memory_order_release);
    }
    end(stamp, false);
  }
  void put_failure(Time stamp) noexcept {
    if (begin()) end(stamp, true);
  }

  /// Nothing when it was being written again and again: ask later.
  [[nodiscard]] std::optional<Note> get() const noexcept {
    constexpr int kTries = 100;
    for (int i = 0; i < kTries; ++i) {
      const std::uint64_t before = turn_.load(std::memory_order_acquire);
      if (before % 2 != 0) continue;
      Note note;
      // Acquired: who sees a new number sees the turn that began before it, too.
      for (std::size_t k = 0; k < values_.size(); ++k) {
        note.values[k] = values_[k].load(std::memory_order_acquire);
      }
      note.stamp = Time(stamp_.load(std::memory_order_acquire));
      note.has_failed = failed_.load(std::memory_order_acquire);
      note.count = before / 2;
      if (turn_.load(std::memory_order_relaxed) == before) return note;
    }
    return std::nullopt;
  }

 private:
  bool begin() noexcept {
    std::uint64_t turn = turn_.load(std::memory_order_relaxed);
    return turn % 2 == 0 &&
           turn_.compare_exchange_strong(turn, turn + 1, std::memory_order_acq_rel);
  }
  void end(Time stamp, bool failed) noexcept {
    stamp_.store(stamp.count(), std::memory_order_release);
    failed_.store(failed, std::memory_order_release);
    // Nobody else writes it meanwhile: no locked addition.
    turn_.store(turn_.load(std::memory_order_relaxed) + 1, std::memory_order_release);
  }

  std::atomic<std::uint64_t> turn_{0};  ///< Odd while somebody writes.
  std::array<std::atomic<double>, 4> values_{};
  std::atomic<Time::rep> stamp_{0};
  std::atomic<bool> failed_{false};
};

}  // namespace eyebridge::hal
