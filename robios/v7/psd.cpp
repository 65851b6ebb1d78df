#include <atomic>

#include "convert.hpp"
#include "eyebot.h"
#include "guarded.hpp"
#include "no_device.hpp"

namespace {

using namespace eyebridge;

/// Which numbers the robot's program uses: asked once, texts are slow.
struct PsdNumbers {
  enum class Kind : char { Unknown, Robot, Of2015 };
  std::atomic<Kind> kind = Kind::Unknown;

  bool are_old(robios::Session& session) {
    if (kind == Kind::Unknown) {
      const bool old = session.config().text("psd_numbers") == "2015";
      kind = old ? Kind::Of2015 : Kind::Robot;
    }
    return kind == Kind::Of2015;
  }
};

/// The robot's number of a program's `psd`: programs before 2018 took 1 for left and 2 for front.
int in_robot(robios::Session& session, int psd) {
  return session.own<PsdNumbers>().are_old(session) && (psd == 1 || psd == 2) ? 3 - psd : psd;
}

Result<hal::RangeSensor*> find(robios::Session& session, int psd) {
  hal::RangeSensor* sensor = session.backend().range_sensor(in_robot(session, psd));
  if (sensor == nullptr) return robios::no_device(session, "PSD", psd);
  return sensor;
}

}  // namespace

int PSDGet(int psd) {
  return robios::guarded("PSDGet", -1, [&](robios::Session& session) -> Result<int> {
    return find(session, psd).and_then([](hal::RangeSensor* sensor) {
      return sensor->read().map(robios::to_mm);
    });
  });
}

int PSDGetRaw(int psd) {
  return robios::guarded("PSDGetRaw", -1, [&](robios::Session& session) -> Result<int> {
    return find(session, psd).and_then([](hal::RangeSensor* sensor) { return sensor->read_raw(); });
  });
}
