#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "eyebridge/base/read_file.hpp"
#include "eyebridge/base/write_file.hpp"
#include "eyebridge/files/readers.hpp"
#include "file_bytes.hpp"
#include "maze_formats.hpp"
#include "text.hpp"
#include "text_encoding.hpp"

namespace eyebridge::files {

std::string read_bytes(const std::filesystem::path& path, const std::string& what) {
  auto bytes = read_file(path, kMaxFileSize, what);
  if (!bytes) throw ConfigError({path.string()}, bytes.error().what);
  return std::move(*bytes);
}

void write_bytes(const std::filesystem::path& path, const std::string& bytes) {
  if (const auto done = write_file(path, bytes); !done) {
    throw ConfigError({path.string()}, done.error().what);
  }
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
  std::string text = as_utf8(read_bytes(path, "a text file"), path.string());
  check_text(text, path.string());
  return text;
}

std::string read_maze_file(const std::filesystem::path& path) {
  std::string bytes = read_bytes(path, "a maze");
  if (maze_format(bytes) == MazeFormat::Binary) return bytes;
  std::string text = as_utf8(std::move(bytes), path.string());
  check_text(text, path.string());
  return text;
}

}  // namespace eyebridge::files
