#include "board/can_link.hpp"

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

#include "board/can_drive.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge::hal {
namespace {

namespace can = bridges::can;

Result<int> present(std::uint16_t value, int id) {
  if (value != EYECAN_ABSENT) return value;
  return fail(Errc::Unsupported, "the robot has no PSD " + std::to_string(id));
}

}  // namespace

CanLink::CanLink(std::unique_ptr<bridges::CanClient> client)
    : client_(std::move(client)), scan_(std::make_unique<can::LidarScan>()) {
  for (int id = 1; id <= 6; ++id) {
    psds_[static_cast<std::size_t>(id) - 1] = psd_metres(id).has_value() || psd_raw(id).has_value();
  }
  for (int id = 1; id <= 4; ++id) (void)encoder(id);  // Counts from here.
}

bool CanLink::has_psd(int id) const {
  return id >= 1 && id <= 6 && psds_[static_cast<std::size_t>(id) - 1];
}

Result<void> CanLink::motor_duty(int id, int percent) {
  return client_->motor(id, static_cast<std::int8_t>(percent), EYECAN_MOTOR_PERCENT);
}

Result<void> CanLink::motor_speed(int id, int ticks_per_10ms) {
  return client_->motor(id, static_cast<std::int8_t>(ticks_per_10ms), EYECAN_MOTOR_TICKS);
}

Result<void> CanLink::motor_pid(int id, int p, int i, int d) {
  const auto byte = [](int value) { return static_cast<std::uint8_t>(value); };
  return client_->pid({byte(id), byte(p), byte(i), byte(d)});
}

Result<BoardCount> CanLink::encoder(int id) {
  if (!has_encoder(id)) return fail(Errc::Unsupported, "no encoder " + std::to_string(id));
  const std::size_t index = static_cast<std::size_t>(id) - 1;
  Time at{0};
  const auto ticks = [&]() -> Result<std::int32_t> {
    if (id <= 2) {
      return client_->latest<can::Encoder12Status>(&at).map(
          [&](const can::Encoder12Status& status) { return status.ticks[index]; });
    }
    return client_->latest<can::Encoder34Status>(&at).map(
        [&](const can::Encoder34Status& status) { return status.ticks[index - 2]; });
  }();
  return ticks.map([&](std::int32_t count) {
    const std::lock_guard lock(mutex_);
    return BoardCount{counters_[index].feed32(count, client_->restarts()), at, Time{0}};
  });
}

Result<void> CanLink::servo(int id, int position) {
  return client_->servo(id, static_cast<std::uint8_t>(position));
}

Result<int> CanLink::psd_raw(int id) {
  const std::size_t index = static_cast<std::size_t>(id) - 1;
  if (id <= 4) {
    return client_->latest<can::PsdRawStatus>().and_then(
        [&](const can::PsdRawStatus& status) { return present(status.raw[index], id); });
  }
  return client_->latest<can::PsdBStatus>().and_then(
      [&](const can::PsdBStatus& status) { return present(status.raw[index - 4], id); });
}

Result<double> CanLink::psd_metres(int id) {
  const std::size_t index = static_cast<std::size_t>(id) - 1;
  const auto range =
      id <= 4 ? client_->latest<can::PsdAStatus>().and_then([&](const can::PsdAStatus& status) {
        return present(status.range_mm[index], id);
      })
              : client_->latest<can::PsdBStatus>().and_then([&](const can::PsdBStatus& status) {
                  return present(status.range_mm[index - 4], id);
                });
  return range.map([](int mm) { return std::min(mm_to_m(mm), kBoardOutOfRange); });
}

Result<void> CanLink::scan(BoardScan& out) {
  const std::lock_guard lock(mutex_);
  if (auto there = client_->latest_scan(*scan_); !there) return there;
  const can::LidarHeader& header = scan_->header;
  out.shape = {deg_to_rad(header.range_deg), deg_to_rad(header.tilt_deg), header.points};
  out.ranges.resize(header.points);
  std::ranges::transform(scan_->points(), out.ranges.begin(),
                         [](std::uint16_t mm) { return std::min(mm_to_m(mm), kBoardOutOfRange); });
  return {};
}

Result<RangeMatrix::Ranges> CanLink::range_matrix(int id) {
  static_assert(std::tuple_size_v<RangeMatrix::Ranges> == can::kZoneCount);
  static_assert(RangeMatrix::kLastId == can::kMostMatrices);
  return client_->latest_zones(id).map([](const can::Zones& zones) {
    RangeMatrix::Ranges ranges{};
    std::ranges::transform(zones, ranges.begin(), [](std::uint16_t mm) {
      return std::min(mm_to_m(mm), kBoardOutOfRange);
    });
    return ranges;
  });
}

std::unique_ptr<DriveController> CanLink::make_drive(const BoardDriveShape& shape) {
  return std::make_unique<CanDrive>(*client_, shape);
}

}  // namespace eyebridge::hal
