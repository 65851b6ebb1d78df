#pragma once

#include <filesystem>
#include <string_view>

namespace eyebridge {

/// That a result may be written to the file `path`: nothing is there, or an empty file, or one that
/// begins with `beginning`, as results of this kind do. Anything else may be somebody's work.
/// `kind` is what it is called: "report". Throws ConfigError without a place.
void check_replaceable(const std::filesystem::path& path, std::string_view kind,
                       std::string_view beginning);

/// Removes `path` if it is a symbolic link to anything except a device: what is written there next
/// must not replace a file in another folder.
void drop_link(const std::filesystem::path& path);

}  // namespace eyebridge
