#include "trace_file.hpp"

#include <cerrno>
#include <iterator>
#include <system_error>

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

TraceFile::TraceFile(const std::filesystem::path& path) : file_(std::fopen(path.c_str(), "w")) {
  if (!file_) throw std::system_error(errno, std::generic_category(), "cannot write");
}

void TraceFile::add(const hal::TracePoint& p) noexcept {
  if (failure_ != 0 || p.time < next_row_) return;
  row_.clear();
  if (next_row_ == Time{0}) append_header(row_, p.ranges.size());
  next_row_ = p.time + kRowPeriod;
  auto out = std::back_inserter(row_);
  fmt::format_to(out, "{:.3f},{:.6f},{:.6f},{:.6f},{:.4f},{:.4f},{:.6f},{:.6f},{:.6f}",
                 to_seconds(p.time), p.pose.x, p.pose.y, p.pose.theta, p.twist.linear,
                 p.twist.angular, p.odometry.x, p.odometry.y, p.odometry.theta);
  for (const double range : p.ranges) fmt::format_to(out, ",{:.4f}", range);
  row_ += '\n';
  if (std::fwrite(row_.data(), 1, row_.size(), file_.get()) != row_.size()) note_failure();
}

void TraceFile::flush() noexcept {
  if (std::fflush(file_.get()) != 0) note_failure();
}

void TraceFile::note_failure() noexcept {
  if (failure_ == 0) failure_ = errno;
}

}  // namespace eyebridge::robios
