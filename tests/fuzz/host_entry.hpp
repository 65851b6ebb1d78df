#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string_view>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/hal/radio.hpp"
#include "host/serial_devices.hpp"
#include "host/sound_length.hpp"
#include "radio/radio_datagram.hpp"
#include "radio/radio_setting.hpp"

// As entry.hpp, for what the computer adds to a robot: its settings, sounds, and the radio.
namespace eyebridge::fuzz {

/// What is accepted can be.
inline void radio(std::string_view text) {
  using Medium = hal::RadioSetting::Medium;
  try {
    const hal::RadioSetting setting = hal::parse_radio(text, {});
    const int id = setting.id.value_or(hal::Radio::kFirstId);
    const double loss = setting.loss.value_or(0.0);
    const double corrupt = setting.corrupt.value_or(0.0);
    const double range = setting.range.value_or(0.0);
    const bool sane = corrupt >= 0.0 && corrupt <= 1.0 && range >= 0.0 &&
                      setting.jitter.value_or(Time{0}) >= Time{0} && loss >= 0.0 && loss <= 1.0 &&
                      setting.delay.value_or(Time{0}) >= Time{0} && id >= hal::Radio::kFirstId &&
                      id <= hal::Radio::kLastId &&
                      (setting.medium != Medium::Udp || setting.port != 0);
    if (!sane) std::abort();
  } catch (const ConfigError&) {  // the input is no setting
  }
}

/// A datagram has the bytes that it was read from.
inline void radio_datagram(std::string_view text) {
  const std::span bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  const auto datagram = hal::decode_radio(bytes);
  if (!datagram) return;
  const auto again = hal::encode(*datagram);
  if (std::string_view(reinterpret_cast<const char*>(again.data()), again.size()) != text) {
    std::abort();
  }
}

/// Every number that is accepted has a device.
inline void serial_devices(std::string_view text) {
  try {
    for (const auto& [id, device] : hal::parse_serial_devices(text, {})) {
      if (id < 0 || id > 20 || device.empty()) std::abort();
    }
  } catch (const ConfigError&) {  // the input is no setting
  }
}

/// A length is a number that can be waited for.
inline void sound(std::string_view text) {
  const auto facts =
      hal::read_sound({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  if (facts && !(std::isfinite(facts->length) && facts->length >= 0.0)) std::abort();
}

}  // namespace eyebridge::fuzz
