#include "eyebridge/mapping/robot_mapper.hpp"

#include <stdexcept>
#include <utility>
#include <vector>

#include "eyebridge/base/units.hpp"
#include "eyebridge/mapping/beam_model.hpp"
#include "eyebridge/mapping/cone_model.hpp"
#include "eyebridge/mapping/scan_mapper.hpp"

namespace eyebridge::mapping {
namespace {

constexpr double kBearingSlack = 1e-9;  // radians

bool is_cone(const robot::RangeSensorModel& sensor) {
  return sensor.kind == robot::RangeKind::Ultrasound && sensor.ultrasound.beam_width > 0.0;
}

}  // namespace

struct RobotMapper::Impl {
  robot::RobotModel model;
  std::vector<ScanMapper> ranges;       // by sensor
  std::vector<ConeModel> cones;         // likewise: of those that hear
  std::vector<ScanMapper> lidar;        // one or none
  std::vector<Heading> lidar_bearings;  // of the field of view and number of points asked for last
  double field_of_view = 0.0;
  std::vector<Vec2> directions;
  std::vector<double> levels;

  // As robot::Simulation::read_lidar() has its rays.
  [[nodiscard]] static bool is_whole(double view) { return view >= 2 * kPi - kBearingSlack; }
  [[nodiscard]] static double gap(double view, std::size_t points) {
    if (points < 2) return 0.0;
    return view / static_cast<double>(is_whole(view) ? points : points - 1);
  }
  void set_bearings(double view, std::size_t points) {
    if (view == field_of_view && points == lidar_bearings.size()) return;
    field_of_view = view;
    lidar_bearings.clear();
    const double step = gap(view, points);
    const double first = points == 1 && !is_whole(view) ? 0.0 : view / 2;
    for (std::size_t i = 0; i < points; ++i) {
      lidar_bearings.push_back(Heading::from_angle(first - static_cast<double>(i) * step));
    }
  }
};

RobotMapper::RobotMapper(const robot::RobotModel& model) : impl_(std::make_unique<Impl>()) {
  impl_->model = model;
  for (const auto& sensor : model.range_sensors) {
    impl_->ranges.emplace_back(beam_model_of(sensor));
    // Of a cone without width the beam is all there is.
    const bool hears = is_cone(sensor);
    impl_->cones.push_back(hears ? cone_model_of(sensor) : ConeModel{});
  }
  if (model.lidar) impl_->lidar.emplace_back(beam_model_of(*model.lidar));
}
RobotMapper::~RobotMapper() = default;
RobotMapper::RobotMapper(RobotMapper&&) noexcept = default;
RobotMapper& RobotMapper::operator=(RobotMapper&&) noexcept = default;

Result<void> RobotMapper::insert_range(OccupancyGrid& grid, const Pose& robot_in_world,
                                       std::size_t sensor, double range) {
  ScanMapper& mapper = impl_->ranges.at(sensor);
  const robot::RangeSensorModel& model = impl_->model.range_sensors[sensor];
  if (model.kind == robot::RangeKind::Down) return {};  // it sees nothing that stands in the plane
  const Pose pose = transform(robot_in_world, model.pose_in_robot);
  if (is_cone(model)) {
    return insert_cone(grid, impl_->cones[sensor], pose, range);
  }
  const Vec2 direction = Heading::from_angle(pose.theta).forward();
  return mapper.insert(grid, pose.position(), {&direction, 1}, {&range, 1});
}

Result<void> RobotMapper::insert_ranges(OccupancyGrid& grid, const Pose& robot_in_world,
                                        std::span<const double> ranges) {
  if (ranges.size() != impl_->ranges.size()) {
    throw std::out_of_range("insert_ranges: one range a sensor");
  }
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (auto done = insert_range(grid, robot_in_world, i, ranges[i]); !done) return done;
  }
  return {};
}

Result<void> RobotMapper::insert_lidar(OccupancyGrid& grid, const Pose& robot_in_world,
                                       double field_of_view, std::span<const double> ranges) {
  if (impl_->lidar.empty()) throw std::out_of_range("insert_lidar: the robot has no lidar");
  const robot::LidarModel& lidar = *impl_->model.lidar;
  const Pose pose = transform(robot_in_world, lidar.pose_in_robot);
  const Heading heading = Heading::from_angle(pose.theta);
  impl_->set_bearings(field_of_view, ranges.size());
  impl_->directions.clear();
  for (const Heading bearing : impl_->lidar_bearings) {
    impl_->directions.push_back(heading.turned(bearing).forward());
  }
  std::span<const double> level = ranges;
  if (lidar.tilt != 0.0) {
    impl_->levels.clear();
    for (const double range : ranges) impl_->levels.push_back(level_range(lidar, range));
    level = impl_->levels;
  }
  const double gap = Impl::gap(field_of_view, ranges.size());
  if (!(gap > 0.0) || field_of_view > 2 * kPi + kBearingSlack) {
    return impl_->lidar[0].insert(grid, pose.position(), impl_->directions, level);
  }
  return impl_->lidar[0].insert_sweep(grid, pose.position(), impl_->directions, gap, level);
}

}  // namespace eyebridge::mapping
