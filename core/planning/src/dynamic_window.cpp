#include "eyebridge/planning/dynamic_window.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "eyebridge/base/units.hpp"

namespace eyebridge::planning {
namespace {

void check(const DynamicWindowSettings& settings) {
  const auto positive = [](double value, const char* complaint) {
    if (!(value > 0.0 && std::isfinite(value))) throw std::invalid_argument(complaint);
  };
  positive(settings.max_linear, "dynamic window: max_linear must be > 0");
  positive(settings.max_angular, "dynamic window: max_angular must be > 0");
  positive(settings.linear_acceleration, "dynamic window: linear_acceleration must be > 0");
  positive(settings.angular_acceleration, "dynamic window: angular_acceleration must be > 0");
  positive(settings.period, "dynamic window: period must be > 0");
  positive(settings.tolerance, "dynamic window: tolerance must be > 0");
  positive(settings.look_ahead, "dynamic window: look_ahead must be > 0");
  const bool weighed = settings.heading_weight >= 0.0 && settings.clearance_weight >= 0.0 &&
                       settings.speed_weight >= 0.0;
  if (!weighed) throw std::invalid_argument("dynamic window: weights must be >= 0");
  if (!(settings.radius >= 0.0)) throw std::invalid_argument("dynamic window: radius must be >= 0");
  if (settings.linear_samples < 2 || settings.angular_samples < 2) {
    throw std::invalid_argument("dynamic window: at least 2 samples of each speed");
  }
}

// Less room than this share of a cell is none: along a wall steps would become ever shorter.
constexpr double kShortestCells = 0.02;

/// Where the arc of `distance` metres and `angle` radians from `pose` ends.
Pose after_arc(const Pose& pose, double distance, double angle) {
  const double half = 0.5 * angle;
  const double chord =
      std::abs(half) < 1e-4 ? 1.0 - half * half / 6.0 : sin_cos(half).sin / half;  // to 1e-17
  const Vec2 moved = distance * chord * Heading::from_angle(pose.theta + half).forward();
  return {pose.x + moved.x, pose.y + moved.y, pose.theta + angle};
}

/// How far along the arc of `twist` a disc of `radius` may go, at most `limit`, metres: steps as
/// long as there is room all around, which can pass nothing.
double free_along(const ClearanceRaster& clearance, const Pose& pose, const Twist& twist,
                  double radius, double limit) {
  const double shortest = kShortestCells * clearance.geometry.resolution;
  double done = 0.0;
  while (done < limit) {
    const Pose at = after_arc(pose, done, done * twist.angular / twist.linear);
    const double room = clearance_at(clearance, at.position()) - radius;
    if (room < shortest) return done;
    done += room;
  }
  return limit;
}

/// One of `count` values from `low` to `high`; the nearest to 0 is 0 where that lies between.
double sample(double low, double high, int i, int count) {
  const double value = low + (high - low) * i / (count - 1);
  const double spacing = (high - low) / (count - 1);
  const bool spans_zero = low <= 0.0 && high >= 0.0;
  return spans_zero && std::abs(value) < 0.5 * spacing ? 0.0 : value;
}

}  // namespace

DynamicWindow::DynamicWindow(const DynamicWindowSettings& settings) : settings_(settings) {
  check(settings);
}

// Both speeds fall evenly, in the time that the slower of them takes, so that the arc is kept.
double DynamicWindow::stopping_time(const Twist& twist) const {
  return std::max(twist.linear / settings_.linear_acceleration,
                  std::abs(twist.angular) / settings_.angular_acceleration);
}

double DynamicWindow::stopping_distance(const Twist& twist) const {
  return twist.linear * (settings_.period + 0.5 * stopping_time(twist));
}

Twist DynamicWindow::braked(const Twist& now) const {
  const double time = stopping_time(now);
  if (time <= settings_.period) return {};
  const double share = 1.0 - settings_.period / time;
  return {share * now.linear, share * now.angular};
}

double DynamicWindow::score(const Pose& pose, const Twist& twist, double free, Vec2 goal) const {
  const double time = settings_.period + 0.5 * stopping_time(twist);
  const Pose end = after_arc(pose, twist.linear * time, twist.angular * time);
  const Vec2 local = Heading::from_angle(-end.theta).rotate(goal - end.position());
  const double off = std::abs(arc_tan2(local.y, local.x));
  const double away = norm(local);
  const double ahead = away > 0.0 ? std::max(0.0, local.x / away) : 1.0;
  return settings_.heading_weight * (1.0 - off / kPi) +
         settings_.clearance_weight * free / settings_.look_ahead +
         settings_.speed_weight * ahead * twist.linear / settings_.max_linear;
}

DynamicChoice DynamicWindow::choose(const ClearanceRaster& clearance, const Pose& pose,
                                    const Twist& now, Vec2 goal) const {
  const double left = norm(goal - pose.position());
  if (left <= settings_.tolerance) return {braked(now), true};
  const double more = settings_.linear_acceleration * settings_.period;
  const double turn = settings_.angular_acceleration * settings_.period;
  const double slowest = std::max(0.0, now.linear - more);
  const double fastest = std::min(settings_.max_linear, now.linear + more);
  const double rightmost = std::max(-settings_.max_angular, now.angular - turn);
  const double leftmost = std::min(settings_.max_angular, now.angular + turn);
  DynamicChoice best{braked(now), true};
  double highest = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < settings_.linear_samples; ++i) {
    for (int k = 0; k < settings_.angular_samples; ++k) {
      const Twist twist{sample(slowest, fastest, i, settings_.linear_samples),
                        sample(rightmost, leftmost, k, settings_.angular_samples)};
      const double needed = stopping_distance(twist);
      if (needed > left && twist.linear > slowest) continue;  // would pass the goal
      // A turn on the spot is always free; what it is worth lies straight ahead after it. Else to
      // stand still would look better than any way between obstacles.
      const bool drives = twist.linear > 0.0;
      const Pose from = drives ? pose : after_arc(pose, 0.0, twist.angular * settings_.period);
      const double limit = std::max(needed, settings_.look_ahead);
      const double free =
          free_along(clearance, from, drives ? twist : Twist{1.0, 0.0}, settings_.radius, limit);
      if (drives && free < needed) continue;
      const double value = score(pose, twist, std::min(free, settings_.look_ahead), goal);
      if (value <= highest) continue;
      highest = value;
      best = {twist, false};
    }
  }
  return best;
}

}  // namespace eyebridge::planning
