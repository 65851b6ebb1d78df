#pragma once

#include <filesystem>
#include <string_view>

#include "eyebridge/base/result.hpp"

namespace eyebridge {

/// Makes `bytes` the whole of the file `path`, or leaves it as it was: they are written beside it
/// first. A link stays one, and so do a file's rights; a device is written to. Fails with
/// Unsupported and what is wrong, as it goes on after the file's name: "cannot be written: No space
/// left on device".
Result<void> write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace eyebridge
