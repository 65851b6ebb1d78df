#pragma once

#include <filesystem>
#include <string>

namespace eyebridge::apps {

/// Who may use a device.
struct DeviceAccess {
  std::string group;       ///< Of the device: "dialout", "video"; "" when it is not there.
  bool group_may = false;  ///< The group may read and write.
  bool permitted = false;  ///< This process may read and write.
  bool in_group = false;   ///< /etc/group names this user; it counts from the next login on.
};

/// Of `device`, a path below `root`.
DeviceAccess access_of(const std::string& device, const std::filesystem::path& root = "/");

/// What to do to be allowed to use it: one sentence; `only_root` is said where no group may.
std::string how_to_be_permitted(const DeviceAccess& access, const std::string& only_root);

}  // namespace eyebridge::apps
