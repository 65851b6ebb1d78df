#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

namespace eyebridge::gallery {

/// One table of programs.toml, whose first lines say what each key means.
struct Row {
  std::string name;
  std::string source;
  std::string world;
  std::string keys;
  std::string time_limit = "60s";
  std::vector<std::string> arguments;
  std::vector<std::string> files;
  bool classic = false;
  bool camera = false;
  bool threads = false;
  double tolerance = 0.0;

  [[nodiscard]] bool is_python() const { return source.ends_with(".py"); }
};

/// For GoogleTest's messages.
void PrintTo(const Row& row, std::ostream* out);

/// Reads programs.toml. Throws std::runtime_error naming the file and the place.
std::vector<Row> read_table(const std::filesystem::path& file);

}  // namespace eyebridge::gallery
