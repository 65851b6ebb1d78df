#include "host/host_backend.hpp"

#include <utility>

namespace eyebridge::hal {
namespace {

template <class Device>
Device* either(Device* own, const std::unique_ptr<Device>& of_host) {
  return own != nullptr ? own : of_host.get();
}

class HostBackend final : public Backend {
 public:
  HostBackend(std::unique_ptr<Backend> inner, HostDevices devices)
      : inner_(std::move(inner)), devices_(std::move(devices)) {}

  Clock& clock() override { return inner_->clock(); }
  [[nodiscard]] int robot_id() const override { return inner_->robot_id(); }
  Drive* drive() override { return inner_->drive(); }
  RangeSensor* range_sensor(int id) override { return inner_->range_sensor(id); }
  SwitchSensor* proximity(int id) override { return inner_->proximity(id); }
  SwitchSensor* bumper(int id) override { return inner_->bumper(id); }
  Lidar* lidar() override { return inner_->lidar(); }
  Compass* compass() override { return inner_->compass(); }
  Motor* motor(int id) override { return inner_->motor(id); }
  Encoder* encoder(int id) override { return inner_->encoder(id); }
  Servo* servo(int id) override { return inner_->servo(id); }
  DigitalLines* digital() override { return inner_->digital(); }
  AnalogInputs* analog() override { return inner_->analog(); }
  IoBoard* io_board() override { return inner_->io_board(); }
  Remote* remote() override { return inner_->remote(); }
  SerialPort* serial_port(int id) override {
    const auto port = devices_.serial_ports.find(id);
    SerialPort* const own = inner_->serial_port(id);
    return own != nullptr || port == devices_.serial_ports.end() ? own : port->second.get();
  }
  Sound* sound() override { return either(inner_->sound(), devices_.sound); }
  Radio* radio() override { return either(inner_->radio(), devices_.radio); }
  WorldControl* world() override { return inner_->world(); }
  camera::View* camera_view() override { return inner_->camera_view(); }
  camera::Source* camera_source() override { return inner_->camera_source(); }
  camera::FrameSink* frame_sink() override { return inner_->frame_sink(); }
  std::vector<DeviceFacts> facts_of(std::string_view kind) override {
    return inner_->facts_of(kind);
  }
  void trace_to(TraceSink* sink) override { inner_->trace_to(sink); }
  void stop() noexcept override {
    inner_->stop();
    try {
      // So that the others know at once that it is gone.
      if (devices_.radio) (void)devices_.radio->stop();
    } catch (const std::exception&) {
      // No memory for an error's text: they will miss it.
    }
  }

 private:
  const std::unique_ptr<Backend> inner_;  ///< Outlives the devices, which live on its clock.
  const HostDevices devices_;
};

}  // namespace

std::unique_ptr<Backend> with_host(std::unique_ptr<Backend> inner, HostDevices devices) {
  return std::make_unique<HostBackend>(std::move(inner), std::move(devices));
}

}  // namespace eyebridge::hal
