#include "eyebridge/episode/observer.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>

#include "eyebridge/base/text.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge::episode {
namespace {

constexpr std::size_t kMostRays = 36'000;
constexpr double kNoEnd = std::numeric_limits<double>::infinity();

[[noreturn]] void refuse(std::string_view word, const std::string& expected) {
  throw std::invalid_argument("found " + in_quotes(word) + " for an observation, expected " +
                              expected);
}

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> out;
  for (;;) {
    text = trimmed(text);
    if (text.empty()) return out;
    const std::size_t end = std::min(text.find_first_of(" \t\n"), text.size());
    out.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
}

/// N of "lidar:N"; `fallback` of "lidar" alone; nothing of any other word.
std::optional<std::size_t> rays_of(std::string_view word, int fallback) {
  if (word == "lidar") return static_cast<std::size_t>(fallback);
  if (!word.starts_with("lidar:")) return std::nullopt;
  const std::string_view number = word.substr(6);
  std::size_t rays = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), rays);
  if (error != std::errc{} || end != number.data() + number.size() || rays < 1 ||
      rays > kMostRays) {
    refuse(word, "lidar:1 ... lidar:36000");
  }
  return rays;
}

}  // namespace

Observer::Observer(std::string_view words, const robot::RobotModel& model) {
  const std::vector<std::string_view> all = words_of(words);
  if (all.empty()) throw std::invalid_argument("found no observation, expected psd, lidar, ...");
  psds_.resize(model.range_sensors.size());
  std::iota(psds_.begin(), psds_.end(), std::size_t{0});
  std::ranges::sort(psds_, {}, [&](std::size_t i) { return model.range_sensors[i].id; });
  if (model.lidar) field_of_view_ = model.lidar->field_of_view;
  for (const std::string_view word : all) add(word, model);
}

void Observer::add_part(Kind kind, std::size_t count, double low, double high) {
  parts_.push_back({kind, count});
  low_.insert(low_.end(), count, low);
  high_.insert(high_.end(), count, high);
}

void Observer::add(std::string_view word, const robot::RobotModel& model) {
  const std::size_t before = parts_.size();
  if (word == "psd") {
    if (psds_.empty()) refuse(word, "a robot with distance sensors");
    parts_.push_back({Kind::Psd, psds_.size()});
    for (const std::size_t i : psds_) {
      const robot::RangeSensorModel& sensor = model.range_sensors[i];
      low_.push_back(0.0);
      high_.push_back(std::max(sensor.max_range, sensor.out_of_range));
    }
  } else if (const auto rays = rays_of(word, model.lidar ? model.lidar->points : 1)) {
    if (!model.lidar) refuse(word, "a robot with a lidar");
    add_part(Kind::Lidar, *rays, 0.0, model.lidar->max_range);
  } else if (word == "bumper") {
    if (model.bumpers.empty()) refuse(word, "a robot with bumpers");
    add_part(Kind::Bumper, model.bumpers.size(), 0.0, 1.0);
  } else if (word == "compass") {
    add_part(Kind::Compass, 1, -kPi, kPi);
  } else if (word == "gyroscope") {
    add_part(Kind::Gyroscope, 1, -kNoEnd, kNoEnd);
  } else if (word == "accelerometer") {
    add_part(Kind::Accelerometer, 2, -kNoEnd, kNoEnd);
  } else if (word == "speed") {
    add_part(Kind::Speed, 2, -kNoEnd, kNoEnd);
  } else if (word == "odometry" || word == "pose") {
    add_part(word == "pose" ? Kind::Pose : Kind::Odometry, 3, -kNoEnd, kNoEnd);
  } else {
    refuse(word,
           "psd, lidar, lidar:N, bumper, compass, gyroscope, accelerometer, speed, odometry or "
           "pose");
  }
  const Kind kind = parts_.back().kind;
  const auto old_end = parts_.begin() + static_cast<std::ptrdiff_t>(before);
  if (std::any_of(parts_.begin(), old_end, [&](const Part& part) { return part.kind == kind; })) {
    refuse(word, "each observation once");
  }
}

void Observer::read_psds(robot::Simulation& simulation, robot::RobotIndex robot,
                         std::span<double> row) const {
  simulation.read_ranges(robot, row);
  if (std::ranges::is_sorted(psds_)) return;
  const std::vector<double> as_in_model(row.begin(), row.end());
  for (std::size_t i = 0; i < row.size(); ++i) row[i] = as_in_model[psds_[i]];
}

void Observer::read(robot::Simulation& simulation, robot::RobotIndex robot,
                    std::span<double> row) const {
  const auto write = [&](const Pose& pose) {
    row[0] = pose.x;
    row[1] = pose.y;
    row[2] = pose.theta;
  };
  for (const Part& part : parts_) {
    switch (part.kind) {
      case Kind::Psd:
        read_psds(simulation, robot, row.first(part.count));
        break;
      case Kind::Lidar:
        simulation.read_lidar(robot, field_of_view_, row.first(part.count));
        break;
      case Kind::Bumper:
        for (std::size_t i = 0; i < part.count; ++i) {
          row[i] = simulation.read_bumper(robot, i) ? 1.0 : 0.0;
        }
        break;
      case Kind::Compass:
        row[0] = simulation.read_compass(robot);
        break;
      case Kind::Gyroscope:
        row[0] = simulation.read_gyroscope(robot);
        break;
      case Kind::Accelerometer: {
        const Vec2 felt = simulation.read_accelerometer(robot);
        row[0] = felt.x;
        row[1] = felt.y;
        break;
      }
      case Kind::Speed: {
        const Twist twist = simulation.measured_twist(robot);
        row[0] = twist.linear;
        row[1] = twist.angular;
        break;
      }
      case Kind::Odometry:
        write(simulation.odometry(robot));
        break;
      case Kind::Pose:
        write(simulation.pose(robot));
        break;
    }
    row = row.subspan(part.count);
  }
}

}  // namespace eyebridge::episode
