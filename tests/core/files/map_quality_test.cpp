#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "eyebridge/base/units.hpp"
#include "eyebridge/files/load.hpp"
#include "eyebridge/mapping/ground_truth.hpp"
#include "eyebridge/mapping/robot_mapper.hpp"
#include "eyebridge/robot/error_presets.hpp"
#include "eyebridge/robot/simulation.hpp"

// The measure of issue 8: after a fixed tour of each of three worlds with realistic errors, at
// least 97 % of the observed cells agree with the ground truth.
namespace eyebridge::files {
namespace {

using mapping::OccupancyGrid;

struct Tour {
  const char* world;
  std::vector<Vec2> way;  ///< Corners of the tour; straight in between, metres.
};

void PrintTo(const Tour& tour, std::ostream* out) { *out << tour.world; }

// The centres of maze cells are 0.36 m apart.
constexpr double at(int cell) { return 0.36 * (cell + 0.5); }

const Tour kTours[] = {{"rooms.wld",
                        {{2.0, 0.4},
                         {2.0, 0.85},
                         {0.7, 0.85},
                         {0.7, 1.5},
                         {0.7, 0.85},
                         {2.0, 0.85},
                         {3.3, 0.85},
                         {3.3, 1.5},
                         {3.3, 0.85},
                         {2.0, 0.85},
                         {2.0, 3.15},
                         {0.7, 3.15},
                         {0.7, 2.5},
                         {0.7, 3.15},
                         {3.3, 3.15},
                         {3.3, 2.5}}},
                       {"slalom.wld",
                        {{0.35, 1.0},
                         {1.0, 1.4},
                         {1.75, 0.6},
                         {2.5, 1.4},
                         {3.25, 0.6},
                         {4.0, 1.4},
                         {4.7, 1.0},
                         {4.7, 0.3},
                         {0.35, 0.3}}},
                       {"maze-5.maz",
                        {{at(0), at(0)},
                         {at(0), at(1)},
                         {at(1), at(1)},
                         {at(1), at(0)},
                         {at(3), at(0)},
                         {at(3), at(1)},
                         {at(4), at(1)},
                         {at(4), at(0)},
                         {at(4), at(1)},
                         {at(3), at(1)},
                         {at(3), at(2)}}}};

/// Poses along the tour, a step apart, each looking along it; turns in place at corners.
std::vector<Pose> poses_of(const Tour& tour, double step = 0.04, double turn = deg_to_rad(10)) {
  std::vector<Pose> poses;
  double heading = 0.0;
  for (std::size_t i = 0; i + 1 < tour.way.size(); ++i) {
    const Vec2 along = tour.way[i + 1] - tour.way[i];
    const double ahead = arc_tan2(along.y, along.x);
    const double change = wrap_angle(ahead - heading);
    const int turns = static_cast<int>(std::abs(change) / turn) + 1;
    for (int k = 1; k <= turns; ++k) {
      poses.push_back({tour.way[i].x, tour.way[i].y, wrap_angle(heading + change * k / turns)});
    }
    heading = ahead;
    const int steps = static_cast<int>(norm(along) / step) + 1;
    for (int k = 1; k <= steps; ++k) {
      const Vec2 p = tour.way[i] + (static_cast<double>(k) / steps) * along;
      poses.push_back({p.x, p.y, heading});
    }
  }
  return poses;
}

/// A small robot with a LIDAR and a ring of twelve PSDs, all with realistic errors.
robot::RobotModel mapper_robot() {
  robot::RobotModel model = named_robot("S4", {"test"});
  model.diameter = 0.1;
  model.range_sensors.clear();
  for (int i = 0; i < 12; ++i) {
    const double bearing = i * kPi / 6;
    robot::RangeSensorModel sensor;
    sensor.id = i + 1;
    sensor.pose_in_robot = {0.04 * std::cos(bearing), 0.04 * std::sin(bearing), bearing};
    sensor.max_range = 2.0;
    model.range_sensors.push_back(sensor);
  }
  model.lidar.emplace();
  model.lidar->max_range = 6.0;
  robot::set_errors(model, robot::error_preset("realistic").value());
  return model;
}

class MapQuality : public testing::TestWithParam<Tour> {
 protected:
  MapQuality()
      : world_(std::make_shared<world::WorldModel>(
            load_scenario(std::filesystem::path(EYEBRIDGE_SOURCE_DIR) / "worlds" / GetParam().world)
                .world)),
        truth_(mapping::truth_of(*world_)),
        belief_(truth_.geometry()),
        simulation_(world_, {}),
        model_(mapper_robot()),
        mapper_(model_),
        poses_(poses_of(GetParam())) {
    simulation_.add_robot(model_, poses_.front());
  }

  void expect_agreement(const char* sensor) {
    const auto close = mapping::agreement(belief_, truth_);
    const auto strict = mapping::agreement(belief_, truth_, 0);
    const double covered = mapping::coverage(belief_, truth_, GetParam().way.front());
    const std::string name = sensor;
    RecordProperty(name + "_observed", static_cast<int>(close.observed));
    RecordProperty(name + "_agreement", std::to_string(close.share()));
    RecordProperty(name + "_agreement_without_tolerance", std::to_string(strict.share()));
    RecordProperty(name + "_coverage", std::to_string(covered));
    EXPECT_GE(close.share(), 0.97) << close.observed << " observed, without tolerance "
                                   << strict.share() << ", coverage " << covered;
    EXPECT_GE(covered, 0.5) << "the tour saw little";
  }

  std::shared_ptr<const world::WorldModel> world_;
  OccupancyGrid truth_;
  OccupancyGrid belief_;
  robot::Simulation simulation_;
  robot::RobotModel model_;
  mapping::RobotMapper mapper_;
  std::vector<Pose> poses_;
};

TEST_P(MapQuality, OfALidarIsGood) {
  std::vector<double> ranges(360);
  for (const Pose& pose : poses_) {
    simulation_.set_pose(0, pose);
    simulation_.read_lidar(0, 2 * kPi, ranges);
    ASSERT_TRUE(mapper_.insert_lidar(belief_, pose, 2 * kPi, ranges));
  }
  expect_agreement("lidar");
}

TEST_P(MapQuality, OfARingOfPsdsIsGood) {
  std::vector<double> ranges(model_.range_sensors.size());
  for (const Pose& pose : poses_) {
    simulation_.set_pose(0, pose);
    simulation_.read_ranges(0, ranges);
    ASSERT_TRUE(mapper_.insert_ranges(belief_, pose, ranges));
  }
  expect_agreement("psd");
}

// Cones of 30 degrees over surfaces that are rough enough to be heard from the side.
TEST_P(MapQuality, OfARingOfSonarsIsGood) {
  robot::RobotModel model = model_;
  for (robot::RangeSensorModel& sensor : model.range_sensors) {
    sensor.kind = robot::RangeKind::Ultrasound;
    sensor.ultrasound = {.beam_width = deg_to_rad(30), .critical_angle = kPi / 2};
  }
  mapping::RobotMapper mapper(model);
  robot::Simulation simulation(world_, {});
  simulation.add_robot(model, poses_.front());
  std::vector<double> ranges(model.range_sensors.size());
  for (const Pose& pose : poses_) {
    simulation.set_pose(0, pose);
    simulation.read_ranges(0, ranges);
    ASSERT_TRUE(mapper.insert_ranges(belief_, pose, ranges));
  }
  expect_agreement("sonar");
}

INSTANTIATE_TEST_SUITE_P(Worlds, MapQuality, testing::ValuesIn(kTours), [](const auto& row) {
  std::string name = row.param.world;
  name.erase(name.find('.'));
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace eyebridge::files
