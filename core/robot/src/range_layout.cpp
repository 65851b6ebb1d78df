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

}  // namespace

RangeLayout::RangeLayout(const std::vector<RangeSensorModel>& models) {
  for (const RangeSensorModel& model : models) {
    const Vec2 origin = model.pose_in_robot.position();
    if (fans.empty() || !(fans.back().origin == origin) ||
        fans.back().max_range != model.max_range || fans.back().count == kMostInFan) {
      fans.push_back({origin, model.max_range, headings.size(), 0});
    }
    ++fans.back().count;
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
  return headings == other.headings && min_range == other.min_range &&
         max_range == other.max_range && out_of_range == other.out_of_range && fans == other.fans &&
         only_rays == other.only_rays && cones == other.cones;
}

}  // namespace eyebridge::robot
