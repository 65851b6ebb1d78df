#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/files/load.hpp"

namespace eyebridge::files {

/// The file that `written` means in a file that lies in `directory` (empty: the working folder).
///
/// Looked for as given, then in `directory`, then in `places.folders()`; `%sim%` stands for
/// EyeSim's home and backslashes for slashes. Throws ConfigError at `where`: what is missing, the
/// nearest names that there are, and where it was looked for.
std::filesystem::path find_file(const std::string& written, const std::filesystem::path& directory,
                                const SearchPlaces& places, const SourceLocation& where);

/// The same for a name in a file that may come from another computer. Where `written` leads
/// nowhere and `reading` is Tolerant, it takes a file of the same last name that lies beside it,
/// among `places.folders()` or anywhere in EyeSim's home, and adds a warning.
std::filesystem::path find_file_of_others(const std::string& written,
                                          const std::filesystem::path& directory,
                                          const SearchPlaces& places, const SourceLocation& where,
                                          std::vector<Warning>& warnings, Reading reading);

/// As find_file(), but nothing where that would throw.
std::optional<std::filesystem::path> try_find_file(const std::string& written,
                                                   const std::filesystem::path& directory,
                                                   const SearchPlaces& places);

/// The file that `written` means, in the first of `folders` that has it; "" is the working folder.
/// `%sim%` and backslashes as in find_file().
std::optional<std::filesystem::path> look_for(const std::string& written,
                                              const std::vector<std::filesystem::path>& folders,
                                              const SearchPlaces& places);

/// Names of at most three files in `folders` that `written` may have been meant to be, nearest
/// first, as they would be found. Case is ignored, and a missing or wrong ending forgiven.
std::vector<std::string> similar_files(const std::string& written,
                                       const std::vector<std::filesystem::path>& folders);

}  // namespace eyebridge::files
