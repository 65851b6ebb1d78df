#include "range_layout.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace eyebridge::robot {
namespace {

std::vector<Vec2> cone_of(const RangeSensorModel& model) {
  if (model.kind != RangeKind::Ultrasound) return {};
  // Odd, so that one looks along the axis; the slack keeps whole degrees from rounding up.
  const double half = model.ultrasound.beam_width / 2;
  const auto side = static_cast<int>(std::ceil(half / kConeGap - 1e-9));
  std::vector<Vec2> rays;
  for (int i = -side; i <= side; ++i) {
    rays.push_back(Heading::from_angle(side == 0 ? 0.0 : half * i / side).forward());
  }
  return rays;
}

/// Around places, metres.
struct Box {
  Vec2 low, high;

  [[nodiscard]] Box with(Vec2 p) const {
    return {{std::min(low.x, p.x), std::min(low.y, p.y)},
            {std::max(high.x, p.x), std::max(high.y, p.y)}};
  }
  [[nodiscard]] Vec2 middle() const { return 0.5 * (low + high); }
  /// No place in it is farther from the middle, however they are rounded where the robot stands.
  [[nodiscard]] double spread() const { return low == high ? 0.0 : 0.5 * norm(high - low) + 1e-9; }
};

}  // namespace

RangeLayout::RangeLayout(const std::vector<RangeSensorModel>& models) {
  Box box;
  for (const RangeSensorModel& model : models) {
    const Vec2 origin = model.pose_in_robot.position();
    const Box both = fans.empty() ? Box{origin, origin} : box.with(origin);
    if (fans.empty() || both.spread() > kMostSpread || fans.back().max_range != model.max_range ||
        fans.back().count == kMostInFan) {
      box = {origin, origin};
      fans.push_back({origin, 0.0, model.max_range, headings.size(), 0});
    } else {
      box = both;
    }
    Fan& fan = fans.back();
    ++fan.count;
    if (box.spread() > 0.0) {
      fan.origin = box.middle();
      fan.spread = box.spread();
    }
    origins.push_back(origin);
    headings.push_back(Heading::from_angle(model.pose_in_robot.theta));
    min_range.push_back(model.min_range);
    max_range.push_back(model.max_range);
    out_of_range.push_back(model.out_of_range);
    only_rays = only_rays && model.kind == RangeKind::Ray;
  }
  if (only_rays) return;
  std::transform(models.begin(), models.end(), std::back_inserter(cones), cone_of);
}

bool RangeLayout::fits(const std::vector<RangeSensorModel>& models) const {
  const RangeLayout other(models);
  return origins == other.origins && headings == other.headings && min_range == other.min_range &&
         max_range == other.max_range && out_of_range == other.out_of_range && fans == other.fans &&
         only_rays == other.only_rays && cones == other.cones;
}

}  // namespace eyebridge::robot
