#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "eyebridge/files/map_files.hpp"
#include "eyebridge/files/readers.hpp"
#include "file_bytes.hpp"
#include "map_limits.hpp"
#include "text.hpp"

namespace eyebridge::files {
namespace {

constexpr std::array<std::string_view, 7> kMapKeys = {
    "image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh", "mode"};
constexpr std::array<std::string_view, 3> kMapModes = {"trinary", "scale", "raw"};

/// `text` with blanks for what YAML puts around and between the numbers of a list.
std::string without_brackets(std::string_view text) {
  std::string out(text);
  bool in_origin = false;
  for (std::size_t line = 0; line < out.size();) {
    const std::size_t end = std::min(out.find('\n', line), out.size());
    const std::string_view row = std::string_view(out).substr(line, end - line);
    const std::size_t word = row.find_first_not_of(" \t");
    const bool is_key = word != std::string_view::npos && row[word] >= 'a' && row[word] <= 'z';
    if (is_key) in_origin = row.substr(word).starts_with("origin:");
    for (std::size_t i = line; in_origin && i < end && out[i] != '#'; ++i) {
      if (out[i] == '[' || out[i] == ']' || out[i] == ',') out[i] = ' ';
    }
    line = end + 1;
  }
  return out;
}

/// Reads one `.yaml`.
class DescriptionReader {
 public:
  DescriptionReader(std::string_view text, const std::string& file, std::vector<Warning>& warnings)
      : text_(without_brackets(text)), file_(file), warnings_(file, warnings) {}

  MapDescription read() {
    StatementReader reader(text_, file_);
    Statement line;
    while (reader.next(line)) {
      if (line.size() == 1 && (line.text(0) == "---" || line.text(0) == "...")) continue;
      if (goes_on(line)) {
        take_origin(line, 0);
      } else {
        take(line);
      }
    }
    const SourceLocation end{file_, reader.line() + 1, 1};
    for (const std::string_view key : {"image", "resolution", "origin"}) {
      if (!seen(key)) throw ConfigError(end, "file ends without '" + std::string(key) + "'");
    }
    if (origin_.size() < 3) {
      throw ConfigError(end, "origin has " + std::to_string(origin_.size()) +
                                 " numbers: expected 3, x, y and yaw");
    }
    if (map_.free_thresh > map_.occupied_thresh) {
      throw ConfigError(thresh_where_, "free_thresh is above occupied_thresh");
    }
    return map_;
  }

 private:
  /// Whether the line is one more of the list of the origin's numbers.
  bool goes_on(const Statement& line) const {
    return seen("origin") && origin_.size() < 3 && (line.text(0) == "-" || line.is_number(0));
  }

  bool seen(std::string_view key) const {
    for (std::size_t i = 0; i < kMapKeys.size(); ++i) {
      if (kMapKeys[i] == key) return seen_[i];
    }
    return false;
  }

  /// The place of the line's key in kMapKeys; nothing for one that we do not know.
  std::optional<std::size_t> key_of(const Statement& line) {
    std::string_view key = line.text(0);
    if (!key.ends_with(':') || key.size() == 1) {
      line.fail(0, in_quotes(key) + " found: expected 'key: value'");
    }
    key.remove_suffix(1);
    for (std::size_t i = 0; i < kMapKeys.size(); ++i) {
      if (kMapKeys[i] == key) return i;
    }
    const std::string_view near = nearest(key, kMapKeys);
    warnings_.add(line.line(), line.token(0).column,
                  "key " + in_quotes(key) + " is ignored" +
                      (near.empty() ? "" : ": did you mean '" + std::string(near) + "'?"));
    return std::nullopt;
  }

  void take(const Statement& line) {
    const auto key = key_of(line);
    if (!key) return;
    const std::string_view name = kMapKeys[*key];
    if (seen_[*key]) line.fail(0, in_quotes(name) + " is said twice");
    seen_[*key] = true;
    if (name == "origin") return take_origin(line, 1);
    if (line.size() < 2) line.fail(1, "line ends: expected a value of '" + std::string(name) + "'");
    if (name == "image") {
      map_.image = line.rest(1);
      map_.image_where = line.where(1);
      return;
    }
    line.expect_arguments(1, std::string(name) + ": value");
    if (name == "resolution") {
      map_.resolution = line.number(1, "resolution", kLeastResolution, kMostResolution);
    } else if (name == "negate") {
      map_.negate = flag(line);
    } else if (name == "mode") {
      map_.mode = mode(line);
    } else {
      thresh_where_ = line.where(1);
      double& thresh = name == "free_thresh" ? map_.free_thresh : map_.occupied_thresh;
      thresh = line.number(1, name, 0.0, 1.0);
      if (thresh == 0.0 || thresh == 1.0) {
        line.fail(1, std::string(name) + " is " + std::string(line.text(1)) +
                         ": expected more than 0 and less than 1");
      }
    }
  }

  void take_origin(const Statement& line, std::size_t first) {
    constexpr const char* kNames[] = {"origin's x", "origin's y", "origin's yaw"};
    for (std::size_t i = first; i < line.size(); ++i) {
      if (line.text(i) == "-") continue;  // of a list with a line for each item
      if (origin_.size() == 3) line.fail(i, "origin has more than 3 numbers");
      origin_.push_back(line.number(i, kNames[origin_.size()], -kMostOrigin, kMostOrigin));
      if (origin_.size() == 3 && origin_[2] != 0.0) {
        line.fail(i, "origin's yaw is " + std::string(line.text(i)) +
                         ": expected 0, the map along the axes");
      }
    }
    if (origin_.size() >= 2) map_.origin = {origin_[0], origin_[1]};
  }

  static bool flag(const Statement& line) {
    const std::string word = lower(line.text(1));
    if (word == "0" || word == "false" || word == "no" || word == "off") return false;
    if (word == "1" || word == "true" || word == "yes" || word == "on") return true;
    line.fail(1, in_quotes(line.text(1)) + " found: expected 0, 1, false or true");
  }

  static MapMode mode(const Statement& line) {
    const std::string word = lower(line.text(1));
    if (word == "trinary") return MapMode::Trinary;
    if (word == "scale") return MapMode::Scale;
    if (word == "raw") return MapMode::Raw;
    line.fail(1, "mode " + in_quotes(line.text(1)) + " found: expected " + one_of(kMapModes));
  }

  std::string text_;
  const std::string& file_;
  Warnings warnings_;
  MapDescription map_;
  std::array<bool, kMapKeys.size()> seen_{};
  std::vector<double> origin_;
  SourceLocation thresh_where_;
};

/// Probability that a grey stands for; nothing when it is unknown.
std::optional<double> probability_of_grey(const MapDescription& map, std::uint8_t grey) {
  if (map.mode == MapMode::Raw) {
    if (grey > 100) return std::nullopt;
    return grey / 100.0;
  }
  const double p = (map.negate ? grey : 255 - grey) / 255.0;
  if (p > map.occupied_thresh) return 1.0;
  if (p < map.free_thresh) return 0.0;
  if (map.mode == MapMode::Trinary || map.free_thresh == map.occupied_thresh) return std::nullopt;
  return (p - map.free_thresh) / (map.occupied_thresh - map.free_thresh);
}

}  // namespace

MapDescription read_map_description(std::string_view text, const std::string& file,
                                    std::vector<Warning>& warnings) {
  return DescriptionReader(without_bom(text), file, warnings).read();
}

mapping::OccupancyGrid map_of(const MapDescription& description, const GreyPicture& picture) {
  mapping::OccupancySettings settings;
  // Cells of which nothing is known stay so, wherever the thresholds lie.
  settings.occupied_above = std::max(description.occupied_thresh, settings.prior);
  settings.free_below = std::min(description.free_thresh, settings.prior);
  settings.max_cells = mapping::kMostMapCells;
  mapping::OccupancyGrid grid(
      {description.origin, description.resolution, picture.columns, picture.rows}, settings);
  std::size_t i = 0;
  for (int row = picture.rows - 1; row >= 0; --row) {
    for (int column = 0; column < picture.columns; ++column, ++i) {
      const auto p = probability_of_grey(description, picture.greys[i]);
      if (p) grid.set_probability({column, row}, *p);
    }
  }
  return grid;
}

mapping::OccupancyGrid load_map(const std::filesystem::path& path, std::vector<Warning>& warnings) {
  const MapDescription description =
      read_map_description(read_text_file(path), path.string(), warnings);
  const std::filesystem::path image = path.parent_path() / description.image;
  std::error_code error;
  if (!std::filesystem::exists(image, error)) {
    throw ConfigError(description.image_where, "no such file: " + in_quotes(image.string(), 200));
  }
  return map_of(description, read_map_picture(read_bytes(image, "a picture"), image.string()));
}

}  // namespace eyebridge::files
