#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>

#include "eyebridge/base/result.hpp"

namespace eyebridge::hal {

/// One direction of a line, in memory that two processes share. All zero: empty.
struct SharedRing {
  static constexpr std::uint32_t kRoom = 1U << 14U;  ///< Bytes; what is longer goes in parts.

  alignas(64) std::atomic<std::uint32_t> written;  ///< Bytes so far, modulo 2^32.
  std::atomic<std::uint32_t> writer_sleeps;        ///< It wants a sign when there is room.
  alignas(64) std::atomic<std::uint32_t> read;
  std::atomic<std::uint32_t> reader_sleeps;  ///< It wants a sign when there is something.
  alignas(64) std::uint8_t bytes[kRoom];
};
static_assert(std::atomic<std::uint32_t>::is_always_lock_free, "two processes share them");

// Each end keeps its own count and validates the count of the other end, so corrupted memory cannot
// cause an access outside the ring. One thread at a time each.

class RingWriter {
 public:
  explicit RingWriter(SharedRing& ring) : ring_(ring), written_(ring.written) {}
  /// Writes as much of `bytes` as there is room for; how much. Corrupt for a count that cannot be.
  Result<std::size_t> write(std::span<const std::uint8_t> bytes);
  [[nodiscard]] bool is_full() const;
  /// True when the reader wants a sign, which the caller has to give now.
  [[nodiscard]] bool must_wake() const;
  /// Says that this end wants one, or no longer.
  void set_asleep(bool asleep) const;

 private:
  SharedRing& ring_;
  std::uint32_t written_;
};

class RingReader {
 public:
  explicit RingReader(SharedRing& ring) : ring_(ring), read_(ring.read) {}
  /// Takes as many bytes as there are and `room` has; how many. Corrupt for a count that cannot be.
  Result<std::size_t> read(std::span<std::uint8_t> room);
  [[nodiscard]] bool is_empty() const;
  /// True when the writer wants a sign, which the caller has to give now.
  [[nodiscard]] bool must_wake() const;
  /// Says that this end wants one, or no longer.
  void set_asleep(bool asleep) const;

 private:
  SharedRing& ring_;
  std::uint32_t read_;
};

}  // namespace eyebridge::hal
