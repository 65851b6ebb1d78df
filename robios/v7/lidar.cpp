#include <algorithm>
#include <cmath>
#include <mutex>
#include <vector>

#include "convert.hpp"
#include "globals.hpp"
#include "guarded.hpp"
#include "no_device.hpp"
#include <eyebot.h>

int LIDAR_RESOLUTION = 360;

namespace {

using namespace eyebridge;

/// A scan and the shape it is of belong together: one thread of a robot at a time.
struct ScanTurn {
  std::mutex mutex;
};

Result<hal::Lidar*> find(robios::Session& session) {
  hal::Lidar* lidar = session.backend().lidar();
  if (lidar == nullptr) return robios::no_device(session, "lidar", 1, "lidar");
  return lidar;
}

Result<void> configure(hal::Lidar& lidar, const hal::LidarShape& shape) {
  return lidar.configure(shape.field_of_view, shape.tilt, shape.points);
}

/// One scan of the present shape in whole millimetres, rounded down as in EyeSim.
Result<void> scan(hal::Lidar& lidar, std::vector<int>& out) {
  std::vector<double> ranges(static_cast<std::size_t>(lidar.points()));
  if (Result<void> read = lidar.read(ranges); !read) return read;
  out.resize(ranges.size());
  std::transform(ranges.begin(), ranges.end(), out.begin(), [](double range) {
    // A nudge, so that a range of exactly 0.3 m is 300 and not 299.
    return static_cast<int>(std::floor(m_to_mm(range) + 1e-6));
  });
  return {};
}

}  // namespace

void eyebridge::robios::publish_globals(Session& session) {
  if (const hal::Lidar* lidar = session.backend().lidar())
    EYEBRIDGE_VARIABLE(LIDAR_RESOLUTION) = lidar->points();
}

int LIDARSet(int range, int tilt, int points) {
  return robios::guarded("LIDARSet", 1, [&](robios::Session& session) -> Result<int> {
    const std::lock_guard lock(session.own<ScanTurn>().mutex);
    return find(session).and_then([&](hal::Lidar* lidar) -> Result<int> {
      return configure(*lidar, {deg_to_rad(range), deg_to_rad(tilt), points}).map([&] {
        EYEBRIDGE_VARIABLE(LIDAR_RESOLUTION) = points;
        return 0;
      });
    });
  });
}

int LIDARGet(int distance[]) {
  return robios::guarded("LIDARGet", 1, [&](robios::Session& session) -> Result<int> {
    if (distance == nullptr) return robios::null_pointer();
    const std::lock_guard lock(session.own<ScanTurn>().mutex);
    return find(session).and_then([&](hal::Lidar* lidar) -> Result<int> {
      std::vector<int> ranges;
      return scan(*lidar, ranges).map([&] {
        std::copy(ranges.begin(), ranges.end(), distance);
        return 0;
      });
    });
  });
}

int SIMLaserScan(int scan_out[]) {
  return robios::guarded("SIMLaserScan", 1, [&](robios::Session& session) -> Result<int> {
    if (scan_out == nullptr) return robios::null_pointer();
    const std::lock_guard lock(session.own<ScanTurn>().mutex);
    return find(session).and_then([&](hal::Lidar* lidar) -> Result<int> {
      std::vector<int> ranges;
      const hal::LidarShape before = lidar->shape();
      Result<void> done = configure(*lidar, {2 * kPi, 0.0, 360});
      if (done) done = scan(*lidar, ranges);
      const Result<void> restored = configure(*lidar, before);
      if (!done) return tl::unexpected(done.error());
      if (!restored) return tl::unexpected(restored.error());
      for (int i = 0; i < 360; ++i) {
        scan_out[i] = ranges[static_cast<std::size_t>((180 - i + 360) % 360)];
      }
      return 0;
    });
  });
}
