#include "config/mix_text.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "eyebridge/base/text.hpp"
#include "eyebridge/hal/url.hpp"

namespace eyebridge::hal {
namespace {

constexpr std::array<std::string_view, 10> kDevices = {"drive", "psd",     "proximity", "bumper",
                                                       "lidar", "compass", "motor",     "encoder",
                                                       "servo", "camera"};

MixEntry read_entry(std::string_view text, const SourceLocation& where) {
  const std::size_t equals = text.find('=');
  const std::string_view device = trimmed(text.substr(0, equals));
  if (std::ranges::find(kDevices, device) == kDevices.end()) {
    throw ConfigError(where, fmt::format("found {} as a device, expected one of {}",
                                         in_quotes(device), mix_devices()));
  }
  const std::string_view url =
      equals == std::string_view::npos ? "" : trimmed(text.substr(equals + 1));
  if (url.empty()) {
    throw ConfigError(
        where, fmt::format("found no backend for '{}', expected one as in {}=sim", device, device));
  }
  parse_backend_url(url, where);
  return {std::string(device), std::string(url)};
}

}  // namespace

std::string mix_devices() { return fmt::format("{}", fmt::join(kDevices, ", ")); }

std::vector<MixEntry> parse_mix(std::string_view text, const SourceLocation& where) {
  std::vector<MixEntry> entries;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(';', begin), text.size());
    const std::string_view entry_text = text.substr(begin, end - begin);
    if (!trimmed(entry_text).empty()) {
      SourceLocation place = where;
      if (place.line == 0) {
        place.line = 1;
        place.column = static_cast<int>(begin + entry_text.find_first_not_of(" \t")) + 1;
      }
      MixEntry entry = read_entry(entry_text, place);
      if (std::ranges::find(entries, entry.device, &MixEntry::device) != entries.end()) {
        throw ConfigError(
            place, fmt::format("found '{}' twice, expected one backend for it", entry.device));
      }
      entries.push_back(std::move(entry));
    }
    begin = end + 1;
  }
  return entries;
}

}  // namespace eyebridge::hal
