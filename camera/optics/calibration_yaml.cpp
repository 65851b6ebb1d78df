#include "optics/calibration_yaml.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <pugixml.hpp>
#include <yaml-cpp/yaml.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/text.hpp"

namespace eyebridge::camera {
namespace {

constexpr double kWidest = 16384.0;  ///< Pixels.

/// OpenCV begins its files with "%YAML:1.0", which is not YAML.
constexpr std::string_view kOpencvMark = "%YAML:";

bool is_xml(std::string_view text) { return text.starts_with("<?xml"); }

/// OpenCV's XML says what its YAML says: elements are keys, lists have blanks between their words.
YAML::Node yaml_of(const pugi::xml_node& element) {
  YAML::Node node;
  for (const pugi::xml_node& child : element.children()) {
    if (child.type() != pugi::node_element) continue;
    const std::string_view name = child.name();
    const bool is_matrix = !child.child("data").empty();
    if (is_matrix) {
      node[child.name()] = yaml_of(child);
      continue;
    }
    std::istringstream words(child.child_value());
    YAML::Node list;
    for (std::string word; words >> word;) list.push_back(word);
    node[child.name()] = name == "data" || list.size() != 1 ? list : list[0];
  }
  return node;
}

class YamlReader {
 public:
  explicit YamlReader(const std::string& file) : file_(file) {}

  Calibration read(const std::string& text) {
    try {
      return read(YAML::Load(text));
    } catch (const YAML::Exception& error) {
      throw ConfigError(place(error.mark), error.msg);
    }
  }

  Calibration read(const YAML::Node& root) {
    root_ = root;
    if (!root_.IsMap()) throw ConfigError({file_, 1, 1}, "expected a calibration: 'key: value'");
    Calibration lens;
    lens.size = {side("image_width"), side("image_height")};
    const std::vector<double> matrix = matrix_of("camera_matrix", -1e6, 1e6);
    const YAML::Node at = root_["camera_matrix"];
    if (matrix.size() != 9) {
      refuse(at, fmt::format("camera_matrix has {} numbers, expected 9", matrix.size()));
    }
    lens.fx = matrix[0];
    lens.cx = matrix[2];
    lens.fy = matrix[4];
    lens.cy = matrix[5];
    const bool is_plain =
        matrix[1] == 0 && matrix[3] == 0 && matrix[6] == 0 && matrix[7] == 0 && matrix[8] == 1;
    if (!is_plain || !(lens.fx >= 1 && lens.fy >= 1)) {
      refuse(at, "expected camera_matrix as fx 0 cx, 0 fy cy, 0 0 1, in pixels");
    }
    read_distortion(lens);
    if (const YAML::Node error = root_["avg_reprojection_error"]) {
      lens.error = number(error, "avg_reprojection_error", 0.0, 1e3);
    }
    return lens;
  }

 private:
  [[nodiscard]] SourceLocation place(const YAML::Mark& mark) const {
    return {file_, mark.line + 1, mark.column + 1};
  }
  [[noreturn]] void refuse(const YAML::Node& node, const std::string& what) const {
    throw ConfigError(place(node.Mark()), what);
  }

  [[nodiscard]] YAML::Node node_of(const char* key) const {
    YAML::Node node = root_[key];
    if (node) return node;
    throw ConfigError({file_}, fmt::format("has no '{}', expected one: is it a calibration?", key));
  }

  [[nodiscard]] double number(const YAML::Node& node, const char* key, double low,
                              double high) const {
    const std::string text = node.IsScalar() ? node.Scalar() : std::string();
    double value = 0.0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || stop != text.data() + text.size()) {
      refuse(node, fmt::format("found {}, expected a number in '{}'", in_quotes(text), key));
    }
    if (!(value >= low && value <= high)) {
      refuse(node, fmt::format("found {} in '{}', expected {} to {}", value, key, low, high));
    }
    return value;
  }

  [[nodiscard]] int side(const char* key) const {
    const YAML::Node node = node_of(key);
    const double pixels = number(node, key, 1.0, kWidest);
    if (pixels != std::floor(pixels))
      refuse(node, fmt::format("expected '{}' in whole pixels", key));
    return static_cast<int>(pixels);
  }

  /// `data` of a matrix, or a list alone.
  [[nodiscard]] std::vector<double> matrix_of(const char* key, double low, double high) const {
    const YAML::Node node = node_of(key);
    const YAML::Node data = node.IsMap() ? node["data"] : node;
    if (!data || !data.IsSequence() || data.size() > 100) {
      refuse(node, fmt::format("expected '{}' to be a matrix with its 'data'", key));
    }
    std::vector<double> out;
    for (const YAML::Node& value : data) out.push_back(number(value, key, low, high));
    return out;
  }

  void read_distortion(Calibration& lens) const {
    const std::vector<double> values = matrix_of("distortion_coefficients", -1e3, 1e3);
    const YAML::Node at = root_["distortion_coefficients"];
    if (const YAML::Node model = root_["distortion_model"]) {
      const std::string name = model.IsScalar() ? model.Scalar() : std::string();
      if (name != "plumb_bob" && name != "rational_polynomial") {
        refuse(model,
               fmt::format("found the distortion model {}, expected plumb_bob: calibrate the "
                           "camera with it",
                           in_quotes(name)));
      }
    }
    const auto beyond = values.begin() + static_cast<long>(std::min<std::size_t>(values.size(), 5));
    if (std::any_of(beyond, values.end(), [](double value) { return value != 0; })) {
      refuse(at, fmt::format("found {} distortion coefficients, expected k1, k2, p1, p2, k3 alone: "
                             "calibrate with five",
                             values.size()));
    }
    std::copy(values.begin(), beyond, lens.distortion.begin());
  }

  const std::string& file_;
  YAML::Node root_;
};

}  // namespace

bool is_yaml_calibration(std::string_view text) {
  return text.starts_with(kOpencvMark) || is_xml(text) ||
         text.find("camera_matrix:") != std::string_view::npos;
}

Calibration parse_yaml_calibration(std::string_view text, const std::string& file) {
  if (is_xml(text)) {
    pugi::xml_document document;
    const auto result = document.load_buffer(text.data(), text.size());
    if (!result) {
      const auto line = 1 + std::count(text.begin(), text.begin() + result.offset, '\n');
      throw ConfigError({file, static_cast<int>(line), 0},
                        std::string("not well-formed XML: ") + result.description());
    }
    return YamlReader(file).read(yaml_of(document.child("opencv_storage")));
  }
  std::string yaml(text);
  // Its line stays, so that the others keep their numbers.
  if (text.starts_with(kOpencvMark)) yaml.replace(0, std::min(text.find('\n'), text.size()), "#");
  return YamlReader(file).read(yaml);
}

}  // namespace eyebridge::camera
