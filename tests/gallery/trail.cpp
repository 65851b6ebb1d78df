#include "trail.hpp"

#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "eyebridge/base/math.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge::gallery {
namespace {

constexpr std::size_t kRows = 20;

struct Point {
  double t;
  double x;
  double y;
  double theta;
};

std::vector<Point> read(std::string_view csv) {
  std::vector<Point> points;
  bool header = true;
  for (const std::string& line : lines_of(csv)) {
    if (std::exchange(header, false)) continue;
    Point p{};
    const char* at = line.c_str();
    for (double* value : {&p.t, &p.x, &p.y, &p.theta}) {
      char* after = nullptr;
      *value = std::strtod(at, &after);
      if (after == at || *after != ',') throw std::runtime_error("trace.csv: " + line);
      at = after + 1;
    }
    points.push_back(p);
  }
  return points;
}

long whole(double value) { return std::lround(value); }

std::string pose_text(const Point& p) {
  return fmt::format("{:7.2f} s {:6} {:6} mm {:5} deg", p.t, whole(m_to_mm(p.x)),
                     whole(m_to_mm(p.y)), whole(rad_to_deg(p.theta)));
}

}  // namespace

Lines trail_lines(std::string_view trace_csv, bool end_only) {
  const std::vector<Point> points = read(trace_csv);
  if (points.empty()) return {"no trail: the program ended before the first step"};
  double path = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    path += std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y);
  }
  const Point& last = points.back();
  Lines lines = {fmt::format("end {} {} mm {} deg, path {} mm", whole(m_to_mm(last.x)),
                             whole(m_to_mm(last.y)), whole(rad_to_deg(last.theta)),
                             whole(m_to_mm(path)))};
  if (end_only) return lines;
  if (path == 0.0 && points.front().theta == last.theta) return lines;
  for (std::size_t i = 0; i < kRows; ++i) {
    const std::size_t at = points.size() * i / kRows;
    if (i == 0 || at != points.size() * (i - 1) / kRows) lines.push_back(pose_text(points[at]));
  }
  lines.push_back(pose_text(last));
  return lines;
}

}  // namespace eyebridge::gallery
