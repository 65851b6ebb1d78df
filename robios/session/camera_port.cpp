#include "camera_port.hpp"

#include "program_threads.hpp"

namespace eyebridge::robios {
namespace {

// A camera that gives no frame for this long is lost.
constexpr Time kPatience = std::chrono::seconds(2);

}  // namespace

CameraPort::CameraPort(std::string url, camera::SourceContext context, camera::Source* given)
    : url_(std::move(url)), context_(context), given_(given) {}

CameraPort::~CameraPort() = default;

Result<void> CameraPort::init(int width, int height) {
  const std::unique_lock lock = lock_in_turn(mutex_);
  if (url_ == "none") {
    return fail(Errc::NoDevice, "this robot has no camera (--camera none)");
  }
  if (given_ == nullptr && !opened_) opened_ = camera::open_source(url_, context_);
  source_ = given_ != nullptr ? given_ : opened_.get();
  open_ = false;
  if (Result<void> sized = source_->set_size(width, height); !sized) return sized;
  open_ = true;
  return {};
}

void CameraPort::release() {
  const std::unique_lock lock = lock_in_turn(mutex_);
  opened_.reset();
  source_ = nullptr;
  open_ = false;
}

bool CameraPort::is_open() const {
  const std::unique_lock lock = lock_in_turn(mutex_);
  return open_;
}

Result<camera::FramePtr> CameraPort::next() {
  const std::unique_lock lock = lock_in_turn(mutex_);
  if (!open_) return fail(Errc::Unsupported, "the camera is not initialised: call CAMInit first");
  Result<camera::FramePtr> frame = source_->next(context_.clock->now() + kPatience);
  if (frame && listener_) listener_(*frame);
  return frame;
}

void CameraPort::on_frame(std::function<void(const camera::FramePtr&)> listener) {
  const std::unique_lock lock = lock_in_turn(mutex_);
  listener_ = std::move(listener);
}

}  // namespace eyebridge::robios
