#include "sources/undistorted_source.hpp"

#include <cstdlib>

#include <fmt/format.h>

#include "eyebridge/base/config_error.hpp"
#include "optics/undistortion.hpp"

namespace eyebridge::camera {
namespace {

/// Within 1 %: cameras round their smaller sizes to whole blocks.
bool has_aspect_of(Size a, Size b) {
  const double one = static_cast<double>(a.width) * b.height;
  const double other = static_cast<double>(a.height) * b.width;
  return std::abs(one - other) <= 0.01 * other;
}

class UndistortedSource final : public Source {
 public:
  UndistortedSource(std::unique_ptr<Source> inner, const Calibration& lens, std::string file)
      : inner_(std::move(inner)), lens_(lens), file_(std::move(file)) {}

  Result<void> set_size(int width, int height) override {
    Result<void> set = inner_->set_size(width, height);
    if (!set) return set;
    // Of a camera that gives what is asked for, the aspect shows only now.
    const std::string wrong = mismatch();
    return wrong.empty() ? set : fail(Errc::Unsupported, wrong);
  }

  [[nodiscard]] Size natural_size() const override { return inner_->natural_size(); }

  Result<FramePtr> next(Time deadline) override {
    Result<FramePtr> frame = inner_->next(deadline);
    if (!frame || lens_.distortion == std::array<double, 5>{}) return frame;
    const Size size{(*frame)->width, (*frame)->height};
    if (!undistortion_ || size != size_) {
      undistortion_.emplace(scaled(lens_, size));
      size_ = size;
    }
    return std::make_shared<const Frame>(undistortion_->apply(**frame));
  }

  /// What is wrong with the present aspect; empty when nothing is.
  [[nodiscard]] std::string mismatch() const {
    const Size natural = natural_size();
    if (has_aspect_of(natural, lens_.size)) return "";
    return fmt::format(
        "calibration {} is for pictures of {}x{}, the camera's are {}x{}: expected "
        "the same aspect",
        file_, lens_.size.width, lens_.size.height, natural.width, natural.height);
  }

 private:
  std::unique_ptr<Source> inner_;
  const Calibration lens_;
  const std::string file_;
  std::optional<Undistortion> undistortion_;  ///< For frames of size_.
  Size size_;
};

}  // namespace

std::unique_ptr<Source> undistort(std::unique_ptr<Source> inner, const std::string& file) {
  auto source = std::make_unique<UndistortedSource>(std::move(inner), read_calibration(file), file);
  const std::string wrong = source->mismatch();
  if (!wrong.empty()) throw ConfigError({"--camera"}, wrong);
  return source;
}

}  // namespace eyebridge::camera
