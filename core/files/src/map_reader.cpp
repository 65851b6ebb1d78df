#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "eyebridge/files/map_files.hpp"
#include "eyebridge/files/readers.hpp"
#include "file_bytes.hpp"
#include "map_frame.hpp"
#include "map_limits.hpp"
#include "text.hpp"

namespace eyebridge::files {
namespace {

constexpr std::array<std::string_view, 7> kMapKeys = {
    "image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh", "mode"};
constexpr std::array<std::string_view, 3> kMapModes = {"trinary", "scale", "raw"};
/// A description is a few lines; the library takes a hundred times its size.
constexpr std::size_t kLargestDescription = 1U << 20U;

/// Without an exponent where a person would write none.
std::string plain_number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

/// Reads one `.yaml`, by yaml-cpp.
class DescriptionReader {
 public:
  DescriptionReader(const std::string& file, std::vector<Warning>& warnings)
      : file_(file), warnings_(file, warnings) {}

  MapDescription read(const std::string& text) {
    if (text.size() > kLargestDescription) {
      throw ConfigError({file_, 0, 0}, "more than 1 MiB: expected the few lines of a map");
    }
    YAML::Node root;
    try {
      root = YAML::Load(text);
    } catch (const YAML::Exception& error) {
      throw ConfigError(where(error.mark), error.msg);
    }
    if (!root.IsMap()) {
      throw ConfigError({file_, 1, 1}, "no map: expected lines 'key: value', image the first");
    }
    for (const auto& entry : root) take(entry.first, entry.second);
    for (const std::string_view key : {"image", "resolution", "origin"}) {
      if (!seen(key)) {
        throw ConfigError({file_, static_cast<int>(std::ranges::count(text, '\n')) + 1, 1},
                          "file ends without '" + std::string(key) + "'");
      }
    }
    if (map_.free_thresh > map_.occupied_thresh) {
      throw ConfigError(thresh_where_, "free_thresh is above occupied_thresh");
    }
    return map_;
  }

 private:
  [[nodiscard]] SourceLocation where(const YAML::Mark& mark) const {
    return {file_, mark.line + 1, mark.column + 1};
  }
  [[nodiscard]] SourceLocation where(const YAML::Node& node) const { return where(node.Mark()); }
  [[noreturn]] void refuse(const YAML::Node& node, const std::string& what) const {
    throw ConfigError(where(node), what);
  }

  [[nodiscard]] bool seen(std::string_view key) const {
    return seen_[static_cast<std::size_t>(std::ranges::find(kMapKeys, key) - kMapKeys.begin())];
  }

  void take(const YAML::Node& name, const YAML::Node& value) {
    if (!name.IsScalar()) refuse(name, "a key that is no word: expected " + one_of(kMapKeys));
    const std::string& key = name.Scalar();
    const auto found = std::ranges::find(kMapKeys, key);
    if (found == kMapKeys.end()) {
      const std::string_view near = nearest(key, kMapKeys);
      const SourceLocation at = where(name);
      warnings_.add(at.line, at.column,
                    "key " + in_quotes(key) + " is ignored" +
                        (near.empty() ? "" : ": did you mean '" + std::string(near) + "'?"));
      return;
    }
    bool& is_seen = seen_[static_cast<std::size_t>(found - kMapKeys.begin())];
    if (is_seen) refuse(name, in_quotes(key) + " is said twice");
    is_seen = true;
    if (key == "origin") return take_origin(value);
    if (!value.IsScalar() || value.Scalar().empty()) {
      refuse(value.IsDefined() ? value : name, "expected a value of '" + key + "'");
    }
    if (key == "image") {
      map_.image = value.Scalar();
      map_.image_where = where(value);
    } else if (key == "resolution") {
      map_.resolution = number(value, "resolution", kLeastResolution, kMostResolution);
    } else if (key == "negate") {
      map_.negate = flag(value);
    } else if (key == "mode") {
      map_.mode = mode(value);
    } else {
      thresh_where_ = where(value);
      double& thresh = key == "free_thresh" ? map_.free_thresh : map_.occupied_thresh;
      thresh = number(value, key, 0.0, 1.0);
      if (thresh == 0.0 || thresh == 1.0) {
        refuse(value, key + " is " + value.Scalar() + ": expected more than 0 and less than 1");
      }
    }
  }

  void take_origin(const YAML::Node& list) {
    if (!list.IsSequence() || list.size() != 3) {
      refuse(list, "origin has " +
                       (list.IsSequence() ? std::to_string(list.size()) : std::string("no")) +
                       " numbers: expected 3, [x, y, yaw]");
    }
    map_.origin.x = number(list[0], "origin's x", -kMostOrigin, kMostOrigin);
    map_.origin.y = number(list[1], "origin's y", -kMostOrigin, kMostOrigin);
    map_.yaw = number(list[2], "origin's yaw", -kMostYaw, kMostYaw);
  }

  [[nodiscard]] double number(const YAML::Node& node, const std::string& what, double low,
                              double high) const {
    const std::string text = node.IsScalar() ? node.Scalar() : std::string();
    const auto value = parse_number(text);
    if (!value) refuse(node, in_quotes(text) + " found: expected " + what + ", a number");
    if (*value < low || *value > high) {
      refuse(node, what + " is " + text + ": expected " + plain_number(low) + " to " +
                       plain_number(high));
    }
    return *value;
  }

  [[nodiscard]] bool flag(const YAML::Node& node) const {
    const std::string word = lower(node.Scalar());
    if (word == "0" || word == "false" || word == "no" || word == "off") return false;
    if (word == "1" || word == "true" || word == "yes" || word == "on") return true;
    refuse(node, in_quotes(node.Scalar()) + " found: expected 0, 1, false or true");
  }

  [[nodiscard]] MapMode mode(const YAML::Node& node) const {
    const std::string word = lower(node.Scalar());
    if (word == "trinary") return MapMode::Trinary;
    if (word == "scale") return MapMode::Scale;
    if (word == "raw") return MapMode::Raw;
    refuse(node, "mode " + in_quotes(node.Scalar()) + " found: expected " + one_of(kMapModes));
  }

  const std::string& file_;
  Warnings warnings_;
  MapDescription map_;
  std::array<bool, kMapKeys.size()> seen_{};
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

bool is_occupied(const MapDescription& description, std::uint8_t grey) {
  const auto p = probability_of_grey(description, grey);
  return p && (description.mode == MapMode::Trinary ? *p == 1.0 : *p > description.occupied_thresh);
}

bool is_free(const MapDescription& description, std::uint8_t grey) {
  const auto p = probability_of_grey(description, grey);
  return p && (description.mode == MapMode::Trinary ? *p == 0.0 : *p < description.free_thresh);
}

MapDescription read_map_description(std::string_view text, const std::string& file,
                                    std::vector<Warning>& warnings) {
  return DescriptionReader(file, warnings).read(std::string(without_bom(text)));
}

mapping::OccupancyGrid map_of(const MapDescription& description, const GreyPicture& picture) {
  mapping::OccupancySettings settings;
  // Cells of which nothing is known stay so, wherever the thresholds lie.
  settings.occupied_above = std::max(description.occupied_thresh, settings.prior);
  settings.free_below = std::min(description.free_thresh, settings.prior);
  settings.max_cells = mapping::kMostMapCells;
  const MapFrame frame(description, picture.columns, picture.rows);
  const mapping::GridGeometry geometry = frame.covering();
  need_readable(geometry);
  mapping::OccupancyGrid grid(geometry, settings);
  for (int row = 0; row < geometry.rows; ++row) {
    for (int column = 0; column < geometry.columns; ++column) {
      const auto pixel = frame.pixel_at(geometry, {column, row});
      if (!pixel) continue;  // beside a map that is turned
      const auto p = probability_of_grey(description, picture.greys[*pixel]);
      if (p) grid.set_probability({column, row}, *p);
    }
  }
  return grid;
}

MapFiles read_map_files(const std::filesystem::path& path, std::vector<Warning>& warnings) {
  MapFiles map{read_map_description(read_text_file(path), path.string(), warnings), {}};
  const std::filesystem::path image = path.parent_path() / map.description.image;
  std::error_code error;
  if (!std::filesystem::exists(image, error)) {
    throw ConfigError(map.description.image_where,
                      "no such file: " + in_quotes(image.string(), 200));
  }
  map.picture = read_map_picture(read_bytes(image, "a picture"), image.string());
  return map;
}

mapping::OccupancyGrid load_map(const std::filesystem::path& path, std::vector<Warning>& warnings) {
  const MapFiles map = read_map_files(path, warnings);
  return map_of(map.description, map.picture);
}

}  // namespace eyebridge::files
