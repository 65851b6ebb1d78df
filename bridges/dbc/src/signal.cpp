#include "eyebridge/bridges/dbc/signal.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string>

namespace eyebridge::bridges::dbc {
namespace {

/// The bit after `bit`, on the way from a Motorola signal's most significant bit down.
int next_down(int bit) { return bit % 8 == 0 ? bit + 15 : bit - 1; }

int last_byte(const Signal& signal) {
  if (signal.order == ByteOrder::Intel) return (signal.start + signal.length - 1) / 8;
  const int above = 7 - signal.start % 8;  // bits of its first byte that are not its own
  return signal.start / 8 + (above + signal.length - 1) / 8;
}

bool bit_at(std::span<const std::uint8_t> data, int bit) {
  return (data[static_cast<std::size_t>(bit / 8)] >> (bit % 8) & 1U) != 0;
}

/// Smallest and largest whole number of the signal's bits.
ValueRange raw_range(const Signal& signal) {
  if (signal.kind == NumberKind::Signed) {
    const double half = std::ldexp(1.0, signal.length - 1);
    return {-half, half - 1};
  }
  return {0, std::ldexp(1.0, signal.length) - 1};
}

bool is_float(const Signal& signal) {
  return signal.kind == NumberKind::Float32 || signal.kind == NumberKind::Float64;
}

bool has_limits(const Signal& signal) {
  return signal.minimum != signal.maximum && signal.minimum < signal.maximum;
}

}  // namespace

bool fits(const Signal& signal, std::size_t bytes) {
  return static_cast<std::size_t>(last_byte(signal)) < bytes;
}

bool is_present(const Message& message, std::size_t index, std::span<const std::uint8_t> data) {
  const Signal* signal = &message.signals[index];
  if (!fits(*signal, data.size())) return false;
  while (signal->selector) {
    const Signal& selector = message.signals[*signal->selector];
    if (!fits(selector, data.size())) return false;
    const std::uint64_t value = raw_bits(selector, data);
    const auto selects = [&](const SelectorRange& range) {
      return value >= range.first && value <= range.last;
    };
    if (std::ranges::none_of(signal->selected_by, selects)) return false;
    signal = &selector;
  }
  return true;
}

std::uint64_t raw_bits(const Signal& signal, std::span<const std::uint8_t> data) {
  std::uint64_t bits = 0;
  if (signal.order == ByteOrder::Motorola) {
    for (int i = 0, bit = signal.start; i < signal.length; ++i, bit = next_down(bit)) {
      bits = bits << 1 | (bit_at(data, bit) ? 1U : 0U);
    }
    return bits;
  }
  for (int i = signal.length - 1; i >= 0; --i) {
    bits = bits << 1 | (bit_at(data, signal.start + i) ? 1U : 0U);
  }
  return bits;
}

void put_bits(const Signal& signal, std::uint64_t bits, std::span<std::uint8_t> data) {
  const auto put = [&](int bit, bool on) {
    std::uint8_t& byte = data[static_cast<std::size_t>(bit / 8)];
    const unsigned mask = 1U << (bit % 8);
    byte = static_cast<std::uint8_t>(on ? byte | mask : byte & ~mask);
  };
  if (signal.order == ByteOrder::Motorola) {
    for (int i = signal.length - 1, bit = signal.start; i >= 0; --i, bit = next_down(bit)) {
      put(bit, (bits >> i & 1U) != 0);
    }
    return;
  }
  for (int i = 0; i < signal.length; ++i) put(signal.start + i, (bits >> i & 1U) != 0);
}

std::int64_t whole_number(const Signal& signal, std::uint64_t bits) {
  switch (signal.kind) {
    case NumberKind::Unsigned:
      return static_cast<std::int64_t>(bits);
    case NumberKind::Signed: {
      const int unused = 64 - signal.length;
      return static_cast<std::int64_t>(bits << unused) >> unused;
    }
    case NumberKind::Float32:
    case NumberKind::Float64:
      break;
  }
  const double number =
      signal.kind == NumberKind::Float32
          ? static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)))
          : std::bit_cast<double>(bits);
  constexpr double kMost = 9e18;
  return std::isfinite(number) && std::abs(number) < kMost ? std::llround(number) : 0;
}

double value_of(const Signal& signal, std::uint64_t bits) {
  double raw = 0;
  switch (signal.kind) {
    case NumberKind::Unsigned:
      raw = static_cast<double>(bits);
      break;
    case NumberKind::Signed:
      raw = static_cast<double>(whole_number(signal, bits));
      break;
    case NumberKind::Float32:
      raw = static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
      break;
    case NumberKind::Float64:
      raw = std::bit_cast<double>(bits);
      break;
  }
  return raw * signal.factor + signal.offset;
}

ValueRange value_range(const Signal& signal) {
  ValueRange range{-std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
  if (!is_float(signal)) {
    const ValueRange raw = raw_range(signal);
    const double a = raw.lowest * signal.factor + signal.offset;
    const double b = raw.highest * signal.factor + signal.offset;
    range = {std::min(a, b), std::max(a, b)};
  }
  if (!has_limits(signal)) return range;
  return {std::max(range.lowest, signal.minimum), std::min(range.highest, signal.maximum)};
}

Result<std::uint64_t> bits_for(const Signal& signal, double value) {
  const ValueRange range = value_range(signal);
  const double half_step = is_float(signal) ? 0.0 : std::abs(signal.factor) / 2;
  if (!std::isfinite(value) || value < range.lowest - half_step ||
      value > range.highest + half_step) {
    return fail(Errc::OutOfRange, signal.name + " cannot be " + std::to_string(value) +
                                      ", expected " + std::to_string(range.lowest) + " … " +
                                      std::to_string(range.highest) + " " + signal.unit);
  }
  const double raw = (value - signal.offset) / signal.factor;
  if (!std::isfinite(raw)) return fail(Errc::OutOfRange, signal.name + " has the factor 0");
  if (signal.kind == NumberKind::Float64) return std::bit_cast<std::uint64_t>(raw);
  if (signal.kind == NumberKind::Float32) {
    return std::bit_cast<std::uint32_t>(static_cast<float>(raw));
  }
  const ValueRange limits = raw_range(signal);
  const double whole = std::clamp(std::round(raw), limits.lowest, limits.highest);
  // Beyond, doubles have no whole numbers of 64 bits.
  constexpr double kSigned = 0x1p63;
  constexpr double kUnsigned = 0x1p64;
  if (signal.kind == NumberKind::Signed) {
    const std::int64_t number = whole >= kSigned ? std::numeric_limits<std::int64_t>::max()
                                                 : static_cast<std::int64_t>(whole);
    const std::uint64_t bits = static_cast<std::uint64_t>(number);
    return signal.length == 64 ? bits : bits & ((std::uint64_t{1} << signal.length) - 1);
  }
  return whole >= kUnsigned ? std::numeric_limits<std::uint64_t>::max()
                            : static_cast<std::uint64_t>(whole);
}

}  // namespace eyebridge::bridges::dbc
