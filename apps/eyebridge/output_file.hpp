#pragma once

#include <cstdio>
#include <memory>
#include <string>

namespace eyebridge::apps {

/// A text that is written line by line: complete even when the process is killed.
using OutputFile = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// The file at `path`, which the option `flag` names, emptied; null for "". Throws ConfigError when
/// it cannot be written.
OutputFile open_output(const std::string& path, const char* flag);

}  // namespace eyebridge::apps
