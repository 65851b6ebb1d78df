#include "eyebridge/files/search.hpp"

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <string_view>
#include <system_error>

#include "eyebridge/base/own_place.hpp"
#include "text.hpp"

namespace eyebridge::files {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kHome = "%sim%";
constexpr const char* kOwnWorlds = "eyebridge/worlds";

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

std::string with_slashes(std::string written) {
  std::replace(written.begin(), written.end(), '\\', '/');
  return written;
}

std::vector<fs::path> all_folders(const fs::path& directory, const SearchPlaces& places) {
  std::vector<fs::path> out = {""};
  if (!directory.empty()) out.push_back(directory);
  for (fs::path& folder : places.folders()) out.push_back(std::move(folder));
  return out;
}

/// The folders in which `name` was looked for, for a message.
std::string named(const std::vector<fs::path>& folders, const fs::path& name) {
  if (name.is_absolute()) return name.parent_path().string();
  std::string out;
  for (const fs::path& folder : folders) {
    out += (out.empty() ? "" : ", ") + (folder.empty() ? "the working folder" : folder.string());
  }
  return out;
}

bool names_home(const std::string& written) { return lower(written).starts_with(kHome); }

/// The first one, by its path, of the files in `folder` and below that are called `name`.
std::optional<fs::path> anywhere_in(const fs::path& folder, const fs::path& name) {
  constexpr int kDeepest = 6;
  std::optional<fs::path> first;
  std::error_code error;
  fs::recursive_directory_iterator entry(folder, error);
  for (const fs::recursive_directory_iterator end; !error && entry != end; entry.increment(error)) {
    if (entry.depth() >= kDeepest) entry.disable_recursion_pending();
    const fs::path& path = entry->path();
    if (path.filename() == name && (!first || path < *first)) first = path;
  }
  return first;
}

std::optional<fs::path> by_last_name(const std::string& written, const fs::path& directory,
                                     const SearchPlaces& places) {
  const fs::path name = fs::path(with_slashes(written)).filename();
  if (name.empty()) return std::nullopt;
  std::error_code error;
  for (const fs::path& folder : all_folders(directory, places)) {
    fs::path path = folder / name;
    if (fs::is_regular_file(path, error)) return path;
  }
  if (places.eyesim_home.empty()) return std::nullopt;
  return anywhere_in(places.eyesim_home, name);
}

}  // namespace

SearchPlaces SearchPlaces::of_process(const fs::path& program) {
  SearchPlaces places;
  places.eyesim_home = variable("EYESIM_HOME");
  std::error_code error;
  if (!program.empty()) places.program = fs::absolute(program, error).parent_path() / "worlds";
  // The XDG base directory specification: relative folders do not count.
  const fs::path data = variable("XDG_DATA_HOME");
  const fs::path home = variable("HOME");
  if (data.is_absolute()) {
    places.user = data / kOwnWorlds;
  } else if (!home.empty()) {
    places.user = home / ".local/share" / kOwnWorlds;
  }
  places.installed = own_worlds();
  return places;
}

std::vector<fs::path> SearchPlaces::folders() const {
  std::vector<fs::path> out;
  for (const fs::path& place : {eyesim_home, program, user, installed}) {
    if (!place.empty()) out.push_back(place);
  }
  return out;
}

fs::path own_worlds() {
  if (const fs::path share = share_folder(); !share.empty()) return share / "worlds";
  std::string list = variable("XDG_DATA_DIRS");
  if (list.empty()) list = "/usr/local/share:/usr/share";
  std::istringstream folders(list);
  for (std::string folder; std::getline(folders, folder, ':');) {
    std::error_code error;
    fs::path worlds = fs::path(folder) / kOwnWorlds;
    if (worlds.is_absolute() && fs::is_directory(worlds, error)) return worlds;
  }
  return {};
}

std::optional<std::filesystem::path> look_for(const std::string& written,
                                              const std::vector<std::filesystem::path>& folders,
                                              const SearchPlaces& places) {
  std::string name = with_slashes(written);
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

std::optional<std::filesystem::path> try_find_file(const std::string& written,
                                                   const std::filesystem::path& directory,
                                                   const SearchPlaces& places) {
  return look_for(written, all_folders(directory, places), places);
}

std::filesystem::path find_file(const std::string& written, const std::filesystem::path& directory,
                                const SearchPlaces& places, const SourceLocation& where) {
  if (names_home(written) && places.eyesim_home.empty()) {
    throw ConfigError(where, in_quotes(written, 300) +
                                 " found, but EYESIM_HOME is not set: expected it "
                                 "to name the folder that %sim% stands for");
  }
  const std::vector<fs::path> folders = all_folders(directory, places);
  if (const auto found = look_for(written, folders, places)) return *found;
  const fs::path name = with_slashes(written);
  const std::vector<std::string> similar = similar_files(name.string(), folders);
  std::string text = "no file " + in_quotes(written, 300) + ": expected ";
  if (similar.empty()) text += "a path, or a name that eyebridge world list shows";
  for (std::size_t i = 0; i < similar.size(); ++i) {
    if (i > 0) text += i + 1 == similar.size() ? " or " : ", ";
    text += in_quotes(similar[i], 300);
    if (lower(similar[i]) == lower(name.string())) text += " (only the case differs)";
  }
  throw ConfigError(where, text + "; looked in " + named(folders, name));
}

std::filesystem::path find_file_of_others(const std::string& written,
                                          const std::filesystem::path& directory,
                                          const SearchPlaces& places, const SourceLocation& where,
                                          std::vector<Warning>& warnings, Reading reading) {
  if (auto found = try_find_file(written, directory, places)) return *found;
  if (reading == Reading::Strict) return find_file(written, directory, places, where);  // throws
  const auto other = by_last_name(written, directory, places);
  if (!other) return find_file(written, directory, places, where);  // throws
  warnings.push_back({where, "no file " + in_quotes(written, 300) +
                                 " here: " + in_quotes(other->string(), 300) + " is read instead"});
  return *other;
}

}  // namespace eyebridge::files
