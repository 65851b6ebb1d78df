#pragma once

#include "eyebridge/camera/view.hpp"
#include "sim/sim_device.hpp"

namespace eyebridge::hal {

/// What the camera of a simulated robot looks at.
class SimCameraView final : public camera::View, private SimDevice {
 public:
  using SimDevice::SimDevice;

  [[nodiscard]] world::Scene scene() const override;
  [[nodiscard]] camera::Eye eye() const override;
  [[nodiscard]] std::uint32_t carrier() const override;
  [[nodiscard]] camera::ImageNoise noise() const override;
  [[nodiscard]] std::string texture_directory() const override;
};

}  // namespace eyebridge::hal
