#include "sources/frame_schedule.hpp"

#include <algorithm>
#include <string>

namespace eyebridge::camera {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

Time time_of(std::int64_t number) {
  // Whole seconds apart: number * kSecond would overflow after ten years only, but stays exact so.
  constexpr std::int64_t kRate = FrameSchedule::kFramesPerSecond;
  return Time(number / kRate * kSecond + number % kRate * kSecond / kRate);
}

/// The last frame time that is not after `now`.
std::int64_t number_at(Time now) {
  constexpr std::int64_t kRate = FrameSchedule::kFramesPerSecond;
  const std::int64_t whole = now.count() / kSecond;
  std::int64_t number = whole * kRate + now.count() % kSecond * kRate / kSecond;
  if (time_of(number + 1) <= now) ++number;  // time_of() rounds down
  return number;
}

}  // namespace

Result<FrameSlot> FrameSchedule::next(Clock& clock, Time deadline) {
  const Time now = clock.now();
  const std::int64_t current = number_at(now);
  const std::int64_t upcoming = time_of(current) == now ? current : current + 1;
  std::int64_t number = std::max(next_, upcoming);
  const Time due = time_of(number);
  if (due > deadline) {
    clock.wait_until(deadline);
    return fail(Errc::Timeout, "camera: no frame before " + std::to_string(to_seconds(deadline)) +
                                   " s, the next is due at " + std::to_string(to_seconds(due)) +
                                   " s");
  }
  clock.wait_until(due);
  // A wall clock may wake us late; frames missed meanwhile are gone, as with a real camera.
  number = std::max(number, number_at(clock.now()));
  if (first_ < 0) first_ = number;
  next_ = number + 1;
  return FrameSlot{time_of(number), static_cast<std::uint64_t>(number - first_)};
}

Result<void> FrameSchedule::check_size(int width, int height) {
  if (width >= 1 && width <= kLargestSide && height >= 1 && height <= kLargestSide) return {};
  return fail(Errc::OutOfRange, "camera: a frame of " + std::to_string(width) + " x " +
                                    std::to_string(height) + " pixels, each side must be 1 ... " +
                                    std::to_string(kLargestSide));
}

}  // namespace eyebridge::camera
