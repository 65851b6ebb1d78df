#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "eyebridge/base/result.hpp"
#include "eyebridge/camera/calibration.hpp"
#include "eyebridge/camera/frame.hpp"

namespace eyebridge::camera {

/// A flat board by whose pictures a lens is measured.
struct Board {
  enum class Kind {
    Chessboard,  ///< `columns` x `rows` inner corners, as OpenCV counts them.
    Charuco,  ///< `columns` x `rows` squares with fiducials in the white ones; may be seen in part.
  };
  Kind kind = Kind::Chessboard;
  int columns = 9;
  int rows = 6;
  double square = 0.025;  ///< Edge of a square, metres.

  friend bool operator==(const Board&, const Board&) = default;
};

/// Edge of the fiducials in the squares of a ChArUco board, in edges of the square.
inline constexpr double kCharucoFiducial = 0.75;

/// "chessboard:9x6" or "charuco:5x7". Throws ConfigError at "--board" for anything else, sizes
/// beyond 3 … 30, or a square beyond 1 mm … 1 m.
Board parse_board(std::string_view text, double square);

/// What a frame brought.
enum class BoardView {
  None,  ///< No board is in it.
  Same,  ///< As in a frame that was kept before.
  Kept,
};

/// Collects views of a board until a lens is known. One thread at a time.
class Calibrator {
 public:
  virtual ~Calibrator() = default;

  /// Looks for the board in a frame of any format, and keeps the view if it differs from all kept
  /// before: in place, distance or slant. Fails with Unsupported for another size than the first.
  virtual Result<BoardView> take(const Frame& frame) = 0;

  /// Views kept.
  [[nodiscard]] virtual int views() const = 0;
  /// The part of the picture that the corners of all views have reached, 0 … 1.
  [[nodiscard]] virtual double coverage() const = 0;

  /// The lens by all views (Zhang 2000, as OpenCV does it). Fails with Corrupt and the reason when
  /// they do not determine it: too few, too alike, or an error over 1 pixel.
  [[nodiscard]] virtual Result<Calibration> solve() const = 0;
};

/// Loads the vision library. Throws ConfigError.
std::unique_ptr<Calibrator> make_calibrator(const Board& board);

}  // namespace eyebridge::camera
