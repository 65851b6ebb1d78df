#include "host/serial_devices.hpp"

#include <algorithm>
#include <charconv>
#include <system_error>

#include "config/entries.hpp"
#include "eyebridge/base/text.hpp"

namespace eyebridge::hal {
namespace {

constexpr int kLastInterface = 20;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool contains(std::string_view text, std::string_view part) {
  return std::search(text.begin(), text.end(), part.begin(), part.end(),
                     [](char a, char b) { return lower(a) == lower(b); }) != text.end();
}

}  // namespace

SerialDevices parse_serial_devices(std::string_view text, const SourceLocation& where) {
  SerialDevices devices;
  for (const Entry& entry : split_entries(text, where)) {
    const std::size_t equals = std::min(entry.text.find('='), entry.text.size());
    const std::string_view number = trimmed(entry.text.substr(0, equals));
    const std::string_view device =
        trimmed(entry.text.substr(std::min(equals + 1, entry.text.size())));
    int id = -1;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), id);
    const bool is_number = error == std::errc{} && end == number.data() + number.size();
    if (!is_number || id < 0 || id > kLastInterface || device.empty()) {
      throw ConfigError(entry.where, "found " + in_quotes(entry.text) +
                                         ", expected an interface 0 … 20 and its device, as "
                                         "0=/dev/ttyUSB0");
    }
    if (!devices.emplace(id, device).second) {
      throw ConfigError(entry.where, "found interface " + std::to_string(id) +
                                         " twice, expected one device for it");
    }
  }
  return devices;
}

std::string find_serial_device(const std::string& device, const std::filesystem::path& folder) {
  if (device.find('/') != std::string::npos) return device;
  std::string found;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string path = entry.path().string();
    if (!contains(entry.path().filename().string(), device)) continue;
    if (found.empty() || path < found) found = path;
  }
  return found;
}

}  // namespace eyebridge::hal
