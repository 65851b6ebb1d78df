#include "run_output.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/camera/birdseye.hpp"
#include "eyebridge/camera/png.hpp"

namespace eyebridge::robios {
namespace {

constexpr Time kRowPeriod = std::chrono::milliseconds(50);
constexpr double kTrailStep = 0.005;  // metres; finer does not show on the map
// Pieces of the trail, from the first, pale, to the last, dark.
constexpr std::size_t kTrailPieces = 24;

Rgb trail_colour(std::size_t piece) {
  const auto fade = [&](int from, int to) {
    return static_cast<std::uint8_t>(from + (to - from) * static_cast<int>(piece) /
                                                static_cast<int>(kTrailPieces - 1));
  };
  return {fade(250, 200), fade(205, 20), fade(160, 20)};
}

/// The trail in pieces of equal length that meet, so that the last run shows over the first.
std::vector<camera::Trail> fading(const std::vector<Vec2>& points) {
  std::vector<camera::Trail> pieces;
  for (std::size_t i = 0; i < kTrailPieces; ++i) {
    const std::size_t begin = points.size() * i / kTrailPieces;
    const std::size_t end = std::min(points.size() * (i + 1) / kTrailPieces + 1, points.size());
    if (begin >= end) continue;
    const auto at = [&](std::size_t index) { return points.begin() + static_cast<long>(index); };
    pieces.push_back({trail_colour(i), {at(begin), at(end)}});
  }
  return pieces;
}

}  // namespace

RunOutput::RunOutput(std::filesystem::path directory, long long frames_to_keep)
    : directory_(std::move(directory)), frames_left_(frames_to_keep) {
  std::error_code error;
  std::filesystem::create_directories(directory_, error);
  const std::filesystem::path file = directory_ / "trace.csv";
  trace_.reset(std::fopen(file.c_str(), "w"));
  if (!trace_) {
    throw ConfigError({"--out"}, fmt::format("cannot write {}: {}", file.string(),
                                             std::strerror(error ? error.value() : errno)));
  }
}

RunOutput::~RunOutput() = default;

void RunOutput::point(const hal::TracePoint& p) noexcept {
  const std::lock_guard lock(mutex_);
  if (!trace_failure_.empty()) return;
  try {
    add(p);
  } catch (const std::exception& error) {
    trace_failure_ = error.what();
  }
}

void RunOutput::add(const hal::TracePoint& p) {
  const Vec2 here = p.pose.position();
  if (trail_.empty() || norm(here - trail_.back()) >= kTrailStep) trail_.push_back(here);
  if (p.time < next_row_) return;
  if (next_row_ == Time{0}) {
    fmt::print(trace_.get(), "t,x,y,theta,linear,angular,odometry_x,odometry_y,odometry_theta");
    for (std::size_t i = 0; i < p.ranges.size(); ++i) fmt::print(trace_.get(), ",range_{}", i + 1);
    fmt::print(trace_.get(), "\n");
  }
  next_row_ = p.time + kRowPeriod;
  fmt::print(trace_.get(), "{:.3f},{:.6f},{:.6f},{:.6f},{:.4f},{:.4f},{:.6f},{:.6f},{:.6f}",
             to_seconds(p.time), p.pose.x, p.pose.y, p.pose.theta, p.twist.linear, p.twist.angular,
             p.odometry.x, p.odometry.y, p.odometry.theta);
  for (const double range : p.ranges) fmt::print(trace_.get(), ",{:.4f}", range);
  fmt::print(trace_.get(), "\n");
}

void RunOutput::frame(const camera::Frame& frame) {
  const std::lock_guard lock(mutex_);
  if (frames_left_ <= 0) return;
  --frames_left_;
  std::filesystem::create_directories(directory_ / "frames");
  camera::write_png(frame, directory_ / "frames" / fmt::format("{:04}.png", frames_written_++));
}

void RunOutput::before_fork() {
  mutex_.lock();
  std::fflush(trace_.get());
}

void RunOutput::after_fork() { mutex_.unlock(); }

void RunOutput::finish(const world::Scene* scene, const camera::Frame& lcd) {
  const std::lock_guard lock(mutex_);
  if (trace_failure_.empty() && std::fflush(trace_.get()) != 0) {
    trace_failure_ = std::strerror(errno);
  }
  if (!trace_failure_.empty()) {
    throw std::runtime_error((directory_ / "trace.csv").string() + ": " + trace_failure_);
  }
  camera::write_png(lcd, directory_ / "lcd.png");
  if (scene != nullptr) {
    camera::write_png(camera::draw_birdseye(*scene, fading(trail_)), directory_ / "map.png");
  }
}

}  // namespace eyebridge::robios
