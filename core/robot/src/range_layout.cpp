#include "range_layout.hpp"

namespace eyebridge::robot {

RangeLayout::RangeLayout(const std::vector<RangeSensorModel>& models) {
  for (const RangeSensorModel& model : models) {
    const Vec2 origin = model.pose_in_robot.position();
    if (fans.empty() || !(fans.back().origin == origin) ||
        fans.back().max_range != model.max_range || fans.back().count == kMostInFan) {
      fans.push_back({origin, model.max_range, beams.size(), 0});
    }
    ++fans.back().count;
    beams.push_back({Heading::from_angle(model.pose_in_robot.theta), model.min_range,
                     model.max_range, model.out_of_range});
  }
}

bool RangeLayout::fits(const std::vector<RangeSensorModel>& models) const {
  const RangeLayout other(models);
  return beams == other.beams && fans == other.fans;
}

}  // namespace eyebridge::robot
