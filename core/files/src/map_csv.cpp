#include <algorithm>
#include <charconv>
#include <cmath>
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

/// Reads one grid from CSV.
class MapCsvReader {
 public:
  MapCsvReader(std::string_view text, const std::string& file)
      : rest_(without_bom(text)), file_(file) {
    check_text(rest_, file_);
  }

  mapping::OccupancyGrid read() {
    next_line("resolution,0.05");
    expect_key("resolution");
    mapping::GridGeometry g;
    g.resolution = number("the resolution", kLeastResolution, kMostResolution);
    expect_end();
    next_line("origin,0,0");
    expect_key("origin");
    g.origin.x = number("origin's x", -kMostOrigin, kMostOrigin);
    g.origin.y = number("origin's y", -kMostOrigin, kMostOrigin);
    expect_end();
    std::vector<double> cells;
    while (next_row()) {
      int columns = 0;
      do {
        if (cells.size() == mapping::kMostMapCells) {
          fail("more than " + std::to_string(mapping::kMostMapCells) + " cells");
        }
        cells.push_back(number("a probability", 0.0, 1.0));
        ++columns;
      } while (!at_end());
      if (g.rows > 0 && columns != g.columns) {
        throw ConfigError({file_, line_, 1}, "row of " + std::to_string(columns) +
                                                 " cells: expected " + std::to_string(g.columns) +
                                                 ", as in the first row");
      }
      g.columns = columns;
      ++g.rows;
    }
    if (g.rows == 0) {
      throw ConfigError({file_, line_ + 1, 1}, "file ends: expected a row of probabilities");
    }
    mapping::OccupancySettings settings;
    settings.max_cells = mapping::kMostMapCells;
    mapping::OccupancyGrid grid(g, settings);
    std::size_t i = 0;
    for (int row = g.rows - 1; row >= 0; --row) {
      for (int column = 0; column < g.columns; ++column) {
        grid.set_probability({column, row}, cells[i++]);
      }
    }
    return grid;
  }

 private:
  bool next_row() {
    while (!rest_.empty()) {
      const std::size_t end = std::min(rest_.find('\n'), rest_.size());
      row_ = rest_.substr(0, end);
      rest_.remove_prefix(std::min(end + 1, rest_.size()));
      if (row_.ends_with('\r')) row_.remove_suffix(1);
      ++line_;
      at_ = 0;
      if (!trimmed(row_).empty()) return true;
    }
    return false;
  }
  void next_line(const char* form) {
    if (next_row()) return;
    throw ConfigError({file_, line_ + 1, 1}, std::string("file ends: expected '") + form + "'");
  }
  [[nodiscard]] bool at_end() const { return at_ > row_.size(); }
  [[noreturn]] void fail(const std::string& text) const {
    throw ConfigError({file_, line_, static_cast<int>(std::min(at_, row_.size())) + 1}, text);
  }
  /// What stands before the next comma; the reader stays before it.
  [[nodiscard]] std::string_view field() const {
    const std::size_t end = std::min(row_.find(',', at_), row_.size());
    return trimmed(row_.substr(at_, end - at_));
  }
  void advance() { at_ = std::min(row_.find(',', at_), row_.size()) + 1; }

  void expect_key(const char* key) {
    if (field() != key) {
      fail(in_quotes(field()) + " found: expected '" + key + "'");
    }
    advance();
  }
  void expect_end() const {
    if (!at_end()) fail("more on the line than expected");
  }
  double number(const char* what, double low, double high) {
    if (at_end()) fail(std::string("line ends: expected ") + what);
    const std::string_view text = field();
    double value = 0.0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || error != std::errc{} || stop != text.data() + text.size() ||
        !std::isfinite(value)) {
      fail(in_quotes(text) + " found: expected " + what + ", a number");
    }
    if (value < low || value > high) {
      fail(std::string(what) + " is " + std::string(text.substr(0, 40)) + ": expected " +
           shown_bound(low) + " to " + shown_bound(high));
    }
    advance();
    return value + 0.0;  // no minus zero
  }
  static std::string shown_bound(double value) {
    char buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed);
    return {buffer, end.ptr};
  }

  std::string_view rest_;
  const std::string& file_;
  std::string_view row_;
  std::size_t at_ = 0;
  int line_ = 0;
};

}  // namespace

mapping::OccupancyGrid read_map_csv(std::string_view text, const std::string& file) {
  return MapCsvReader(text, file).read();
}

std::string write_map_csv(const mapping::OccupancyGrid& grid) {
  constexpr int kDecimals = 4;
  const mapping::GridGeometry& g = grid.geometry();
  need_readable(g);
  std::string out = "resolution," + decimal(g.resolution) + "\norigin," + decimal(g.origin.x) +
                    ',' + decimal(g.origin.y) + '\n';
  for (int row = g.rows - 1; row >= 0; --row) {
    for (int column = 0; column < g.columns; ++column) {
      char buffer[32];
      const auto end = std::to_chars(buffer, buffer + sizeof buffer,
                                     grid.probability(mapping::Cell{column, row}),
                                     std::chars_format::fixed, kDecimals);
      if (column > 0) out += ',';
      out.append(buffer, end.ptr);
    }
    out += '\n';
  }
  if (out.size() > kMaxFileSize) {
    throw ConfigError({}, "map of " + std::to_string(out.size()) +
                              " bytes as CSV: expected at most " + std::to_string(kMaxFileSize) +
                              ", or a .yaml with its picture");
  }
  return out;
}

void save_map_csv(const mapping::OccupancyGrid& grid, const std::filesystem::path& path) {
  write_bytes(path, write_map_csv(grid));
}

}  // namespace eyebridge::files
