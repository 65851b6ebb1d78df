#include <algorithm>
#include <cerrno>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

#include <unistd.h>

#include "eyebridge/base/read_file.hpp"
#include "eyebridge/files/readers.hpp"
#include "file_bytes.hpp"
#include "text.hpp"

namespace eyebridge::files {

std::string read_bytes(const std::filesystem::path& path, const std::string& what) {
  auto bytes = read_file(path, kMaxFileSize);
  if (bytes) return std::move(*bytes);
  std::string why = bytes.error().what;
  if (why == "is not a file") why += ": expected " + what;
  throw ConfigError({path.string()}, why);
}

namespace {

/// What is wrong, as the system says it; nothing when all is there.
std::error_code write_there(const std::filesystem::path& path, const std::string& bytes) {
  errno = 0;
  std::ofstream out(path, std::ios::binary);
  out << bytes << std::flush;
  if (out) return {};
  return {errno != 0 ? errno : EIO, std::generic_category()};
}

}  // namespace

void write_bytes(const std::filesystem::path& path, const std::string& bytes) {
  std::error_code error;
  // A link stays one.
  std::filesystem::path target = std::filesystem::weakly_canonical(path, error);
  if (error) target = path;
  const auto there = std::filesystem::status(target, error);
  // Beside its place first: a disk that is full leaves what was there. Not so for devices.
  const bool in_place = std::filesystem::exists(there) && !std::filesystem::is_regular_file(there);
  std::filesystem::path part = target;
  if (!in_place) part += '.' + std::to_string(getpid()) + ".part";
  error = write_there(part, bytes);
  std::error_code ignored;
  if (!in_place && !error) {
    if (std::filesystem::exists(there)) {
      std::filesystem::permissions(part, there.permissions(), ignored);
    }
    std::filesystem::rename(part, target, error);
  }
  if (!error) return;
  if (!in_place) std::filesystem::remove(part, ignored);
  throw ConfigError({path.string(), 0, 0}, "cannot be written: " + error.message());
}

std::string description_in(std::string_view text) {
  constexpr std::string_view kMarks = "#;";
  std::string_view line = trimmed(without_bom(text));
  line = trimmed(line.substr(0, line.find('\n')));
  if (line.empty() || kMarks.find(line.front()) == std::string_view::npos) return "";
  line.remove_prefix(std::min(line.find_first_not_of(kMarks), line.size()));
  const std::string quoted = in_quotes(trimmed(line), 200);
  return quoted.substr(1, quoted.size() - 2);
}

std::string read_text_file(const std::filesystem::path& path) {
  std::string text = read_bytes(path, "a text file");
  check_text(text, path.string());
  return text;
}

}  // namespace eyebridge::files
