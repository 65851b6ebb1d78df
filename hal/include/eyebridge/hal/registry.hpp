#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "eyebridge/base/log.hpp"
#include "eyebridge/hal/backend.hpp"
#include "eyebridge/hal/config.hpp"
#include "eyebridge/hal/url.hpp"

namespace eyebridge::hal {

class JoiningTurns;
struct WorldSlot;

/// What a backend is opened with; lent for the call, but for `log`, which outlives the backend.
struct BackendContext {
  const Config& config;
  LogSink& log;
  const WorldSlot* slot = nullptr;  ///< In a world that is open already; null: in one of its own.
  /// For robots that join a simulated world later, in virtual time. It outlives the backend. Null
  /// where none can join.
  JoiningTurns* joining = nullptr;
};

/// One row of the table of backends.
struct BackendFactory {
  std::string_view scheme;   ///< "sim", "serial", "can"
  std::string_view summary;  ///< One line for `eyebridge doctor` and error messages.
  /// Throws ConfigError for a rest or an option that the backend does not take.
  std::unique_ptr<Backend> (*open)(const BackendUrl& url, const BackendContext& context);
  /// Opening it does something to the world outside (a board starts): not to be done for a check.
  bool has_effects = false;
  /// It answers for the computer, too: serial ports, sound, radio.
  bool answers_for_host = false;
};

/// All backends, in order of preference.
std::span<const BackendFactory> backend_table();

/// The row of the backend that `config` names under "hal". Throws ConfigError for a bad URL, or an
/// unknown scheme (naming the known ones), and for a bad text under "faults", "mix" or
/// "drive".
const BackendFactory& find_backend(const Config& config);

/// Whether opening what `config` names has effects outside: that of "hal", or one under "mix".
/// Throws as find_backend().
bool opening_has_effects(const Config& config);

/// Opens the backend that `config` names under "hal", e.g. "sim"; with the devices of other
/// backends that it names under "mix"; driven by a person under "drive", who carries the camera
/// that it names under "camera", which is opened then; behind the faults that it names under
/// "faults"; recorded to the file under "record". Throws ConfigError as find_backend(), and for a
/// world that cannot be loaded, a board that is not there, and devices that a backend lacks.
std::unique_ptr<Backend> open_backend(const BackendContext& context);

}  // namespace eyebridge::hal
