#pragma once

#include <string>
#include <string_view>

#include "eyebridge/base/result.hpp"

namespace eyebridge::bridges::can {

/// `text` with `part` between the lines `begin` and `end`, which stay.
inline Result<std::string> with_marked_part(std::string_view text, std::string_view begin,
                                            std::string_view end, std::string_view part) {
  const std::size_t from = text.find(begin);
  const std::size_t to = from == std::string_view::npos ? from : text.find(end, from);
  if (to == std::string_view::npos) {
    return fail(Errc::Corrupt, "expected the line '" + std::string(begin) + "' and below it '" +
                                   std::string(end) + "'");
  }
  std::string out(text.substr(0, from + begin.size()));
  out += '\n';
  out += part;
  out += text.substr(to);
  return out;
}

}  // namespace eyebridge::bridges::can
