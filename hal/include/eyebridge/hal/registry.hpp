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

/// What a backend is opened with; lent for the call, but for `log`, which outlives the backend.
struct BackendContext {
  const Config& config;
  LogSink& log;
};

/// One row of the table of backends.
struct BackendFactory {
  std::string_view scheme;   ///< "sim", "serial", "can"
  std::string_view summary;  ///< One line for `eyebridge doctor` and error messages.
  /// Throws ConfigError for a rest or an option that the backend does not take.
  std::unique_ptr<Backend> (*open)(const BackendUrl& url, const BackendContext& context);
};

/// All backends, in order of preference.
std::span<const BackendFactory> backend_table();

/// Opens the backend that `config` names under "hal", e.g. "sim". Throws ConfigError for an unknown
/// scheme (naming the known ones), a bad URL, or a world that cannot be loaded.
std::unique_ptr<Backend> open_backend(const BackendContext& context);

}  // namespace eyebridge::hal
