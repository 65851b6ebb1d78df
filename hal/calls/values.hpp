#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "calls/interceptor.hpp"

namespace eyebridge::hal {

// Numbers of a recording or another process can be anything: they are limited to the type.

/// A whole number.
inline int to_whole(double value) {
  return std::isnan(value) ? 0 : static_cast<int>(std::clamp(value, -1e9, 1e9));
}
inline char to_byte(double value) {
  if (!(value > 0.0)) return 0;  // nor a number
  return static_cast<char>(static_cast<unsigned char>(std::min(value, 255.0)));
}

/// How many numbers a type is that has no fixed length.
inline constexpr std::size_t kAnyLength = static_cast<std::size_t>(-1);

/// Types of the device interfaces as numbers, and back: pack(), and unpack() of `kSize` numbers.
template <class Type>
struct AsValues;

template <>
struct AsValues<double> {
  static constexpr std::size_t kSize = 1;
  static std::array<double, 1> pack(double value) { return {value}; }
  static double unpack(std::span<const double> v) { return v[0]; }
};
template <>
struct AsValues<int> {
  static constexpr std::size_t kSize = 1;
  static std::array<double, 1> pack(int value) { return {static_cast<double>(value)}; }
  static int unpack(std::span<const double> v) { return to_whole(v[0]); }
};
template <>
struct AsValues<bool> {
  static constexpr std::size_t kSize = 1;
  static std::array<double, 1> pack(bool value) { return {value ? 1.0 : 0.0}; }
  static bool unpack(std::span<const double> v) { return v[0] != 0.0; }
};
template <>
struct AsValues<std::uint16_t> {
  static constexpr std::size_t kSize = 1;
  static std::array<double, 1> pack(std::uint16_t value) { return {static_cast<double>(value)}; }
  static std::uint16_t unpack(std::span<const double> v) {
    return static_cast<std::uint16_t>(std::clamp(to_whole(v[0]), 0, 65535));
  }
};
template <>
struct AsValues<std::size_t> {
  static constexpr std::size_t kSize = 1;
  static std::array<double, 1> pack(std::size_t value) { return {static_cast<double>(value)}; }
  static std::size_t unpack(std::span<const double> v) {
    return static_cast<std::size_t>(std::max(to_whole(v[0]), 0));
  }
};
template <>
struct AsValues<Time> {
  static constexpr std::size_t kSize = 1;
  static std::array<double, 1> pack(Time value) { return {to_seconds(value)}; }
};
template <>
struct AsValues<LineMode> {
  static constexpr std::size_t kSize = 1;
  static std::array<double, 1> pack(LineMode mode) { return {static_cast<double>(mode)}; }
  static LineMode unpack(std::span<const double> v) {
    return static_cast<LineMode>(std::clamp(to_whole(v[0]), 0, 3));
  }
};
template <>
struct AsValues<Vec2> {
  static constexpr std::size_t kSize = 2;
  static std::array<double, 2> pack(Vec2 value) { return {value.x, value.y}; }
  static Vec2 unpack(std::span<const double> v) { return {v[0], v[1]}; }
};
template <>
struct AsValues<Twist> {
  static constexpr std::size_t kSize = 2;
  static std::array<double, 2> pack(const Twist& t) { return {t.linear, t.angular}; }
  static Twist unpack(std::span<const double> v) { return {v[0], v[1]}; }
};
template <>
struct AsValues<Pose> {
  static constexpr std::size_t kSize = 3;
  static std::array<double, 3> pack(const Pose& p) { return {p.x, p.y, p.theta}; }
  static Pose unpack(std::span<const double> v) { return {v[0], v[1], v[2]}; }
};
template <>
struct AsValues<DriveGoal> {
  static constexpr std::size_t kSize = 3;
  static std::array<double, 3> pack(const DriveGoal& g) { return {g.distance, g.angle, g.speed}; }
  static DriveGoal unpack(std::span<const double> v) { return {v[0], v[1], v[2]}; }
};
template <>
struct AsValues<DriveStatus> {
  static constexpr std::size_t kSize = 4;
  static std::array<double, 4> pack(const DriveStatus& s) {
    return {static_cast<double>(s.progress), s.remaining, s.stalled_left ? 1.0 : 0.0,
            s.stalled_right ? 1.0 : 0.0};
  }
  static DriveStatus unpack(std::span<const double> v) {
    const auto progress = static_cast<DriveProgress>(std::clamp(to_whole(v[0]), 0, 2));
    return {progress, v[1], v[2] != 0.0, v[3] != 0.0};
  }
};
template <>
struct AsValues<RangeMatrix::Ranges> {
  static constexpr std::size_t kSize = std::tuple_size_v<RangeMatrix::Ranges>;
  static RangeMatrix::Ranges pack(const RangeMatrix::Ranges& ranges) { return ranges; }
  static RangeMatrix::Ranges unpack(std::span<const double> v) {
    RangeMatrix::Ranges ranges{};
    std::ranges::copy(v.first(kSize), ranges.begin());
    return ranges;
  }
};
template <>
struct AsValues<LidarShape> {
  static constexpr std::size_t kSize = 3;
  static std::array<double, 3> pack(const LidarShape& s) {
    return {s.field_of_view, s.tilt, static_cast<double>(s.points)};
  }
  static LidarShape unpack(std::span<const double> v) { return {v[0], v[1], to_whole(v[2])}; }
};

template <>
struct AsValues<std::span<const std::uint8_t>> {
  static constexpr std::size_t kSize = kAnyLength;
  static Values pack(std::span<const std::uint8_t> bytes) { return {bytes.begin(), bytes.end()}; }
};
template <>
struct AsValues<std::string> {
  static constexpr std::size_t kSize = kAnyLength;
  static Values pack(std::string_view text) {
    Values values;
    for (const char byte : text) values.push_back(static_cast<unsigned char>(byte));
    return values;
  }
  static std::string unpack(std::span<const double> values) {
    std::string text(values.size(), '\0');
    std::transform(values.begin(), values.end(), text.begin(), to_byte);
    return text;
  }
};
/// Numbers of robots.
template <>
struct AsValues<std::vector<int>> {
  static constexpr std::size_t kSize = kAnyLength;
  static Values pack(const std::vector<int>& ids) { return {ids.begin(), ids.end()}; }
  static std::vector<int> unpack(std::span<const double> values) {
    std::vector<int> ids;
    for (const double id : values) ids.push_back(static_cast<unsigned char>(to_byte(id)));
    return ids;
  }
};
/// Its sender, then its text; nothing when there is none.
template <>
struct AsValues<std::optional<RadioMessage>> {
  static constexpr std::size_t kSize = kAnyLength;
  static Values pack(const std::optional<RadioMessage>& message) {
    if (!message) return {};
    Values values = AsValues<std::string>::pack(message->text);
    values.insert(values.begin(), static_cast<double>(message->sender));
    return values;
  }
  static std::optional<RadioMessage> unpack(std::span<const double> values) {
    if (values.empty()) return std::nullopt;
    return RadioMessage{static_cast<unsigned char>(to_byte(values[0])),
                        AsValues<std::string>::unpack(values.subspan(1))};
  }
};

template <class Type>
void append(Values& values, const Type& value) {
  const auto more = AsValues<Type>::pack(value);
  values.insert(values.end(), more.begin(), more.end());
}
template <class... Types>
Values packed(const Types&... values) {
  Values all;
  (append(all, values), ...);
  return all;
}

/// The numbers of a reply as the type that the caller wants; Corrupt when they are too few or many.
template <class Type>
Result<Type> reply_as(const Call& call, const Result<Values>& reply) {
  if (!reply) return tl::unexpected(reply.error());
  constexpr std::size_t kSize = AsValues<Type>::kSize;
  if (kSize != kAnyLength && reply->size() != kSize) {
    return fail(Errc::Corrupt, fmt::format("{} {} {}: {} numbers in the reply, expected {}",
                                           call.device, call.id, call.name, reply->size(), kSize));
  }
  return AsValues<Type>::unpack(*reply);
}

}  // namespace eyebridge::hal
