#include "sources/url_option.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge::camera {

TakenOption take_option(const std::string& url, std::string_view key, std::string_view form) {
  const std::size_t question = url.find('?');
  if (question == std::string::npos) return {url, std::nullopt};
  const std::string start = std::string(key) + '=';
  TakenOption out{url.substr(0, question), std::nullopt};
  char separator = '?';
  for (std::size_t at = question + 1; at <= url.size();) {
    const std::size_t end = std::min(url.find('&', at), url.size());
    const std::string option = url.substr(at, end - at);
    at = end + 1;
    if (!option.starts_with(start)) {
      out.url += separator + option;
      separator = '&';
      continue;
    }
    if (out.value || option.size() == start.size()) {
      throw ConfigError({"--camera"}, fmt::format("found {} '{}', expected one {}",
                                                  out.value ? "a second" : "an empty", key, form));
    }
    out.value = option.substr(start.size());
  }
  return out;
}

}  // namespace eyebridge::camera
