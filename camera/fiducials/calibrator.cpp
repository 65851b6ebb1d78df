#include "eyebridge/camera/calibrator.hpp"

#include <charconv>
#include <optional>

#include <fmt/format.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/text.hpp"
#include "fiducials/vision.hpp"

namespace eyebridge::camera {
namespace {

constexpr int kFewestSquares = 3;
constexpr int kMostSquares = 30;

std::optional<int> number(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

Board parse_board(std::string_view text, double square) {
  const SourceLocation where{"--board"};
  const std::size_t colon = text.find(':');
  const std::string_view kind = text.substr(0, colon);
  const std::string_view size = colon == std::string_view::npos ? "" : text.substr(colon + 1);
  const std::size_t x = size.find('x');
  const auto columns = number(size.substr(0, x));
  const auto rows = x == std::string_view::npos ? std::nullopt : number(size.substr(x + 1));
  if ((kind != "chessboard" && kind != "charuco") || !columns || !rows) {
    throw ConfigError(where, fmt::format("found {}, expected chessboard:9x6 (inner corners) or "
                                         "charuco:5x7 (squares)",
                                         in_quotes(text)));
  }
  if (*columns < kFewestSquares || *columns > kMostSquares || *rows < kFewestSquares ||
      *rows > kMostSquares) {
    throw ConfigError(where, fmt::format("found {} x {}, expected {} to {} each", *columns, *rows,
                                         kFewestSquares, kMostSquares));
  }
  if (!(square >= 0.001 && square <= 1.0)) {
    throw ConfigError(
        where, fmt::format("found squares of {:g} mm, expected 1 mm to 1000 mm", square * 1000.0));
  }
  return {kind == "charuco" ? Board::Kind::Charuco : Board::Kind::Chessboard, *columns, *rows,
          square};
}

std::unique_ptr<Calibrator> make_calibrator(const Board& board) {
  return vision().make_calibrator(board);
}

}  // namespace eyebridge::camera
