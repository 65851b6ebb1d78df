#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/own_results.hpp"
#include "eyebridge/base/read_file.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/base/toml_library.hpp"
#include "eyebridge/base/toml_names.hpp"
#include "eyebridge/base/write_file.hpp"
#include "eyebridge/camera/calibration.hpp"
#include "optics/calibration_yaml.hpp"

namespace eyebridge::camera {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestFile = 64U * 1024U;
constexpr double kLargestSide = 16384.0;  ///< Pixels.

class CalibrationReader {
 public:
  CalibrationReader(const toml::table& table, const std::string& file)
      : table_(table), file_(file) {}

  Calibration read() && {
    for (const auto& [key, node] : table_) {
      if (key != "size" && key != "focal_length" && key != "centre" && key != "distortion" &&
          key != "error") {
        throw ConfigError(place(key.source()),
                          fmt::format("found key {}, expected size, focal_length, centre, "
                                      "distortion or error",
                                      in_quotes(key.str())));
      }
    }
    Calibration lens;
    const auto size = numbers<2>("size", 1.0, kLargestSide);
    for (const double side : size) {
      if (side != std::floor(side)) {
        throw ConfigError(place(table_.get("size")->source()),
                          fmt::format("found {} in 'size', expected whole pixels", side));
      }
    }
    lens.size = {static_cast<int>(size[0]), static_cast<int>(size[1])};
    const auto focal_length = numbers<2>("focal_length", 1.0, 1e6);
    lens.fx = focal_length[0];
    lens.fy = focal_length[1];
    const auto centre = numbers<2>("centre", -kLargestSide, 2.0 * kLargestSide);
    lens.cx = centre[0];
    lens.cy = centre[1];
    lens.distortion = numbers<5>("distortion", -1e3, 1e3);
    lens.error = number(node_of("error"), "error", 0.0, 1e3);
    return lens;
  }

 private:
  [[nodiscard]] SourceLocation place(const toml::source_region& region) const {
    return {file_, static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
  }

  [[nodiscard]] const toml::node& node_of(const char* key) const {
    const toml::node* node = table_.get(key);
    if (node == nullptr) {
      throw ConfigError({file_},
                        fmt::format("has no '{}', expected one: is it a calibration?", key));
    }
    return *node;
  }

  [[nodiscard]] double number(const toml::node& node, const char* key, double low,
                              double high) const {
    const auto value = node.is_number() ? node.value<double>() : std::nullopt;
    if (!value) {
      throw ConfigError(place(node.source()), fmt::format("expected a number in '{}'", key));
    }
    if (!(*value >= low && *value <= high)) {
      throw ConfigError(place(node.source()),
                        fmt::format("found {} in '{}', expected {} to {}", *value, key, low, high));
    }
    return *value;
  }

  template <std::size_t N>
  [[nodiscard]] std::array<double, N> numbers(const char* key, double low, double high) const {
    const toml::node& node = node_of(key);
    const toml::array* list = node.as_array();
    if (list == nullptr || list->size() != N) {
      throw ConfigError(place(node.source()),
                        fmt::format("expected '{}' to be a list of {} numbers", key, N));
    }
    std::array<double, N> values{};
    for (std::size_t i = 0; i < N; ++i) values[i] = number(*list->get(i), key, low, high);
    return values;
  }

  const toml::table& table_;
  const std::string& file_;
};

/// toml++ 3.3 runs into undefined behaviour at certain characters beyond ASCII outside of quotes; a
/// calibration has no use for any.
void refuse_beyond_ascii(std::string_view text, const std::string& file) {
  int line = 1;
  int column = 1;
  for (const char c : text) {
    if (static_cast<unsigned char>(c) >= 0x80) {
      throw ConfigError({file, line, column}, "found a character beyond ASCII, expected none");
    }
    column = c == '\n' ? 1 : column + 1;
    line += c == '\n' ? 1 : 0;
  }
}

}  // namespace

Calibration parse_calibration(std::string_view text, const std::string& file) {
  if (is_yaml_calibration(text)) return parse_yaml_calibration(text, file);
  refuse_beyond_ascii(text, file);
  check_table_names(text, file);
  toml::table table;
  try {
    table = toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    const auto& at = error.source().begin;
    throw ConfigError({file, static_cast<int>(at.line), static_cast<int>(at.column)},
                      std::string(error.description()));
  }
  return CalibrationReader(table, file).read();
}

Calibration read_calibration(const fs::path& path) {
  const auto text = read_file(path, kLargestFile);
  if (!text) throw ConfigError({path.string()}, text.error().what + ": expected a calibration");
  return parse_calibration(*text, path.string());
}

std::string to_toml(const Calibration& lens) {
  const auto& [k1, k2, p1, p2, k3] = lens.distortion;
  return fmt::format(
      "# How a camera's lens maps rays to pixels. Written by `eyebridge camera calibrate`; use it "
      "with\n# --camera SOURCE?calibration=THIS_FILE.\n\n"
      "size = [{}, {}]  # of the pictures, pixels\n"
      "focal_length = [{}, {}]  # pixels\n"
      "centre = [{}, {}]  # pixels; (0, 0) is the middle of the top left one\n"
      "distortion = [{}, {}, {}, {}, {}]  # k1, k2, p1, p2, k3\n"
      "error = {}  # root mean square, pixels\n",
      lens.size.width, lens.size.height, lens.fx, lens.fy, lens.cx, lens.cy, k1, k2, p1, p2, k3,
      lens.error);
}

void check_calibration_place(const fs::path& path) {
  const std::string text = to_toml({});
  check_replaceable(path, "calibration", text.substr(0, text.find('\n')));
}

void write_calibration(const Calibration& calibration, const fs::path& path) {
  if (const auto done = write_file(path, to_toml(calibration)); !done) {
    throw std::runtime_error(path.string() + ": " + done.error().what);
  }
}

}  // namespace eyebridge::camera
