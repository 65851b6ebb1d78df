#pragma once

#include <cstdint>
#include <cstdlib>
#include <span>
#include <string_view>

#include "sample.hpp"

// As entry.hpp, for what programs of classic RoBIOS hand over.
namespace eyebridge::fuzz {

/// A sample of AUPlaySample() is refused, or becomes a WAV file that is read as the same sound.
inline void sample(std::string_view text) {
  using robios::classic::read_sample;
  const auto* const data = reinterpret_cast<const std::uint8_t*>(text.data());
  const auto read = read_sample({data, text.size()});
  if (!read) return;
  const auto again = read_sample(read->wav);
  if (!again || again->frequency != read->frequency || again->wav != read->wav) std::abort();
}

}  // namespace eyebridge::fuzz
