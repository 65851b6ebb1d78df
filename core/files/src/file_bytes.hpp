#pragma once

#include <filesystem>
#include <string>

namespace eyebridge::files {

/// Makes `bytes` the whole of the file at `path`, or leaves it as it is. Throws ConfigError.
void write_bytes(const std::filesystem::path& path, const std::string& bytes);

}  // namespace eyebridge::files
