#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "eyebridge/base/result.hpp"

namespace eyebridge {

/// All bytes of the regular file `path`. A pipe or a device is refused, not waited for. Fails with
/// Unsupported and what is wrong, as it goes on after the file's name: "no such file", "is not a
/// file", "has 9 bytes, expected at most 8", "cannot be read: Permission denied". `expected`
/// ("a picture") ends the message about what is not a file.
Result<std::string> read_file(const std::filesystem::path& path, std::uintmax_t most,
                              const std::string& expected = "");

/// The first `count` bytes of the regular file `path`; fewer where it has no more, none where it
/// cannot be read.
std::string first_bytes(const std::filesystem::path& path, std::size_t count);

}  // namespace eyebridge
