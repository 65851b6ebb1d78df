#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge::hal {

/// Devices of SERInit()'s interfaces, by number: paths, or names to look for.
using SerialDevices = std::map<int, std::string>;

/// Reads "0=/dev/ttyS0; 1=GPS": the setting `serial`. Numbers are 0 … 20. Throws ConfigError at
/// `where`, with the column of the entry where that has no line.
SerialDevices parse_serial_devices(std::string_view text, const SourceLocation& where);

/// The path of `device`, which is one, or a part of the name of a link in `folder`, where udev puts
/// one for each serial device that is plugged in (the first one in order); "" when there is none.
std::string find_serial_device(const std::string& device, const std::filesystem::path& folder);

/// That folder.
inline constexpr const char* kSerialById = "/dev/serial/by-id";

}  // namespace eyebridge::hal
