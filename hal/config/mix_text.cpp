#include "config/mix_text.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "config/entries.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/hal/device_kind.hpp"
#include "eyebridge/hal/url.hpp"

namespace eyebridge::hal {
namespace {

constexpr std::string_view kCamera = "camera";

MixEntry read_entry(std::string_view text, const SourceLocation& where) {
  const std::size_t equals = text.find('=');
  const std::string_view device = trimmed(text.substr(0, equals));
  if (device != kCamera && std::ranges::find(kDeviceKinds, device) == kDeviceKinds.end()) {
    throw ConfigError(where,
                      fmt::format("found {} as a device, expected one of {}, {}", in_quotes(device),
                                  fmt::join(kDeviceKinds, ", "), kCamera));
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

std::vector<MixEntry> parse_mix(std::string_view text, const SourceLocation& where) {
  std::vector<MixEntry> entries;
  for (const Entry& part : split_entries(text, where)) {
    MixEntry entry = read_entry(part.text, part.where);
    if (std::ranges::find(entries, entry.device, &MixEntry::device) != entries.end()) {
      throw ConfigError(part.where,
                        fmt::format("found '{}' twice, expected one backend for it", entry.device));
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

}  // namespace eyebridge::hal
