#include "sim/repeats.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "eyebridge/base/math.hpp"

namespace eyebridge::hal {
namespace {

constexpr Time kPatience = std::chrono::minutes(1);
constexpr Time kPause = std::chrono::seconds(20);
constexpr std::size_t kMostHeadings = 720;
constexpr unsigned kVisits = 2;
constexpr double kSameSpot = 1e-6;     // metres
constexpr double kSameHeading = 1e-6;  // radians: far less than any error model gives

}  // namespace

void Repeats::begin(Time now) {
  since_ = now;
  for (Heading& heading : headings_) heading.visits = 0;
}

std::optional<std::size_t> Repeats::add(Time now, const Pose& pose) {
  if (has_told_) return std::nullopt;
  const auto is_here = [&](const Heading& heading) {
    return std::abs(wrap_angle(heading.theta - pose.theta)) < kSameHeading;
  };
  if (headings_.empty() || norm(pose.position() - spot_) > kSameSpot) {
    spot_ = pose.position();
    headings_ = {{pose.theta, 0}};
    present_ = 0;
    since_ = turned_ = now;
    return std::nullopt;
  }
  if (is_here(headings_[present_])) return std::nullopt;  // it has not turned
  if (now - turned_ > kPause) begin(now);
  turned_ = now;
  const auto known = std::ranges::find_if(headings_, is_here);
  present_ = static_cast<std::size_t>(known - headings_.begin());
  if (known == headings_.end()) {
    if (headings_.size() == kMostHeadings) headings_.clear();
    present_ = headings_.size();
    headings_.push_back({pose.theta, 0});
    begin(now);
    return std::nullopt;
  }
  ++known->visits;
  const bool is_over =
      now - since_ >= kPatience && std::ranges::all_of(headings_, [](const Heading& heading) {
        return heading.visits >= kVisits;
      });
  if (!is_over) return std::nullopt;
  has_told_ = true;
  return headings_.size();
}

}  // namespace eyebridge::hal
