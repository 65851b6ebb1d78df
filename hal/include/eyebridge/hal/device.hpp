#pragma once

namespace eyebridge::hal {

/// What all devices of a robot have in common: which backend they belong to, and for how long.
///
/// The backend owns them; a pointer stays valid for as long as the backend does.
class Device {
 public:
  virtual ~Device() = default;
};

}  // namespace eyebridge::hal
