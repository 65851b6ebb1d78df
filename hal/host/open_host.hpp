#pragma once

#include <memory>

#include "eyebridge/hal/registry.hpp"
#include "radio/radio_medium.hpp"

namespace eyebridge::hal {

/// `inner` with what this computer adds: the serial ports that the setting `serial` and the lines
/// USB and SERIAL of the file under `hdt` name, sound by `player`, and the radio that `radio`
/// names. Opens and connects nothing. Throws ConfigError for a bad setting, and for a radio among
/// processes in virtual time.
/// `air` is what robots of one world share; null for a robot that is alone in its own.
std::unique_ptr<Backend> with_host_devices(std::unique_ptr<Backend> inner,
                                           const BackendContext& context,
                                           std::shared_ptr<RadioMedium> air = nullptr);

/// Throws ConfigError as with_host_devices() for what the settings alone tell.
void check_host_settings(const Config& config);

}  // namespace eyebridge::hal
