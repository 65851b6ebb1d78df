#include <algorithm>
#include <cmath>
#include <mutex>

#include <fmt/format.h>

#include "call.hpp"
#include "drive_train.hpp"
#include "eyebot.h"
#include "eyebridge/base/math.hpp"
#include "eyebridge/base/units.hpp"
#include "lookup.hpp"

namespace {

using namespace eyebridge;
using robios::Session;
using robios::classic::call;
using robios::classic::doing;
using robios::classic::DriveTrain;
using robios::classic::Turn;

DriveTrain& train_of(Session& session) { return session.own<DriveTrain>(); }

/// The drive behind a handle.
Result<hal::Drive*> open_drive(Session& session, VWHandle handle) {
  if (handle != DriveTrain::kVw || !train_of(session).vw_open) {
    return fail(Errc::OutOfRange, fmt::format("handle {} is no open VW drive", handle));
  }
  hal::Drive* const drive = session.backend().drive();
  if (drive == nullptr) return fail(Errc::NoDevice, "this robot has no drive");
  return drive;
}

/// For calls that succeed or not. `body(drive, session)` gives Result<void>.
template <class Body>
int with_vw(const robios::Call& name, VWHandle handle, Body&& body) {
  return doing(name, -1, [&](Session& session) -> Result<void> {
    const std::lock_guard lock(train_of(session).mutex);
    return open_drive(session, handle).and_then([&](hal::Drive* drive) -> Result<void> {
      return body(*drive, session);
    });
  });
}

int drive_to(const robios::Call& name, VWHandle handle, const DriveGoal& goal) {
  return with_vw(name, handle, [&](hal::Drive& drive, Session& session) -> Result<void> {
    train_of(session).turn.reset();
    if (goal.distance != 0.0 || goal.angle == 0.0 || goal.speed == 0.0) return drive.start(goal);
    const Result<Pose> before = drive.odometry();
    if (!before) return tl::unexpected(before.error());
    return drive.start(goal).map([&] {
      train_of(session).turn = Turn{goal.angle, goal.speed, before->theta, session.clock().now()};
    });
  });
}

/// Radians that a turn has still to go. Odometry wraps around at half a turn: of all angles that it
/// may mean the one is meant that is nearest to what the speed lets expect.
double remaining_angle(const Turn& turn, double heading, Time now) {
  const double expected = std::min(turn.speed * to_seconds(now - turn.began), std::abs(turn.angle));
  const double sign = turn.angle < 0 ? -1.0 : 1.0;
  const double wrapped = sign * wrap_angle(heading - turn.heading);
  const double turns = std::round((expected - wrapped) / (2 * kPi));
  return std::clamp(std::abs(turn.angle) - (wrapped + turns * 2 * kPi), 0.0, std::abs(turn.angle));
}

Result<hal::DriveStatus> status_of(Session& session, VWHandle handle) {
  const std::lock_guard lock(train_of(session).mutex);
  return open_drive(session, handle).and_then([](hal::Drive* drive) { return drive->status(); });
}

}  // namespace

VWHandle VWInit(DeviceSemantics semantics, int Timescale) {
  return call("VWInit", 0, [&](Session& session) -> Result<int> {
    auto& train = train_of(session);
    const std::lock_guard lock(train.mutex);
    Result<int> known = robios::classic::find_device(session.backend(), "drive", semantics);
    if (!known) return known;
    if (Timescale < 1) {
      return fail(Errc::OutOfRange, fmt::format("timescale {}, expected 1 or more", Timescale));
    }
    hal::Drive* const drive = session.backend().drive();
    if (drive == nullptr) return fail(Errc::NoDevice, "this robot has no drive");
    if (train.vw_open) return fail(Errc::OutOfRange, "the VW drive is open already");
    const auto [left, right] = robios::classic::vw_motors(session.backend());
    if (train.motors.is_open(left) || train.motors.is_open(right) ||
        train.quads.is_open(DriveTrain::kLeft) || train.quads.is_open(DriveTrain::kRight)) {
      return fail(Errc::OutOfRange, "a motor or an encoder of the VW drive is open already");
    }
    return drive->set_odometry({}).map([&] {
      train.vw_open = true;
      train.turn.reset();
      return DriveTrain::kVw;
    });
  });
}

int VWRelease(VWHandle handle) {
  return with_vw("VWRelease", handle, [](hal::Drive& drive, Session& session) {
    train_of(session).vw_open = false;
    return drive.set_speed({});
  });
}

int VWSetSpeed(VWHandle handle, meterPerSec v, radPerSec w) {
  return with_vw("VWSetSpeed", handle, [&](hal::Drive& drive, Session& session) {
    train_of(session).turn.reset();
    return drive.set_speed({v, w});
  });
}

int VWGetSpeed(VWHandle handle, SpeedType* vw) {
  return with_vw("VWGetSpeed", handle, [&](hal::Drive& drive, Session&) -> Result<void> {
    if (vw == nullptr) return robios::null_pointer();
    return drive.measured_twist().map([&](const Twist& twist) {
      *vw = {static_cast<float>(twist.linear), static_cast<float>(twist.angular)};
    });
  });
}

int VWSetPosition(VWHandle handle, meter x, meter y, radians phi) {
  return with_vw("VWSetPosition", handle, [&](hal::Drive& drive, Session& session) -> Result<void> {
    const Result<Pose> before = drive.odometry();
    if (!before) return tl::unexpected(before.error());
    if (!std::isfinite(phi)) return fail(Errc::OutOfRange, "the heading is no number");
    const double heading = wrap_angle(phi);
    return drive.set_odometry({x, y, heading}).map([&] {
      auto& turn = train_of(session).turn;
      if (turn) turn->heading += heading - before->theta;
    });
  });
}

int VWGetPosition(VWHandle handle, PositionType* pos) {
  return with_vw("VWGetPosition", handle, [&](hal::Drive& drive, Session&) -> Result<void> {
    if (pos == nullptr) return robios::null_pointer();
    return drive.odometry().map([&](const Pose& pose) {
      *pos = {static_cast<float>(pose.x), static_cast<float>(pose.y),
              static_cast<float>(pose.theta)};
    });
  });
}

int VWStartControl(VWHandle handle, float Vv, float Tv, float Vw, float Tw) {
  return with_vw("VWStartControl", handle, [&](hal::Drive&, Session&) -> Result<void> {
    const bool numbers =
        std::isfinite(Vv) && std::isfinite(Tv) && std::isfinite(Vw) && std::isfinite(Tw);
    if (numbers && Vv >= 0 && Vw >= 0 && Tv > 0 && Tw > 0) return {};
    return fail(Errc::OutOfRange,
                fmt::format("gains {} {} {} {}: expected V >= 0 and T > 0", Vv, Tv, Vw, Tw));
  });
}

int VWStopControl(VWHandle handle) {
  return with_vw("VWStopControl", handle, [](hal::Drive&, Session&) -> Result<void> { return {}; });
}

int VWDriveStraight(VWHandle handle, meter delta, meterPerSec v) {
  return drive_to("VWDriveStraight", handle, {delta, 0.0, std::abs(v)});
}

int VWDriveTurn(VWHandle handle, radians delta, radPerSec w) {
  return drive_to("VWDriveTurn", handle, {0.0, delta, std::abs(w)});
}

int VWDriveCurve(VWHandle handle, meter delta_l, radians delta_phi, meterPerSec v) {
  // Without a length there is no arc, and no speed for a turn.
  return drive_to("VWDriveCurve", handle,
                  {delta_l, delta_l == 0.0F ? 0.0 : delta_phi, std::abs(v)});
}

float VWDriveRemain(VWHandle handle) {
  return call("VWDriveRemain", 0.0F, [&](Session& session) -> Result<float> {
    const Result<hal::DriveStatus> status = status_of(session, handle);
    if (!status) return tl::unexpected(status.error());
    if (status->progress != hal::DriveProgress::Driving) return 0.0F;
    auto& train = train_of(session);
    const std::lock_guard lock(train.mutex);
    const auto& turn = train.turn;
    if (!turn) return static_cast<float>(status->remaining);
    return session.backend().drive()->odometry().map([&](const Pose& pose) {
      return static_cast<float>(remaining_angle(*turn, pose.theta, session.clock().now()));
    });
  });
}

int VWDriveDone(VWHandle handle) {
  return call("VWDriveDone", -1, [&](Session& session) -> Result<int> {
    return status_of(session, handle).map([](const hal::DriveStatus& status) {
      return status.progress == hal::DriveProgress::Driving ? 0 : 1;
    });
  });
}

int VWDriveWait(VWHandle handle) {
  return doing("VWDriveWait", -1, [&](Session& session) -> Result<void> {
    for (;;) {
      const Result<hal::DriveStatus> status = status_of(session, handle);
      if (!status) return tl::unexpected(status.error());
      if (status->progress != hal::DriveProgress::Driving) return {};
      robios::classic::wait_until(session.clock().now() + robios::classic::kTick);
    }
  });
}

int VWStalled(VWHandle handle) {
  return call("VWStalled", -1, [&](Session& session) -> Result<int> {
    return status_of(session, handle).map([](const hal::DriveStatus& status) {
      return status.stalled_left || status.stalled_right ? 1 : 0;
    });
  });
}
