#include "rigs.hpp"

#include "eyebridge/base/units.hpp"
#include "eyebridge/files/readers.hpp"
#include "fault/fault_tap.hpp"
#include "mix/mix_backend.hpp"
#include "sim/open_sim.hpp"

namespace eyebridge::hal {
namespace {

constexpr double kWallX = 3.0;    // of the wall that the robot faces, metres
constexpr double kPatience = 60;  // seconds

/// A room of 4 m x 2 m with a wall across it, and a robot that faces that wall.
std::string world_text(double wall) {
  const auto mm = [](double metres) { return std::to_string(m_to_mm(metres)) + ' '; };
  return "floor 4000 2000\n"
         "0 0 4000 0\n4000 0 4000 2000\n4000 2000 0 2000\n0 2000 0 0\n" +
         mm(kWallX) + "0 " + mm(kWallX) + "2000\n" +  //
         "position " + mm(kWallX - wall - kFrontOffset) + mm(kSideWall) + "0\n";
}

Rig make_sim(double wall, const std::map<std::string, std::string>& flags) {
  Rig rig;
  rig.log = std::make_unique<KeepingLog>();
  const Config config = rig_config(flags);
  rig.backend = open_scenario(rig_scenario(wall), {"rig"}, {config, *rig.log});
  return rig;
}

Rig make_lockstep(double wall) { return make_sim(wall, {{"fast", "true"}}); }
Rig make_real_time(double wall) { return make_sim(wall, {{"factor", "50"}}); }

/// A decorator that has nothing to do must not show.
Rig make_faultless(double wall) {
  Rig rig = make_lockstep(wall);
  FaultScript later = parse_fault_script("all lose @1000000s; all delay 1s @1000000s", {});
  rig.backend = with_faults(std::move(rig.backend), std::move(later), 1);
  return rig;
}

/// Devices from elsewhere must not show at the others.
Rig make_mixed(double wall) {
  Rig rig = make_lockstep(wall);
  const Config config = rig_config({{"fast", "true"}});
  std::vector<MixPart> parts;
  parts.push_back({{"servo", "camera"},
                   "other",
                   open_scenario(rig_scenario(wall), {"rig"}, {config, *rig.log})});
  rig.backend = make_mix(std::move(rig.backend), std::move(parts));
  return rig;
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
  model.camera = robot::CameraModel{};
  return model;
}

files::Scenario rig_scenario(double wall) {
  files::Scenario scenario;
  scenario.world = files::read_world(world_text(wall), "rig.wld", scenario.warnings);
  world::ObjectSpec ball;
  ball.pose = {3.5, 0.5, 0};
  scenario.world.objects.push_back(ball);

  scenario.models.push_back(rig_model());
  files::RobotPlacement own;
  own.pose = scenario.world.starts.at(0).pose;
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
  DriveStatus status = backend->drive()->status().value();
  while (status.progress == DriveProgress::Driving && backend->clock().now() < end) {
    wait(0.02);
    status = backend->drive()->status().value();
  }
  return status;
}

void PrintTo(const RigCase& rig, std::ostream* out) { *out << rig.name; }

std::vector<RigCase> all_rigs() {
  return {{"SimLockstep", make_lockstep, 1e-9, 1e-3},
          {"SimRealTime", make_real_time, 1e-9, 1e-3},
          {"FaultNone", make_faultless, 1e-9, 1e-3},
          {"MixOther", make_mixed, 1e-9, 1e-3}};
}

}  // namespace eyebridge::hal
