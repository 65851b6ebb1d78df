#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "convert.hpp"
#include "eyebot.h"
#include "guarded.hpp"

namespace {

using namespace eyebridge;
using robios::Session;

// How often VWWait looks: one step of the 100 Hz control loop.
constexpr Time kPoll = std::chrono::milliseconds(10);

template <class Body>
int with_drive(const robios::Call& call, int failure, Body&& body) {
  return robios::guarded(call, failure, [&](Session& session) -> Result<int> {
    hal::Drive* drive = session.backend().drive();
    if (drive == nullptr) return fail(Errc::NoDevice, "this robot has no drive");
    return body(*drive, session);
  });
}

int start(const robios::Call& call, const DriveGoal& goal) {
  return with_drive(call, 1, [&](hal::Drive& drive, Session&) -> Result<int> {
    return drive.start(goal).map([] { return 0; });
  });
}

/// Speeds are taken by magnitude: the sign of a movement is that of its distance or angle.
double magnitude_mm(int speed) { return std::abs(mm_to_m(speed)); }

}  // namespace

int VWSetSpeed(int lin_speed, int ang_speed) {
  return with_drive("VWSetSpeed", 1, [&](hal::Drive& drive, Session&) -> Result<int> {
    return drive.set_speed({mm_to_m(lin_speed), deg_to_rad(ang_speed)}).map([] { return 0; });
  });
}

int VWGetSpeed(int* lin_speed, int* ang_speed) {
  return with_drive("VWGetSpeed", 1, [&](hal::Drive& drive, Session&) -> Result<int> {
    return drive.measured_twist().map([&](const Twist& twist) {
      robios::store(lin_speed, robios::to_mm(twist.linear));
      robios::store(ang_speed, robios::to_deg(twist.angular));
      return 0;
    });
  });
}

int VWSetPosition(int x, int y, int phi) {
  return with_drive("VWSetPosition", 1, [&](hal::Drive& drive, Session&) -> Result<int> {
    return drive.set_odometry({mm_to_m(x), mm_to_m(y), wrap_angle(deg_to_rad(phi))}).map([] {
      return 0;
    });
  });
}

int VWGetPosition(int* x, int* y, int* phi) {
  return with_drive("VWGetPosition", 1, [&](hal::Drive& drive, Session&) -> Result<int> {
    return drive.odometry().map([&](const Pose& pose) {
      robios::store(x, robios::to_mm(pose.x));
      robios::store(y, robios::to_mm(pose.y));
      robios::store(phi, robios::to_deg(pose.theta));
      return 0;
    });
  });
}

int VWStraight(int dist, int lin_speed) {
  return start("VWStraight", {mm_to_m(dist), 0.0, magnitude_mm(lin_speed)});
}

int VWTurn(int angle, int ang_speed) {
  return start("VWTurn", {0.0, deg_to_rad(angle), std::abs(deg_to_rad(ang_speed))});
}

int VWCurve(int dist, int angle, int lin_speed) {
  // As in EyeSim: no distance, no motion; driven backwards, the same turn of the wheels turns the
  // heading the other way.
  const double turn = dist == 0 ? 0.0 : deg_to_rad(angle) * (dist < 0 ? -1.0 : 1.0);
  return start("VWCurve", {mm_to_m(dist), turn, magnitude_mm(lin_speed)});
}

int VWDrive(int dx, int dy, int lin_speed) {
  // Equality is a quarter of a circle, which EyeSim's own demonstration drives.
  if (dx <= 0 || dx < std::abs(static_cast<long>(dy))) {
    return robios::guarded("VWDrive", 1, [&](Session&) -> Result<int> {
      return fail(Errc::OutOfRange,
                  fmt::format("the point {}, {} must lie ahead: dx >= |dy|", dx, dy));
    });
  }
  // The circle through the robot, tangent to its heading, and the point: half the turn is the
  // bearing of the point.
  const double bearing = arc_tan2(dy, dx);
  const double chord = norm({mm_to_m(dx), mm_to_m(dy)});
  const double length = bearing == 0.0 ? chord : chord * bearing / sin_cos(bearing).sin;
  return start("VWDrive", {length, 2 * bearing, magnitude_mm(lin_speed)});
}

int VWRemain(void) {
  return with_drive("VWRemain", 0, [](hal::Drive& drive, Session&) -> Result<int> {
    return drive.status().map([](const hal::DriveStatus& s) { return robios::to_mm(s.remaining); });
  });
}

int VWDone(void) {
  return with_drive("VWDone", -1, [](hal::Drive& drive, Session&) -> Result<int> {
    return drive.status().map([](const hal::DriveStatus& s) {
      switch (s.progress) {
        case hal::DriveProgress::Done:
          return 1;
        case hal::DriveProgress::Driving:
          return 0;
        case hal::DriveProgress::Failed:
          return -1;
      }
      return -1;
    });
  });
}

int VWWait(void) {
  return with_drive("VWWait", 1, [](hal::Drive& drive, Session& session) -> Result<int> {
    for (;;) {
      const Result<hal::DriveStatus> status = drive.status();
      if (!status) return tl::unexpected(status.error());
      if (status->progress != hal::DriveProgress::Driving) {
        return status->progress == hal::DriveProgress::Done ? 0 : 1;
      }
      session.wait_until(session.clock().now() + kPoll);
    }
  });
}

int VWStalled(void) {
  return with_drive("VWStalled", 0, [](hal::Drive& drive, Session&) -> Result<int> {
    return drive.status().map([](const hal::DriveStatus& s) {
      return (s.stalled_left ? 1 : 0) + (s.stalled_right ? 2 : 0);
    });
  });
}

int VWControl(int Vv, int Tv, int Vw, int Tw) {
  return with_drive("VWControl", 1, [&](hal::Drive& drive, Session&) -> Result<int> {
    for (const int gain : {Vv, Tv, Vw, Tw}) {
      if (gain < 0 || gain > 255) {
        return fail(Errc::OutOfRange, fmt::format("gain {}, expected 0..255", gain));
      }
    }
    return drive.set_speed({}).map([] { return 0; });
  });
}

int VWControlOff(void) {
  return with_drive("VWControlOff", 1, [](hal::Drive&, Session& session) -> Result<int> {
    // A motor that is used takes the robot out of v-omega control.
    constexpr int kMostMotors = 4;
    for (int id = 1; id <= kMostMotors; ++id) {
      hal::Motor* motor = session.backend().motor(id);
      if (motor == nullptr && id == 1) {
        return fail(Errc::NoDevice, "this robot has no motors of its own");
      }
      if (motor == nullptr) continue;
      if (const auto stopped = motor->set_duty(0.0); !stopped) {
        return tl::unexpected(stopped.error());
      }
    }
    return 0;
  });
}

int VWDriveRemain(void) { return VWRemain(); }
int VWDriveDone(void) { return VWDone(); }
int VWDriveWait(void) { return VWWait(); }
