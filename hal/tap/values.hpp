#pragma once

#include <fmt/format.h>

#include "tap/tap.hpp"

namespace eyebridge::hal {

/// Types of the device interfaces as numbers, and back. `Size` is how many they are.
template <class Type>
struct AsValues;

template <>
struct AsValues<double> {
  static constexpr std::size_t kSize = 1;
  static Values pack(double value) { return {value}; }
  static double unpack(const Values& v) { return v[0]; }
};
template <>
struct AsValues<int> {
  static constexpr std::size_t kSize = 1;
  static Values pack(int value) { return {static_cast<double>(value)}; }
  static int unpack(const Values& v) { return static_cast<int>(v[0]); }
};
template <>
struct AsValues<bool> {
  static constexpr std::size_t kSize = 1;
  static Values pack(bool value) { return {value ? 1.0 : 0.0}; }
  static bool unpack(const Values& v) { return v[0] != 0.0; }
};
template <>
struct AsValues<Vec2> {
  static constexpr std::size_t kSize = 2;
  static Values pack(Vec2 value) { return {value.x, value.y}; }
  static Vec2 unpack(const Values& v) { return {v[0], v[1]}; }
};
template <>
struct AsValues<Twist> {
  static constexpr std::size_t kSize = 2;
  static Values pack(const Twist& t) { return {t.linear, t.angular}; }
  static Twist unpack(const Values& v) { return {v[0], v[1]}; }
};
template <>
struct AsValues<Pose> {
  static constexpr std::size_t kSize = 3;
  static Values pack(const Pose& p) { return {p.x, p.y, p.theta}; }
  static Pose unpack(const Values& v) { return {v[0], v[1], v[2]}; }
};
template <>
struct AsValues<DriveStatus> {
  static constexpr std::size_t kSize = 4;
  static Values pack(const DriveStatus& s) {
    return {static_cast<double>(s.progress), s.remaining, s.stalled_left ? 1.0 : 0.0,
            s.stalled_right ? 1.0 : 0.0};
  }
  static DriveStatus unpack(const Values& v) {
    return {static_cast<DriveProgress>(static_cast<int>(v[0])), v[1], v[2] != 0.0, v[3] != 0.0};
  }
};

/// The numbers of a reply as the type that the caller wants; Corrupt when they are too few or many.
template <class Type>
Result<Type> reply_as(const Call& call, const Result<Values>& reply) {
  if (!reply) return tl::unexpected(reply.error());
  if (reply->size() != AsValues<Type>::kSize) {
    return fail(Errc::Corrupt,
                fmt::format("{} {} {}: {} numbers in the reply, expected {}", call.device, call.id,
                            call.name, reply->size(), AsValues<Type>::kSize));
  }
  return AsValues<Type>::unpack(*reply);
}

}  // namespace eyebridge::hal
