#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "eyebridge/base/result.hpp"
#include "eyebridge/bridges/dbc/database.hpp"

namespace eyebridge::bridges::dbc {

// Signals in the bytes of a frame. Pure; any thread.

/// Whether all bits of `signal` lie within `bytes` bytes.
bool fits(const Signal& signal, std::size_t bytes);
/// Whether the frame holds signal `index` of `message`: its bits are there, and the multiplexers
/// select it.
bool is_present(const Message& message, std::size_t index, std::span<const std::uint8_t> data);

/// The signal's bits, as an unsigned number. It must fit.
std::uint64_t raw_bits(const Signal& signal, std::span<const std::uint8_t> data);
/// Writes the lowest bits of `bits`, leaving all others as they are. It must fit.
void put_bits(const Signal& signal, std::uint64_t bits, std::span<std::uint8_t> data);

/// `bits` with their sign; of a float the nearest whole number, 0 for what is none.
std::int64_t whole_number(const Signal& signal, std::uint64_t bits);
/// The value in the signal's unit. Of a float it may be no finite number.
double value_of(const Signal& signal, std::uint64_t bits);
/// The bits whose value is nearest to `value`. Fails with OutOfRange for what is not finite, or
/// beyond the signal's bits or its minimum and maximum by more than half a step.
Result<std::uint64_t> bits_for(const Signal& signal, double value);
/// Smallest and largest value that bits_for() accepts.
struct ValueRange {
  double lowest = 0;
  double highest = 0;
};
ValueRange value_range(const Signal& signal);

}  // namespace eyebridge::bridges::dbc
