#include "replay/recorded_robot.hpp"

#include <map>
#include <optional>

#include "clock/lockstep_clock.hpp"
#include "eyebridge/base/config_error.hpp"

namespace eyebridge::hal {
namespace {

tl::unexpected<Error> nothing() {
  return fail(Errc::Unsupported, "replay: there is no device behind a recording");
}

class NoDrive final : public Drive {
  Result<void> set_speed(const Twist&) override { return nothing(); }
  Result<void> start(const DriveGoal&) override { return nothing(); }
  Result<DriveStatus> status() override { return nothing(); }
  Result<Twist> measured_twist() override { return nothing(); }
  Result<Pose> odometry() override { return nothing(); }
  Result<void> set_odometry(const Pose&) override { return nothing(); }
};
class NoRangeSensor final : public RangeSensor {
 public:
  explicit NoRangeSensor(double out_of_range) : out_of_range_(out_of_range) {}

 private:
  Result<double> read() override { return nothing(); }
  Result<int> read_raw() override { return nothing(); }
  [[nodiscard]] double out_of_range() const override { return out_of_range_; }
  double out_of_range_;
};
class NoSwitch final : public SwitchSensor {
  Result<bool> read() override { return nothing(); }
};
class NoCompass final : public Compass {
  Result<double> read() override { return nothing(); }
};
class NoMotor final : public Motor {
  Result<void> set_duty(double) override { return nothing(); }
  Result<void> set_speed(double) override { return nothing(); }
  Result<void> set_pid(int, int, int) override { return nothing(); }
};
class NoEncoder final : public Encoder {
  Result<int> read() override { return nothing(); }
  Result<void> reset() override { return nothing(); }
};
class NoServo final : public Servo {
  Result<void> set(double) override { return nothing(); }
};
/// Keeps the shape that the program asked for, so that it can ask for it again.
class NoLidar final : public Lidar {
 public:
  NoLidar(double max_range, const LidarShape& shape) : max_range_(max_range), shape_(shape) {}

 private:
  Result<void> configure(double field_of_view, double tilt, int points) override {
    shape_ = {field_of_view, tilt, points};
    return {};
  }
  [[nodiscard]] LidarShape shape() const override { return shape_; }
  [[nodiscard]] int points() const override { return shape_.points; }
  Result<void> read(std::span<double>) override { return nothing(); }
  [[nodiscard]] double max_range() const override { return max_range_; }
  double max_range_;
  LidarShape shape_;
};

template <class Device>
class ById {
 public:
  template <class... Facts>
  void add(int id, Facts... facts) {
    devices_.try_emplace(id, facts...);
  }
  Device* find(int id) {
    const auto found = devices_.find(id);
    return found == devices_.end() ? nullptr : &found->second;
  }

 private:
  std::map<int, Device> devices_;
};

class RecordedRobot final : public Backend {
 public:
  void add(const RecordedDevice& device) {
    const auto& [kind, id, facts] = device;
    if (kind == "drive") return drives_.add(id);
    if (kind == "proximity") return proximity_sensors_.add(id);
    if (kind == "bumper") return bumpers_.add(id);
    if (kind == "compass") return compasses_.add(id);
    if (kind == "motor") return motors_.add(id);
    if (kind == "encoder") return encoders_.add(id);
    if (kind == "servo") return servos_.add(id);
    if (kind == "psd" && facts.size() == 1) return range_sensors_.add(id, facts[0]);
    if (kind == "lidar" && facts.size() == 4 && facts[3] >= 1 && facts[3] <= 36000) {
      const LidarShape shape{facts[1], facts[2], static_cast<int>(facts[3])};
      return lidars_.add(id, facts[0], shape);
    }
    throw ConfigError({}, "unknown device '" + kind.substr(0, 40) + "' in the recording");
  }

  Clock& clock() override { return clock_; }
  [[nodiscard]] int robot_id() const override { return 1; }
  Drive* drive() override { return drives_.find(1); }
  RangeSensor* range_sensor(int id) override { return range_sensors_.find(id); }
  SwitchSensor* proximity(int id) override { return proximity_sensors_.find(id); }
  SwitchSensor* bumper(int id) override { return bumpers_.find(id); }
  Lidar* lidar() override { return lidars_.find(1); }
  Compass* compass() override { return compasses_.find(1); }
  Motor* motor(int id) override { return motors_.find(id); }
  Encoder* encoder(int id) override { return encoders_.find(id); }
  Servo* servo(int id) override { return servos_.find(id); }
  WorldControl* world() override { return nullptr; }
  camera::View* camera_view() override { return nullptr; }
  camera::Source* camera_source() override { return nullptr; }
  void trace_to(TraceSink*) override {}  // nobody knows where the robot was
  void stop() noexcept override {}

 private:
  LockstepClock clock_{std::chrono::milliseconds(10), [] {}};
  ById<NoDrive> drives_;
  ById<NoRangeSensor> range_sensors_;
  ById<NoSwitch> proximity_sensors_;
  ById<NoSwitch> bumpers_;
  ById<NoLidar> lidars_;
  ById<NoCompass> compasses_;
  ById<NoMotor> motors_;
  ById<NoEncoder> encoders_;
  ById<NoServo> servos_;
};

}  // namespace

std::unique_ptr<Backend> make_recorded_robot(const std::vector<RecordedDevice>& devices) {
  auto robot = std::make_unique<RecordedRobot>();
  for (const RecordedDevice& device : devices) robot->add(device);
  return robot;
}

}  // namespace eyebridge::hal
