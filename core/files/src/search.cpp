#include "search.hpp"

#include <algorithm>
#include <system_error>

#include "text.hpp"

namespace eyebridge::files {

std::filesystem::path find_file(const std::string& written, const std::filesystem::path& directory,
                                const SearchPlaces& places, const SourceLocation& where) {
  std::string name = written;
  std::replace(name.begin(), name.end(), '\\', '/');
  constexpr std::string_view kHome = "%sim%";
  if (lower(name).starts_with(kHome)) {
    if (places.eyesim_home.empty()) {
      throw ConfigError(where, in_quotes(written) +
                                   " found, but EYESIM_HOME is not set: expected it "
                                   "to name the folder that %sim% stands for");
    }
    std::string_view rest = std::string_view(name).substr(kHome.size());
    while (rest.starts_with('/')) rest.remove_prefix(1);
    name = (places.eyesim_home / rest).string();
  }
  std::string tried;
  const auto found = [&](const std::filesystem::path& path) {
    std::error_code error;
    return std::filesystem::exists(path, error);
  };
  // `place / name` is `name` where that is absolute.
  if (found(name)) return name;
  for (const auto& place : {directory, places.eyesim_home, places.worlds}) {
    if (!place.empty() && found(place / name)) return place / name;
  }
  throw ConfigError(where, "no file " + in_quotes(written) +
                               ": expected it in the working folder, beside this file, in "
                               "EYESIM_HOME or among the built-in worlds");
}

}  // namespace eyebridge::files
