#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "eyebridge/bridges/can/identifier.hpp"
#include "eyebridge/bridges/io7/command_table.hpp"
#include "eyebridge/bridges/io7/profile.hpp"

namespace eyebridge::bridges::test {

/// The lines of tests/data/protocol/`name` without comments, split at blanks. Fails the test when
/// there are none.
std::vector<std::vector<std::string>> golden_lines(const std::string& name);

/// "6D 01" or "6D01" as bytes.
std::vector<std::uint8_t> bytes_from_hex(std::string_view hex);

/// "183#C01D…" or "2D1##1…" as a frame.
CanFrame frame_from_text(std::string_view text);

/// A profile with all letters, v-omega too, and what a form word of io7.hex says.
io7::Profile profile_of(std::string_view form);

/// The bytes of `text`.
std::vector<std::uint8_t> bytes_of(std::string_view text);

}  // namespace eyebridge::bridges::test
