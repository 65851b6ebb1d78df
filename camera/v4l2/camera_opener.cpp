#include "v4l2/camera_opener.hpp"

#include <algorithm>

#include "v4l2/controls.hpp"
#include "v4l2/mode.hpp"
#include "v4l2/offers.hpp"
#include "v4l2/open_errors.hpp"

namespace eyebridge::camera {
namespace {

bool any_is_read(const std::vector<OfferedFormat>& offers) {
  return std::ranges::any_of(offers, &OfferedFormat::is_read);
}

/// Throws the error of opening, if there is one.
VideoHandle opened(VideoHandle handle) {
  if (handle.error() != 0) throw open_error(handle.path(), handle.error());
  return handle;
}

}  // namespace

CameraOpener::CameraOpener(VideoCalls& calls, CameraUrl wanted, std::filesystem::path root,
                           LogSink& log)
    : calls_(calls), wanted_(std::move(wanted)), root_(std::move(root)), log_(log) {}

std::string CameraOpener::on_disk(const std::string& path) const {
  return root_ / std::filesystem::path(path).relative_path();
}

std::string CameraOpener::first_camera() const {
  const std::vector<CameraDevice> devices = list_cameras(calls_, root_);
  const auto first = std::ranges::find(devices, DeviceKind::Camera, &CameraDevice::kind);
  if (first != devices.end()) return first->path;
  std::string found;
  for (const CameraDevice& device : devices) {
    if (device.error != 0) throw open_error(on_disk(device.path), device.error);
    found += (found.empty() ? "" : ", ") + device.path;
  }
  throw camera_error("v4l2", found.empty() ? "there is no camera (no /dev/video*): plug one in"
                                           : "there is no camera, only devices that give no "
                                             "pictures: " +
                                                 found);
}

void CameraOpener::check(const VideoHandle& handle, const Identity& identity) const {
  if (identity.kind == DeviceKind::Camera && identity.streams) return;
  if (identity.kind == DeviceKind::Camera) {
    throw camera_error(handle.path(), "it does not stream into memory (V4L2_CAP_STREAMING)");
  }
  if (identity.kind == DeviceKind::Unknown) {
    throw camera_error(handle.path(), "it is no V4L2 device, expected a camera");
  }
  // A USB camera comes with a second node for its metadata, which is easily taken for it.
  const std::vector<CameraDevice> devices = list_cameras(calls_, root_);
  const auto self = std::ranges::find_if(
      devices, [&](const CameraDevice& d) { return on_disk(d.path) == handle.path(); });
  std::string text = identity.kind == DeviceKind::Metadata
                         ? "it gives a camera's metadata, no pictures"
                         : "it is no camera (it does not capture)";
  if (self != devices.end() && !self->parent.empty()) {
    for (const CameraDevice& device : devices) {
      if (device.kind != DeviceKind::Camera || device.parent != self->parent) continue;
      text += "; its camera is " + device.path;
      break;
    }
  }
  throw camera_error(handle.path(), text);
}

std::unique_ptr<CaptureStream> CameraOpener::start(VideoHandle handle, const Mode& mode,
                                                   bool rate_matters) {
  mode_ = set_mode(handle, mode, rate_matters);
  set_controls(handle, wanted_.controls);
  auto stream = std::make_unique<CaptureStream>(std::move(handle), mode_);
  return stream;
}

std::unique_ptr<CaptureStream> CameraOpener::open() {
  const std::string path = wanted_.device.empty() ? first_camera() : path_of(wanted_.device, root_);
  VideoHandle handle = opened(VideoHandle(calls_, on_disk(path)));
  const Identity identity = identity_of(handle);
  check(handle, identity);
  card_ = identity.card;
  name_ = lasting_name(path, root_);
  const std::vector<OfferedFormat> offers = offers_of(handle);
  converting_ = !any_is_read(offers);
  if (!converting_) {
    const Mode mode = choose_mode(handle, offers, wanted_);
    return start(std::move(handle), mode, wanted_.fps.has_value());
  }
  // libv4l knows what a few odd cameras send (Bayer, vendors' own compressions).
  handle.close();
  VideoHandle converted = opened(VideoHandle(calls_, on_disk(path), true));
  std::vector<OfferedFormat> made = offers_of(converted);
  std::erase_if(made,
                [](const OfferedFormat& offer) { return offer.fourcc != V4L2_PIX_FMT_RGB24; });
  if (made.empty()) {
    throw camera_error(converted.path(), "it offers " + listed_formats(offers) +
                                             ", which libv4l cannot convert; expected " +
                                             kRawFormatNames);
  }
  const Mode mode = choose_mode(converted, made, wanted_);
  log_.write(Severity::Info, "camera " + name_ + ": it offers " + listed_formats(offers) +
                                 "; libv4l makes RGB24 of it");
  return start(std::move(converted), mode, wanted_.fps.has_value());
}

std::unique_ptr<CaptureStream> CameraOpener::open_again() {
  VideoHandle handle = opened(VideoHandle(calls_, on_disk(name_), converting_));
  const Identity identity = identity_of(handle);
  check(handle, identity);
  // Without a lasting name another camera may have got the number.
  if (identity.card != card_) {
    throw camera_error(handle.path(), "it is another camera now (" + identity.card + ")");
  }
  return start(std::move(handle), mode_, false);
}

}  // namespace eyebridge::camera
