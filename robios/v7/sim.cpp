#include "convert.hpp"
#include "eyebot.h"
#include "guarded.hpp"

namespace {

using namespace eyebridge;
using robios::Session;

template <class Value, class Body>
Value with_world(const robios::Call& call, Value failure, Body&& body) {
  return robios::guarded(call, failure, [&](Session& session) -> Result<Value> {
    hal::WorldControl* world = session.backend().world();
    if (world == nullptr) return fail(Errc::Unsupported, "SIM functions need a simulated world");
    return body(*world);
  });
}

// z is the height of a submarine above the floor, in metres; all else stands on it.
int give(const Pose& pose, double altitude, int* x, int* y, int* z, int* phi) {
  robios::store(x, robios::to_mm(pose.x));
  robios::store(y, robios::to_mm(pose.y));
  robios::store(z, robios::to_mm(altitude));
  robios::store(phi, robios::to_deg(pose.theta));
  return 0;
}

Pose pose_of(int x, int y, int phi) {
  return {mm_to_m(x), mm_to_m(y), wrap_angle(deg_to_rad(phi))};
}

}  // namespace

int SIMGetRobot(int id, int* x, int* y, int* z, int* phi) {
  give({}, 0.0, x, y, z, phi);  // an unknown id reads as zeros
  return with_world("SIMGetRobot", 1, [&](hal::WorldControl& world) -> Result<int> {
    return world.robot_pose(id).and_then([&](const Pose& pose) -> Result<int> {
      return world.robot_altitude(id).map(
          [&](double altitude) { return give(pose, altitude, x, y, z, phi); });
    });
  });
}

int SIMSetRobot(int id, int x, int y, int z, int phi) {
  return with_world("SIMSetRobot", 1, [&](hal::WorldControl& world) -> Result<int> {
    return world.set_robot_pose(id, pose_of(x, y, phi))
        .and_then([&] { return world.set_robot_altitude(id, mm_to_m(z)); })
        .map([] { return 0; });
  });
}

int SIMGetObject(int id, int* x, int* y, int* z, int* phi) {
  give({}, 0.0, x, y, z, phi);
  return with_world("SIMGetObject", 1, [&](hal::WorldControl& world) -> Result<int> {
    return world.object_pose(id).map(
        [&](const Pose& pose) { return give(pose, 0.0, x, y, z, phi); });
  });
}

int SIMSetObject(int id, int x, int y, int /*z*/, int phi) {
  return with_world("SIMSetObject", 1, [&](hal::WorldControl& world) -> Result<int> {
    return world.set_object_pose(id, pose_of(x, y, phi)).map([] { return 0; });
  });
}

int SIMGetRobotCount(void) {
  return with_world("SIMGetRobotCount", 0,
                    [](hal::WorldControl& world) -> Result<int> { return world.robot_count(); });
}

int SIMGetObjectCount(void) {
  return with_world("SIMGetObjectCount", 0,
                    [](hal::WorldControl& world) -> Result<int> { return world.object_count(); });
}
