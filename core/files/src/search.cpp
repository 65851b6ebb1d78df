#include "eyebridge/files/search.hpp"

#include <algorithm>
#include <string_view>
#include <system_error>

#include "text.hpp"

namespace eyebridge::files {
namespace {

constexpr std::string_view kHome = "%sim%";

bool names_home(const std::string& written) { return lower(written).starts_with(kHome); }

}  // namespace

std::optional<std::filesystem::path> look_for(const std::string& written,
                                              const std::vector<std::filesystem::path>& folders,
                                              const SearchPlaces& places) {
  std::string name = written;
  std::replace(name.begin(), name.end(), '\\', '/');
  if (names_home(name)) {
    if (places.eyesim_home.empty()) return std::nullopt;
    std::string_view rest = std::string_view(name).substr(kHome.size());
    while (rest.starts_with('/')) rest.remove_prefix(1);
    name = (places.eyesim_home / rest).string();
  }
  for (const std::filesystem::path& folder : folders) {
    std::error_code error;
    // This is `name` alone where that is absolute.
    const std::filesystem::path path = folder / name;
    if (std::filesystem::exists(path, error)) return path;
  }
  return std::nullopt;
}

std::filesystem::path find_file(const std::string& written, const std::filesystem::path& directory,
                                const SearchPlaces& places, const SourceLocation& where) {
  if (names_home(written) && places.eyesim_home.empty()) {
    throw ConfigError(where, in_quotes(written, 300) +
                                 " found, but EYESIM_HOME is not set: expected it "
                                 "to name the folder that %sim% stands for");
  }
  std::vector<std::filesystem::path> folders = {"", directory};
  for (const auto& place : {places.eyesim_home, places.worlds}) {
    if (!place.empty()) folders.push_back(place);
  }
  if (const auto found = look_for(written, folders, places)) return *found;
  throw ConfigError(where, "no file " + in_quotes(written, 300) +
                               ": expected it in the working folder, beside this file, in "
                               "EYESIM_HOME or among the built-in worlds");
}

}  // namespace eyebridge::files
