#include "host/host_backend.hpp"

#include <utility>

#include "eyebridge/hal/passing_backend.hpp"

namespace eyebridge::hal {
namespace {

class HostBackend final : public PassingBackend {
 public:
  HostBackend(std::unique_ptr<Backend> inner, HostDevices devices)
      : PassingBackend(std::move(inner)), devices_(std::move(devices)) {}

  Device* find(DeviceKind kind, int id) override {
    Device* const own = inner_->find(kind, id);
    return own != nullptr ? own : of_host(kind, id);
  }
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
  [[nodiscard]] Device* of_host(DeviceKind kind, int id) const {
    if (kind == DeviceKind::Sound) return devices_.sound.get();
    if (kind == DeviceKind::Radio) return devices_.radio.get();
    if (kind != DeviceKind::Serial) return nullptr;
    const auto port = devices_.serial_ports.find(id);
    return port == devices_.serial_ports.end() ? nullptr : port->second.get();
  }

  const HostDevices devices_;  // live on the clock of inner_, which outlives them
};

}  // namespace

std::unique_ptr<Backend> with_host(std::unique_ptr<Backend> inner, HostDevices devices) {
  return std::make_unique<HostBackend>(std::move(inner), std::move(devices));
}

}  // namespace eyebridge::hal
