#include "eyebridge/base/url.hpp"

#include <algorithm>

#include "eyebridge/base/text.hpp"

namespace eyebridge {
namespace {

bool is_scheme_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); }

void put_option(Url& url, std::string_view option, const SourceLocation& where) {
  const std::size_t equals = option.find('=');
  if (equals == std::string_view::npos || equals == 0) {
    throw ConfigError(where, "found the option " + in_quotes(option) + ", expected key=value");
  }
  const std::string_view key = option.substr(0, equals);
  if (!url.options.emplace(key, option.substr(equals + 1)).second) {
    throw ConfigError(where, "found the option " + in_quotes(key) + " twice");
  }
}

}  // namespace

Url parse_url(std::string_view text, const SourceLocation& where) {
  const std::size_t question = std::min(text.find('?'), text.size());
  const std::string_view name = text.substr(0, question);
  const std::size_t colon = std::min(name.find(':'), name.size());

  Url url;
  url.scheme = name.substr(0, colon);
  if (url.scheme.empty() || !std::ranges::all_of(url.scheme, is_scheme_letter)) {
    throw ConfigError(where,
                      "found " + in_quotes(text) + ", expected a URL such as sim or serial:DEVICE");
  }
  if (colon < name.size()) url.rest = name.substr(colon + 1);
  if (question == text.size()) return url;

  std::string_view options = text.substr(question + 1);
  while (true) {
    const std::size_t end = std::min(options.find('&'), options.size());
    put_option(url, options.substr(0, end), where);
    if (end == options.size()) return url;
    options.remove_prefix(end + 1);
  }
}

}  // namespace eyebridge
