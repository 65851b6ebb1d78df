#include "rigs.hpp"

#include "eyebridge/base/math.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/camera/view.hpp"
#include "eyebridge/files/readers.hpp"
#include "shared/open_only.hpp"

namespace eyebridge::hal {
namespace {

constexpr double kWallX = 3.0;    // of the wall that the robot faces, metres
constexpr double kPatience = 60;  // seconds

/// A room of 4 m x 2 m with a wall across it. Its walls are lines.
std::string world_text() {
  const std::string wall = std::to_string(m_to_mm(kWallX));
  return "floor 4000 2000\n"
         "0 0 4000 0 0 200\n4000 0 4000 2000 0 200\n"
         "4000 2000 0 2000 0 200\n0 2000 0 0 0 200\n" +
         wall + " 0 " + wall + " 2000 0 200\n";
}

}  // namespace

void KeepingLog::write(Severity severity, std::string_view message) {
  const std::lock_guard lock(mutex_);
  messages_.emplace_back(severity, message);
}

std::vector<std::string> KeepingLog::messages(Severity severity) const {
  const std::lock_guard lock(mutex_);
  std::vector<std::string> out;
  for (const auto& [at, message] : messages_) {
    if (at == severity) out.push_back(message);
  }
  return out;
}

robot::RobotModel rig_model() {
  robot::RobotModel model;
  model.name = "Rig";
  const auto add = [&](int id, const char* name, const Pose& pose, double reach) {
    robot::RangeSensorModel sensor;
    sensor.id = id;
    sensor.name = name;
    sensor.pose_in_robot = pose;
    sensor.max_range = reach;
    model.range_sensors.push_back(sensor);
  };
  // Not in order of id, on purpose.
  add(4, "PSD_SHORT", {kFrontOffset, 0, 0}, kShortReach);
  add(3, "PSD_RIGHT", {0, 0, -kPi / 2}, 9.999);
  add(1, "PSD_FRONT", {kFrontOffset, 0, 0}, 9.999);
  add(2, "PSD_LEFT", {0, 0, kPi / 2}, 9.999);

  robot::ProximityModel proximity;
  proximity.pose_in_robot = {kFrontOffset, 0, 0};
  proximity.threshold = kThreshold;
  model.proximity_sensors.push_back(proximity);
  robot::BumperModel bumper;
  bumper.start = -kPi / 6;
  bumper.end = kPi / 6;
  model.bumpers.push_back(bumper);
  model.lidar = robot::LidarModel{};
  model.lidar->points = 8;
  robot::RangeMatrixModel& matrix = model.range_matrices.emplace_back();
  matrix.id = 3;
  matrix.name = "TOF_FRONT";
  matrix.pose_in_robot = {kFrontOffset, 0, 0};
  model.camera = robot::CameraModel{};
  return model;
}

Pose facing(double wall) { return {kWallX - wall - kFrontOffset, kSideWall, 0}; }

files::Scenario rig_scenario(const Pose& start) {
  files::Scenario scenario;
  scenario.world = files::read_world(world_text(), "rig.wld", scenario.warnings);
  world::ObjectSpec ball;
  ball.pose = {3.5, 0.5, 0};
  scenario.world.objects.push_back(ball);

  scenario.models.push_back(rig_model());
  files::RobotPlacement own;
  own.pose = start;
  files::RobotPlacement other;
  other.pose = {3.5, 1.5, kPi};
  scenario.robots = {own, other};
  return scenario;
}

Config rig_config(const std::map<std::string, std::string>& flags) {
  return Config::load({flags, {}, {}});
}

void Rig::wait(double seconds) const {
  Clock& clock = backend->clock();
  clock.wait_until(clock.now() + from_seconds(seconds));
}

DriveStatus Rig::wait_for_drive() const {
  const Time end = backend->clock().now() + from_seconds(kPatience);
  while (true) {
    auto status = backend->drive()->status();
    // A line on a busy computer may be late: the next call tells.
    const bool late = !status && status.error().code == Errc::Timeout;
    const bool driving = status && status->progress == DriveProgress::Driving;
    if ((!late && !driving) || backend->clock().now() >= end) return must(std::move(status));
    wait(0.02);
  }
}

std::function<Truth()> truth_of(Backend& robot) {
  return [&robot] {
    const camera::Eye eye = robot.camera_view()->eye();
    const Pose pose = must(robot.world()->robot_pose(0));
    return Truth{pose, wrap_angle(eye.heading - pose.theta), eye.pitch};
  };
}

Rig sim_rig(const Pose& start, const std::map<std::string, std::string>& flags) {
  Rig rig;
  rig.log = std::make_unique<KeepingLog>();
  const Config config = rig_config(flags);
  rig.backend = open_scenario(rig_scenario(start), {"rig"}, {config, *rig.log});
  rig.truth = truth_of(*rig.backend);
  return rig;
}

Rig lockstep_rig(const Pose& start) { return sim_rig(start, {{"fast", "true"}}); }

void PrintTo(const RigCase& rig, std::ostream* out) { *out << rig.name; }

}  // namespace eyebridge::hal
