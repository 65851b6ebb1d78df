#include "calls/device_list.hpp"

#include "calls/device_calls.hpp"
#include "calls/values.hpp"

namespace eyebridge::hal {

std::vector<ListedDevice> devices_of(Backend& backend) {
  std::vector<ListedDevice> devices;
  for_each_kind([&]<DeviceKind kind>() {
    for (int id = kKind<kind>.first_id; id <= kKind<kind>.last_id; ++id) {
      const auto* const device = backend.device<kind>(id);
      if (device == nullptr) continue;
      const auto facts =
          std::apply([&](const auto... fact) { return packed((device->*fact)()...); },
                     Calls<InterfaceOf<kind>>::kFacts);
      devices.push_back({std::string(name_of(kind)), id, facts});
    }
  });
  return devices;
}

}  // namespace eyebridge::hal
