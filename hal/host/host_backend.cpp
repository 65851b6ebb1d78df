#include "host/host_backend.hpp"

#include <utility>

#include "eyebridge/hal/passing_backend.hpp"

namespace eyebridge::hal {
namespace {

template <class Device>
Device* either(Device* own, const std::unique_ptr<Device>& of_host) {
  return own != nullptr ? own : of_host.get();
}

class HostBackend final : public PassingBackend {
 public:
  HostBackend(std::unique_ptr<Backend> inner, HostDevices devices)
      : PassingBackend(std::move(inner)), devices_(std::move(devices)) {}

  SerialPort* serial_port(int id) override {
    const auto port = devices_.serial_ports.find(id);
    SerialPort* const own = inner_->serial_port(id);
    return own != nullptr || port == devices_.serial_ports.end() ? own : port->second.get();
  }
  Sound* sound() override { return either(inner_->sound(), devices_.sound); }
  Radio* radio() override { return either(inner_->radio(), devices_.radio); }
  Result<void> stop() noexcept override {
    auto stopped = inner_->stop();
    try {
      // So that the others know at once that it is gone.
      if (devices_.radio) (void)devices_.radio->stop();
    } catch (const std::exception&) {
      // No memory for an error's text: they will miss it.
    }
    return stopped;
  }

 private:
  const HostDevices devices_;  // live on the clock of inner_, which outlives them
};

}  // namespace

std::unique_ptr<Backend> with_host(std::unique_ptr<Backend> inner, HostDevices devices) {
  return std::make_unique<HostBackend>(std::move(inner), std::move(devices));
}

}  // namespace eyebridge::hal
