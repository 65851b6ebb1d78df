#include "process_start.hpp"

#include <fmt/format.h>

#include "eyebridge/base/exec_words.hpp"

namespace eyebridge::robios {

std::vector<std::string> environment_of(const hal::Config& config, std::size_t index,
                                        int descriptor, const std::filesystem::path& out) {
  namespace fs = std::filesystem;
  hal::Config own = config;
  const auto put = [&own](std::string_view key, const std::string& text) {
    own = own.with(key, {text, {hal::Config::flag_name(key)}});
  };
  // The program may change its working folder before its first call.
  for (const hal::Setting& setting : hal::settings()) {
    if (setting.kind != hal::Setting::Kind::Path || !config.is_set(setting.key)) continue;
    const fs::path path = fs::absolute(config.path(setting.key));
    own = own.with(setting.key, {path.string(), config.value(setting.key).where});
  }
  put("hal", fmt::format("remote:{}?robot={}", descriptor, index + 1));
  put("robots", "1");
  put("out", out.empty() ? "" : fs::absolute(out).string());
  put("report", "");  // of the world
  put("panel", "none");
  std::map<std::string, std::string> variables = python_variables();
  // Sealed: a file beside the program must not change what all robots live by.
  variables["EYEBRIDGE_PLAN"] = own.sealed_plan();
  variables["EYEBRIDGE_ROBOTS"] = "1";
  return environment_with(variables);
}

}  // namespace eyebridge::robios
