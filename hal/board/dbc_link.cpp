#include "board/dbc_link.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "board/dbc_pose_controller.hpp"
#include "eyebridge/base/math.hpp"

namespace eyebridge::hal {
namespace {

/// The steps that a counter of `bits` bits moved, at most half of its range in either direction.
std::int64_t moved(std::uint64_t from, std::uint64_t to, int bits) {
  const int unused = 64 - bits;
  return static_cast<std::int64_t>((to - from) << unused) >> unused;
}

}  // namespace

DbcLink::DbcLink(std::unique_ptr<bridges::DbcClient> client, DbcRobot robot, Clock& clock)
    : robot_(std::move(robot)), client_(std::move(client)), clock_(clock) {
  for (const DbcEncoder& encoder : robot_.encoders) encoders_[encoder.id].encoder = encoder;
  for (const bridges::DbcSetPoint& wheel : robot_.plan.wheels) {
    command_period_ = std::max(command_period_, robot_.plan.commands[wheel.command].period);
  }
  for (const auto& [id, counter] : encoders_) (void)encoder(id);  // Counts from here.
}

tl::unexpected<Error> DbcLink::lacks(const char* what) const {
  return fail(Errc::Unsupported,
              robot_.plan.robot + ": its mapping file does not say anything about " + what);
}

Result<void> DbcLink::turn(int id, double metres_per_second) {
  if (!has_motor(id)) return fail(Errc::Unsupported, "no motor " + std::to_string(id));
  const auto index = static_cast<std::size_t>(id) - 1;
  const double most = robot_.max_wheel_speed;
  return client_->wheel(
      index, std::clamp(metres_per_second, -most, most) * robot_.value_per_speed.at(index));
}

Result<void> DbcLink::motor_duty(int id, int percent) {
  return turn(id, robot_.max_wheel_speed * percent / 100);
}

Result<void> DbcLink::motor_speed(int id, int ticks_per_10ms) {
  constexpr double kPeriods = 100;  // in a second
  return turn(id, ticks_per_10ms * kPeriods / robot_.tables.drive.left_ticks_per_metre);
}

Result<BoardCount> DbcLink::encoder(int id) {
  const std::lock_guard lock(mutex_);
  const auto found = encoders_.find(id);
  if (found == encoders_.end()) {
    return fail(Errc::Unsupported, "no encoder " + std::to_string(id));
  }
  Counter& counter = found->second;
  return client_->latest(counter.encoder.reading).map([&](const bridges::DbcValue& value) {
    const auto bits = static_cast<std::uint64_t>(value.whole);
    const std::uint32_t now = client_->generation();
    if (counter.generation == now) counter.total += moved(counter.last, bits, counter.encoder.bits);
    counter.generation = now;
    counter.last = bits;
    // Faster than it can be told to, nothing can be controlled.
    constexpr Time kSlack = std::chrono::milliseconds(2);
    if (!counter.count || value.at - counter.count->at + kSlack >= command_period_) {
      const double ticks =
          std::round(static_cast<double>(counter.total) * counter.encoder.ticks_per_bit);
      const auto whole = static_cast<std::int64_t>(std::clamp(ticks, -9e18, 9e18));
      counter.count = BoardCount{static_cast<std::int32_t>(static_cast<std::uint32_t>(whole)),
                                 value.at, Time{0}};
    }
    return *counter.count;
  });
}

const DbcRange* DbcLink::find_range(int id) const {
  const auto found = std::ranges::find(robot_.ranges, id, &DbcRange::id);
  return found == robot_.ranges.end() ? nullptr : &*found;
}

Result<int> DbcLink::psd_raw(int id) {
  const DbcRange* const range = find_range(id);
  if (range == nullptr) return fail(Errc::Unsupported, "no distance " + std::to_string(id));
  return client_->latest(range->distance.reading).map([](const bridges::DbcValue& value) {
    constexpr std::int64_t kMost = 2'000'000'000;
    return static_cast<int>(std::clamp(value.whole, -kMost, kMost));
  });
}

Result<double> DbcLink::quantity(const DbcQuantity& quantity) const {
  return client_->latest(quantity.reading)
      .and_then([&](const bridges::DbcValue& value) -> Result<double> {
        const double out = value.value * quantity.scale;
        if (std::isfinite(out)) return out;
        return fail(Errc::Corrupt, robot_.plan.robot + " sends no finite number; expected one");
      });
}

Result<double> DbcLink::psd_metres(int id) {
  const DbcRange* const range = find_range(id);
  if (range == nullptr) return fail(Errc::Unsupported, "no distance " + std::to_string(id));
  return quantity(range->distance).map([](double metres) {
    return std::clamp(metres, 0.0, kBoardOutOfRange);
  });
}

Result<Pose> DbcLink::pose() const {
  if (!robot_.pose) return lacks("its pose");
  const auto x = quantity(robot_.pose->x);
  const auto y = quantity(robot_.pose->y);
  const auto theta = quantity(robot_.pose->theta);
  for (const auto* value : {&x, &y, &theta}) {
    if (!*value) return tl::unexpected(value->error());
  }
  return Pose{*x, *y, wrap_angle(*theta)};
}

std::unique_ptr<DriveController> DbcLink::make_drive(const BoardDriveShape& shape) {
  if (!robot_.pose || !has_encoder(1) || !has_encoder(2)) return nullptr;  // the host's own
  return std::make_unique<DbcPoseController>(*this, clock_, shape);
}

}  // namespace eyebridge::hal
