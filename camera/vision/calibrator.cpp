#include "vision/calibrator.hpp"

#include <algorithm>
#include <bitset>

#include <fmt/format.h>
#include <opencv2/calib3d.hpp>

#include "vision/board_finder.hpp"
#include "vision/grey.hpp"

namespace eyebridge::camera {
namespace {

constexpr int kFewestViews = 6;
/// How far the outline of the board moves from one view to a new one, in picture widths.
constexpr double kNewView = 0.08;
constexpr double kLargestError = 1.0;       ///< Pixels.
constexpr double kLargestDeviation = 0.01;  ///< Of the focal length, relative.
constexpr double kSmallestCoverage = 0.4;
constexpr int kColumns = 8;
constexpr int kRows = 6;

class OpenCvCalibrator final : public Calibrator {
 public:
  explicit OpenCvCalibrator(const Board& board) : board_(board) {}

  Result<BoardView> take(const Frame& frame) override {
    const cv::Size size(frame.width, frame.height);
    if (size_.area() > 0 && size != size_) {
      return fail(Errc::Unsupported,
                  fmt::format("found a frame of {}x{} pixels, expected {}x{} like those before",
                              size.width, size.height, size_.width, size_.height));
    }
    const auto found = find_board(board_, grey_of(frame));
    if (!found) return BoardView::None;
    const cv::Mat shown = cv::findHomography(on_plane(found->on_board), found->pixels);
    if (shown.empty()) return BoardView::None;
    size_ = size;
    std::vector<cv::Point2f> outline;
    cv::perspectiveTransform(outline_of(board_), outline, shown);
    if (is_known(outline)) return BoardView::Same;
    outlines_.push_back(outline);
    on_board_.push_back(found->on_board);
    pixels_.push_back(found->pixels);
    for (const cv::Point2f& pixel : found->pixels) reach(pixel);
    return BoardView::Kept;
  }

  [[nodiscard]] int views() const override { return static_cast<int>(pixels_.size()); }

  [[nodiscard]] double coverage() const override {
    return static_cast<double>(reached_.count()) / static_cast<double>(reached_.size());
  }

  [[nodiscard]] Result<Calibration> solve() const override {
    if (views() < kFewestViews) {
      return fail(Errc::Corrupt, fmt::format("found {} different views of the board, expected at "
                                             "least {}",
                                             views(), kFewestViews));
    }
    if (coverage() < kSmallestCoverage) {
      return fail(Errc::Corrupt,
                  fmt::format("the board reached {:.0f} % of the picture, expected at least {:.0f} "
                              "%: hold it into the corners of the picture, too",
                              100.0 * coverage(), 100.0 * kSmallestCoverage));
    }
    cv::Mat camera;
    cv::Mat distortion;
    std::vector<cv::Mat> rotations;
    std::vector<cv::Mat> translations;
    cv::Mat deviations;
    double error = 0.0;
    try {
      // Without k3: a board held by hand does not determine it, and it spoils the corners.
      error = cv::calibrateCamera(on_board_, pixels_, size_, camera, distortion, rotations,
                                  translations, deviations, cv::noArray(), cv::noArray(),
                                  cv::CALIB_FIX_K3);
    } catch (const cv::Exception& wrong) {
      return fail(Errc::Corrupt, fmt::format("the views allow no calibration: {}", wrong.err));
    }
    const double focal_length = camera.at<double>(0, 0);
    const double deviation = deviations.at<double>(0) / focal_length;
    if (!(deviation < kLargestDeviation)) {
      return fail(
          Errc::Corrupt,
          fmt::format("the focal length is uncertain by {:.1f} %, expected less than {:.0f} "
                      "%: hold the board slanted, to all four sides",
                      100.0 * deviation, 100.0 * kLargestDeviation));
    }
    if (!(error < kLargestError)) {
      return fail(
          Errc::Corrupt,
          fmt::format("the corners miss by {:.2f} pixels, expected less than {:.0f}: is the "
                      "board flat, and of the size and kind given?",
                      error, kLargestError));
    }
    Calibration lens;
    lens.size = {size_.width, size_.height};
    lens.fx = focal_length;
    lens.fy = camera.at<double>(1, 1);
    lens.cx = camera.at<double>(0, 2);
    lens.cy = camera.at<double>(1, 2);
    for (int i = 0; i < 5; ++i) {
      lens.distortion[static_cast<std::size_t>(i)] = distortion.at<double>(i);
    }
    lens.error = error;
    return lens;
  }

 private:
  static std::vector<cv::Point2f> on_plane(const std::vector<cv::Point3f>& corners) {
    std::vector<cv::Point2f> plane;
    for (const cv::Point3f& corner : corners) plane.emplace_back(corner.x, corner.y);
    return plane;
  }

  /// A chessboard that was turned by half a turn is the same view.
  [[nodiscard]] bool is_known(const std::vector<cv::Point2f>& outline) const {
    return std::any_of(outlines_.begin(), outlines_.end(), [&](const auto& other) {
      double straight = 0.0;
      double turned = 0.0;
      for (std::size_t i = 0; i < 4; ++i) {
        straight = std::max(straight, cv::norm(outline[i] - other[i]));
        turned = std::max(turned, cv::norm(outline[i] - other[(i + 2) % 4]));
      }
      return std::min(straight, turned) < kNewView * size_.width;
    });
  }

  void reach(const cv::Point2f& pixel) {
    const int column = static_cast<int>(pixel.x * kColumns / static_cast<float>(size_.width));
    const int row = static_cast<int>(pixel.y * kRows / static_cast<float>(size_.height));
    if (column >= 0 && column < kColumns && row >= 0 && row < kRows) {
      reached_.set(static_cast<std::size_t>(row * kColumns + column));
    }
  }

  const Board board_;
  cv::Size size_;
  std::vector<std::vector<cv::Point2f>> outlines_;
  std::vector<std::vector<cv::Point3f>> on_board_;
  std::vector<std::vector<cv::Point2f>> pixels_;
  std::bitset<kColumns * kRows> reached_;
};

}  // namespace

std::unique_ptr<Calibrator> make_opencv_calibrator(const Board& board) {
  return std::make_unique<OpenCvCalibrator>(board);
}

}  // namespace eyebridge::camera
