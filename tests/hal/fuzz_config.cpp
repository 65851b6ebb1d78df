#include <cstdint>
#include <string_view>

#include "config/toml_text.hpp"
#include "config/values.hpp"
#include "eyebridge/hal/url.hpp"

// Any bytes either are a value or give a ConfigError: nothing else may leave.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace eyebridge;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const SourceLocation where{"fuzz"};
  try {
    hal::read_toml(text, "fuzz.toml");
  } catch (const ConfigError&) {
  }
  try {
    if (hal::parse_duration(text, where) < 0.0) __builtin_trap();
  } catch (const ConfigError&) {
  }
  try {
    if (hal::parse_backend_url(text, where).scheme.empty()) __builtin_trap();
  } catch (const ConfigError&) {
  }
  return 0;
}
