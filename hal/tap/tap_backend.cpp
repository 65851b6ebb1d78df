#include <map>
#include <mutex>

#include "tap/tapped_devices.hpp"
#include "tap/tapped_io.hpp"

namespace eyebridge::hal {
namespace {

class TapBackend final : public Backend {
 public:
  TapBackend(std::unique_ptr<Backend> inner, const TapMaker& make_tap)
      : inner_(std::move(inner)), tap_(make_tap(*inner_)) {}

  Clock& clock() override { return inner_->clock(); }
  void arrive() override { inner_->arrive(); }
  [[nodiscard]] int robot_id() const override { return inner_->robot_id(); }

  Drive* drive() override { return wrap(drives_, "drive", 1, inner_->drive()); }
  RangeSensor* range_sensor(int id) override {
    return wrap(range_sensors_, "psd", id, inner_->range_sensor(id));
  }
  SwitchSensor* proximity(int id) override {
    return wrap(proximity_sensors_, "proximity", id, inner_->proximity(id));
  }
  SwitchSensor* bumper(int id) override { return wrap(bumpers_, "bumper", id, inner_->bumper(id)); }
  Lidar* lidar() override { return wrap(lidars_, "lidar", 1, inner_->lidar()); }
  Compass* compass() override { return wrap(compasses_, "compass", 1, inner_->compass()); }
  Gyroscope* gyroscope() override { return wrap(gyroscopes_, "gyroscope", 1, inner_->gyroscope()); }
  Accelerometer* accelerometer() override {
    return wrap(accelerometers_, "accelerometer", 1, inner_->accelerometer());
  }
  Motor* motor(int id) override { return wrap(motors_, "motor", id, inner_->motor(id)); }
  Encoder* encoder(int id) override { return wrap(encoders_, "encoder", id, inner_->encoder(id)); }
  Servo* servo(int id) override { return wrap(servos_, "servo", id, inner_->servo(id)); }
  DigitalLines* digital() override { return wrap(digitals_, "digital", 1, inner_->digital()); }
  AnalogInputs* analog() override { return wrap(analogs_, "analog", 1, inner_->analog()); }
  IoBoard* io_board() override { return wrap(boards_, "board", 1, inner_->io_board()); }
  Remote* remote() override { return wrap(remotes_, "remote", 1, inner_->remote()); }
  SerialPort* serial_port(int id) override {
    return wrap(serial_ports_, "serial", id, inner_->serial_port(id));
  }
  Sound* sound() override { return wrap(sounds_, "sound", 1, inner_->sound()); }
  Radio* radio() override { return wrap(radios_, "radio", 1, inner_->radio()); }

  WorldControl* world() override { return inner_->world(); }
  Environment* environment() override { return inner_->environment(); }
  std::shared_ptr<SharedWorld> shared_world() override { return inner_->shared_world(); }
  HandGuide* hand_guide() override { return inner_->hand_guide(); }
  camera::View* camera_view() override { return inner_->camera_view(); }
  camera::Source* camera_source() override { return inner_->camera_source(); }
  [[nodiscard]] RadioConditions radio_conditions() const override {
    return inner_->radio_conditions();
  }
  camera::FrameSink* frame_sink() override {
    camera::FrameSink* own = tap_->frame_sink();
    return own != nullptr ? own : inner_->frame_sink();
  }
  std::vector<DeviceFacts> facts_of(std::string_view kind) override {
    return inner_->facts_of(kind);
  }
  void trace_to(TraceSink* sink) override { inner_->trace_to(sink); }
  Result<void> stop() noexcept override {
    auto stopped = inner_->stop();
    tap_->finish();
    return stopped;
  }

 private:
  /// Devices of one kind, made when they are first asked for.
  template <class Device>
  using Slots = std::map<int, Device>;

  template <class Outer, class Inner>
  Outer* wrap(Slots<Outer>& slots, std::string_view kind, int id, Inner* device) {
    if (device == nullptr) return nullptr;
    const std::lock_guard lock(mutex_);
    return &slots.try_emplace(id, *tap_, kind, id, *device).first->second;
  }

  std::unique_ptr<Backend> inner_;
  std::unique_ptr<Tap> tap_;
  std::mutex mutex_;
  Slots<TappedDrive> drives_;
  Slots<TappedRangeSensor> range_sensors_;
  Slots<TappedSwitchSensor> proximity_sensors_;
  Slots<TappedSwitchSensor> bumpers_;
  Slots<TappedLidar> lidars_;
  Slots<TappedCompass> compasses_;
  Slots<TappedGyroscope> gyroscopes_;
  Slots<TappedAccelerometer> accelerometers_;
  Slots<TappedMotor> motors_;
  Slots<TappedEncoder> encoders_;
  Slots<TappedServo> servos_;
  Slots<TappedDigitalLines> digitals_;
  Slots<TappedAnalogInputs> analogs_;
  Slots<TappedIoBoard> boards_;
  Slots<TappedRemote> remotes_;
  Slots<TappedSerialPort> serial_ports_;
  Slots<TappedSound> sounds_;
  Slots<TappedRadio> radios_;
};

}  // namespace

std::unique_ptr<Backend> make_tapped(std::unique_ptr<Backend> inner, const TapMaker& make_tap) {
  return std::make_unique<TapBackend>(std::move(inner), make_tap);
}

}  // namespace eyebridge::hal
