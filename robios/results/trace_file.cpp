#include "trace_file.hpp"

#include <iterator>

#include <fmt/format.h>

namespace eyebridge::robios {
namespace {

constexpr Time kRowPeriod = std::chrono::milliseconds(50);

void append_header(std::string& row, std::size_t ranges) {
  row += "t,x,y,theta,linear,angular,odometry_x,odometry_y,odometry_theta";
  for (std::size_t i = 1; i <= ranges; ++i) fmt::format_to(std::back_inserter(row), ",range_{}", i);
  row += '\n';
}

}  // namespace

void TraceFile::add(const hal::TracePoint& p) noexcept {
  if (file_.failed() || p.time < next_row_) return;
  row_.clear();
  if (next_row_ == Time{0}) append_header(row_, p.ranges.size());
  next_row_ = p.time + kRowPeriod;
  auto out = std::back_inserter(row_);
  fmt::format_to(out, "{:.3f},{:.6f},{:.6f},{:.6f},{:.4f},{:.4f},{:.6f},{:.6f},{:.6f}",
                 to_seconds(p.time), p.pose.x, p.pose.y, p.pose.theta, p.twist.linear,
                 p.twist.angular, p.odometry.x, p.odometry.y, p.odometry.theta);
  for (const double range : p.ranges) fmt::format_to(out, ",{:.4f}", range);
  row_ += '\n';
  file_.add(row_);
}

CollisionFile::CollisionFile(const std::filesystem::path& path) : file_(path) {
  file_.add("t,robot,with,x,y\n");
}

void CollisionFile::add(const hal::TraceContact& c) noexcept {
  row_.clear();
  fmt::format_to(std::back_inserter(row_), "{:.3f},{},{},{:.6f},{:.6f}\n", to_seconds(c.time),
                 c.robot, c.with, c.place.x, c.place.y);
  file_.add(row_);
}

}  // namespace eyebridge::robios
