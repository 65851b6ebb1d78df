#pragma once

#include <filesystem>
#include <string>

namespace eyebridge::files {

/// The whole file at `path`, at most kMaxFileSize bytes, whatever they are. `what` it should be is
/// for messages. Throws ConfigError.
std::string read_bytes(const std::filesystem::path& path, const std::string& what);

/// Makes `bytes` the whole of the file at `path`, or leaves it as it is. Throws ConfigError.
void write_bytes(const std::filesystem::path& path, const std::string& bytes);

}  // namespace eyebridge::files
