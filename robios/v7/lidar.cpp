#include <algorithm>
#include <cmath>
#include <mutex>
#include <vector>

#include "convert.hpp"
#include "eyebot.h"
#include "guarded.hpp"

int LIDAR_RESOLUTION = 360;

namespace {

using namespace eyebridge;

struct Shape {
  int range_deg = 360;
  int tilt_deg = 0;
  int points = 360;
};

// The shape that LIDARSet asked for last, and the right to scan: one thread at a time.
std::mutex scan_mutex;
Shape program_shape;

Result<hal::Lidar*> find(robios::Session& session) {
  hal::Lidar* lidar = session.backend().lidar();
  if (lidar == nullptr) return fail(Errc::Unsupported, "this robot has no lidar");
  return lidar;
}

Result<void> configure(hal::Lidar& lidar, const Shape& shape) {
  return lidar.configure(deg_to_rad(shape.range_deg), deg_to_rad(shape.tilt_deg), shape.points);
}

/// One scan of the present shape in whole millimetres, rounded down as in EyeSim.
Result<void> scan(hal::Lidar& lidar, std::vector<int>& out) {
  std::vector<double> ranges(static_cast<std::size_t>(lidar.points()));
  if (const Result<void> read = lidar.read(ranges); !read) return read;
  out.resize(ranges.size());
  std::transform(ranges.begin(), ranges.end(), out.begin(), [](double range) {
    // A nudge, so that a range of exactly 0.3 m is 300 and not 299.
    return static_cast<int>(std::floor(m_to_mm(range) + 1e-6));
  });
  return {};
}

}  // namespace

int LIDARSet(int range, int tilt, int points) {
  return robios::guarded("LIDARSet", 1, [&](robios::Session& session) -> Result<int> {
    const std::lock_guard lock(scan_mutex);
    return find(session).and_then([&](hal::Lidar* lidar) -> Result<int> {
      const Shape shape{range, tilt, points};
      return configure(*lidar, shape).map([&] {
        program_shape = shape;
        LIDAR_RESOLUTION = points;
        return 0;
      });
    });
  });
}

int LIDARGet(int distance[]) {
  return robios::guarded("LIDARGet", 1, [&](robios::Session& session) -> Result<int> {
    if (distance == nullptr) return robios::null_pointer();
    const std::lock_guard lock(scan_mutex);
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
    const std::lock_guard lock(scan_mutex);
    return find(session).and_then([&](hal::Lidar* lidar) -> Result<int> {
      std::vector<int> ranges;
      Result<void> done = configure(*lidar, Shape{});
      if (done) done = scan(*lidar, ranges);
      const Result<void> restored = configure(*lidar, program_shape);
      if (!done) return tl::unexpected(done.error());
      if (!restored) return tl::unexpected(restored.error());
      for (int i = 0; i < 360; ++i) {
        scan_out[i] = ranges[static_cast<std::size_t>((180 - i + 360) % 360)];
      }
      return 0;
    });
  });
}
