#pragma once

#include <string>

#include <tl/expected.hpp>

namespace eyebridge {

/// What kind of thing went wrong while the robot was running.
enum class Errc {
  Timeout,       ///< No answer in time.
  Disconnected,  ///< The device is gone.
  Corrupt,       ///< An answer came, but it cannot be right.
  Unsupported,   ///< This device or backend cannot do it.
  OutOfRange,    ///< An argument lies outside what the device accepts.
  NoDevice,      ///< The program asks for a device that this robot lacks.
};

/// Why a call failed while the robot was running. Start-up errors throw ConfigError instead.
struct Error {
  Errc code{};
  std::string what;  ///< One line for the log: what was tried, on which device, what came back.
};

/// A value, or why there is none. A reading is never invented.
template <class T>
using Result = tl::expected<T, Error>;

/// The error side of a Result: `return fail(Errc::OutOfRange, "no PSD 7")`.
inline tl::unexpected<Error> fail(Errc code, std::string what) {
  return tl::unexpected<Error>(Error{code, std::move(what)});
}

}  // namespace eyebridge
