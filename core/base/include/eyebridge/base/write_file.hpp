#pragma once

#include <filesystem>
#include <string_view>

#include "eyebridge/base/result.hpp"

namespace eyebridge {

/// Writes `bytes` as the whole file `path`. They go into a new file beside it, which then takes its
/// place, so after a failure the old file is unchanged. A link stays a link, a file keeps its
/// rights, and a device is written to. Fails with Unsupported; the message goes on after the file's
/// name: "cannot be written: No space left on device".
Result<void> write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace eyebridge
