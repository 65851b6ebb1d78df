#include "trace_file.hpp"

#include <array>
#include <charconv>
#include <iterator>

#include <fmt/format.h>

namespace eyebridge::robios {
namespace {

constexpr Time kRowPeriod = std::chrono::milliseconds(50);

/// As fmt's "{:.4f}", in half the time: in hours of virtual time these numbers are half of what a
/// run costs.
void append(std::string& row, double number, int digits) {
  std::array<char, 400> text;  // the longest double has 309 digits before its point
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number,
                                 std::chars_format::fixed, digits);
  row.append(text.data(), end.ptr);
}

void append_header(std::string& row, std::size_t ranges) {
  row += kTraceHeader;
  row += "odometry_x,odometry_y,odometry_theta";
  for (std::size_t i = 1; i <= ranges; ++i) fmt::format_to(std::back_inserter(row), ",range_{}", i);
  row += '\n';
}

}  // namespace

void TraceFile::add(const hal::TracePoint& p) noexcept {
  if (!is_due(p.time)) return;
  row_.clear();
  if (next_row_ == Time{0}) append_header(row_, p.ranges.size());
  next_row_ = p.time + kRowPeriod;
  append(row_, to_seconds(p.time), 3);
  const auto add = [&](double number, int digits) {
    row_ += ',';
    append(row_, number, digits);
  };
  for (const double number : {p.pose.x, p.pose.y, p.pose.theta}) add(number, 6);
  for (const double number : {p.twist.linear, p.twist.angular}) add(number, 4);
  for (const double number : {p.odometry.x, p.odometry.y, p.odometry.theta}) add(number, 6);
  for (const double range : p.ranges) add(range, 4);
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
