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

/// `path` still leads to the open file `descriptor`: nobody has removed it or put another one
/// there.
bool is_still_at(const std::filesystem::path& path, int descriptor);

/// What is said of a result that is_still_at() does not find: "it was removed during the run".
inline constexpr const char* kRemoved = "it was removed during the run";

}  // namespace eyebridge
