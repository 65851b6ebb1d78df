#include "eyebridge/base/trust.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <system_error>

#include "eyebridge/base/hash.hpp"
#include "eyebridge/base/one_line.hpp"
#include "eyebridge/base/write_file.hpp"

namespace eyebridge {
namespace {

namespace fs = std::filesystem;

/// Where symbolic links lead; the rest as it is.
fs::path resolved(const fs::path& file) {
  std::error_code error;
  fs::path out = fs::weakly_canonical(fs::absolute(file, error), error);
  if (error) return {};
  return out.has_filename() ? out : out.parent_path();
}

/// The file that the entry at `place` is about, and what it may ask for.
std::optional<Trust::Entry> read_entry(const fs::path& place) {
  std::ifstream in(place, std::ios::binary);
  std::string line;
  if (!std::getline(in, line)) return std::nullopt;
  Trust::Entry entry{unescaped(line), {}};
  while (std::getline(in, line)) entry.asked.push_back(unescaped(line));
  return entry;
}

}  // namespace

Trust Trust::of_user() {
  constexpr const char* kFolder = "eyebridge/trusted";
  const auto variable = [](const char* name) {
    const char* const value = std::getenv(name);
    return fs::path(value == nullptr ? "" : value);
  };
  if (const fs::path data = variable("XDG_DATA_HOME"); data.is_absolute()) {
    return Trust(data / kFolder);
  }
  const fs::path home = variable("HOME");
  return Trust(home.is_absolute() ? home / ".local/share" / kFolder : fs::path());
}

fs::path Trust::place_of(const fs::path& file) const {
  StateHash hash;
  for (const char c : resolved(file).string()) hash.add_byte(static_cast<std::uint8_t>(c));
  std::array<char, 16> name{};
  const auto end = std::to_chars(name.begin(), name.end(), hash.value(), 16).ptr;
  return folder_ / std::string(name.begin(), end);
}

bool Trust::covers(const fs::path& file, std::string_view asked) const {
  if (folder_.empty()) return false;
  const auto entry = read_entry(place_of(file));
  return entry && entry->file == resolved(file) &&
         std::ranges::find(entry->asked, asked) != entry->asked.end();
}

void Trust::give(const fs::path& file, const std::vector<std::string>& asked) const {
  if (folder_.empty()) {
    throw fs::filesystem_error("HOME is not set, so nothing can be trusted", file,
                               std::make_error_code(std::errc::no_such_file_or_directory));
  }
  fs::create_directories(folder_);
  std::string text = escaped(resolved(file).string()) + '\n';
  for (const std::string& one : asked) text += escaped(one) + '\n';
  const fs::path place = place_of(file);
  if (const auto done = write_file(place, text); !done) {
    throw std::runtime_error(place.string() + ": " + done.error().what);
  }
}

bool Trust::take_back(const fs::path& file) const {
  if (folder_.empty()) return false;
  return fs::remove(place_of(file));
}

std::vector<Trust::Entry> Trust::entries() const {
  std::vector<Entry> out;
  std::error_code error;
  fs::directory_iterator place(folder_, error);
  for (const fs::directory_iterator end; !error && place != end; place.increment(error)) {
    if (place->path().has_extension()) continue;  // one that is being written
    if (auto entry = read_entry(place->path())) out.push_back(std::move(*entry));
  }
  std::ranges::sort(out, {}, &Entry::file);
  return out;
}

std::string how_to_trust(const fs::path& file) {
  return "; a file of a folder may do that when you have said so: look at it, then 'eyebridge "
         "trust " +
         file.string() + "'";
}

bool is_within(const fs::path& file, const fs::path& folder) {
  const fs::path inner = resolved(file);
  const fs::path outer = resolved(folder.empty() ? fs::path(".") : folder);
  if (inner.empty() || outer.empty()) return false;
  return std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end()).first == outer.end();
}

}  // namespace eyebridge
