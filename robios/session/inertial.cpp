#include "convert.hpp"
#include "eyebridge.h"
#include "guarded.hpp"

namespace {

using namespace eyebridge;

/// Hundredths of a degree: what a gyroscope tells is lost in whole ones.
int to_hundredths(double radians) { return robios::to_whole(100.0 * rad_to_deg(radians)); }

}  // namespace

int EYEBRIDGEGyroscopeGet(int* rate) {
  return robios::guarded("EYEBRIDGEGyroscopeGet", 1, [&](robios::Session& session) -> Result<int> {
    if (rate == nullptr) return robios::null_pointer();
    hal::Gyroscope* gyroscope = session.backend().gyroscope();
    if (gyroscope == nullptr) return fail(Errc::NoDevice, "this robot has no gyroscope");
    return gyroscope->read().map([&](double turning) {
      *rate = to_hundredths(turning);
      return 0;
    });
  });
}

int EYEBRIDGEAccelerometerGet(int* forward, int* left) {
  return robios::guarded("EYEBRIDGEAccelerometerGet", 1,
                         [&](robios::Session& session) -> Result<int> {
                           if (forward == nullptr || left == nullptr) return robios::null_pointer();
                           hal::Accelerometer* accelerometer = session.backend().accelerometer();
                           if (accelerometer == nullptr) {
                             return fail(Errc::NoDevice, "this robot has no accelerometer");
                           }
                           return accelerometer->read().map([&](Vec2 felt) {
                             *forward = robios::to_mm(felt.x);
                             *left = robios::to_mm(felt.y);
                             return 0;
                           });
                         });
}
