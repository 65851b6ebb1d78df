#include "tap/absent_robot.hpp"

#include <map>
#include <optional>

#include "clock/lockstep_clock.hpp"
#include "eyebridge/base/config_error.hpp"
#include "tap/absent_devices.hpp"

namespace eyebridge::hal {
namespace {

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

class AbsentRobot final : public Backend {
 public:
  void add(const ListedDevice& device) {
    const auto& [kind, id, facts] = device;
    if (kind == "drive") return drives_.add(id);
    if (kind == "proximity") return proximity_sensors_.add(id);
    if (kind == "bumper") return bumpers_.add(id);
    if (kind == "compass") return compasses_.add(id);
    if (kind == "gyroscope") return gyroscopes_.add(id);
    if (kind == "accelerometer") return accelerometers_.add(id);
    if (kind == "motor") return motors_.add(id);
    if (kind == "encoder") return encoders_.add(id);
    if (kind == "servo") return servos_.add(id);
    if (kind == "digital") return digitals_.add(id);
    if (kind == "analog") return analogs_.add(id);
    if (kind == "board") return boards_.add(id);
    if (kind == "remote") return remotes_.add(id);
    if (kind == "serial") return serial_ports_.add(id);
    if (kind == "sound") return sounds_.add(id);
    if (kind == "radio" && facts.size() == 1 && facts[0] >= Radio::kFirstId &&
        facts[0] <= Radio::kLastId) {
      return radios_.add(id, static_cast<int>(facts[0]));
    }
    if (kind == "psd" && facts.size() == 1) return range_sensors_.add(id, facts[0]);
    if (kind == "lidar" && facts.size() == 4 && facts[3] >= 1 && facts[3] <= 36000) {
      const LidarShape shape{facts[1], facts[2], static_cast<int>(facts[3])};
      return lidars_.add(id, facts[0], shape);
    }
    throw ConfigError({}, "unknown device '" + kind.substr(0, 40) + "'");
  }

  Clock& clock() override { return clock_; }
  [[nodiscard]] int robot_id() const override { return 1; }
  Drive* drive() override { return drives_.find(1); }
  RangeSensor* range_sensor(int id) override { return range_sensors_.find(id); }
  SwitchSensor* proximity(int id) override { return proximity_sensors_.find(id); }
  SwitchSensor* bumper(int id) override { return bumpers_.find(id); }
  Lidar* lidar() override { return lidars_.find(1); }
  Compass* compass() override { return compasses_.find(1); }
  Gyroscope* gyroscope() override { return gyroscopes_.find(1); }
  Accelerometer* accelerometer() override { return accelerometers_.find(1); }
  Motor* motor(int id) override { return motors_.find(id); }
  Encoder* encoder(int id) override { return encoders_.find(id); }
  Servo* servo(int id) override { return servos_.find(id); }
  DigitalLines* digital() override { return digitals_.find(1); }
  AnalogInputs* analog() override { return analogs_.find(1); }
  IoBoard* io_board() override { return boards_.find(1); }
  Remote* remote() override { return remotes_.find(1); }
  SerialPort* serial_port(int id) override { return serial_ports_.find(id); }
  Sound* sound() override { return sounds_.find(1); }
  Radio* radio() override { return radios_.find(1); }
  WorldControl* world() override { return nullptr; }
  camera::View* camera_view() override { return nullptr; }
  camera::Source* camera_source() override { return nullptr; }
  std::vector<DeviceFacts> facts_of(std::string_view) override { return {}; }  // not listed
  void trace_to(TraceSink*) override {}  // nobody knows where the robot was
  Result<void> stop() noexcept override { return {}; }

 private:
  LockstepClock clock_{std::chrono::milliseconds(10), [] {}};
  ById<NoDrive> drives_;
  ById<NoRangeSensor> range_sensors_;
  ById<NoSwitch> proximity_sensors_;
  ById<NoSwitch> bumpers_;
  ById<NoLidar> lidars_;
  ById<NoCompass> compasses_;
  ById<NoGyroscope> gyroscopes_;
  ById<NoAccelerometer> accelerometers_;
  ById<NoMotor> motors_;
  ById<NoEncoder> encoders_;
  ById<NoServo> servos_;
  ById<NoDigital> digitals_;
  ById<NoAnalog> analogs_;
  ById<NoBoard> boards_;
  ById<NoRemote> remotes_;
  ById<NoSerialPort> serial_ports_;
  ById<NoSound> sounds_;
  ById<NoRadio> radios_;
};

}  // namespace

std::unique_ptr<Backend> make_absent_robot(const std::vector<ListedDevice>& devices) {
  auto robot = std::make_unique<AbsentRobot>();
  for (const ListedDevice& device : devices) robot->add(device);
  return robot;
}

}  // namespace eyebridge::hal
