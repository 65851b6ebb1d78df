#include "v4l2/nodes.hpp"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <fstream>

#include <linux/videodev2.h>

#include "v4l2/offers.hpp"
#include "v4l2/open_errors.hpp"

namespace eyebridge::camera {
namespace {

namespace fs = std::filesystem;

constexpr const char* kById = "/dev/v4l/by-id";
constexpr const char* kByPath = "/dev/v4l/by-path";

fs::path below(const fs::path& root, const std::string& path) {
  return root / fs::path(path).relative_path();
}

std::string first_line(const fs::path& file) {
  std::string line;
  std::getline(std::ifstream(file), line);
  return line;
}

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> out;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    out.push_back(entry->path().filename());
  }
  std::ranges::sort(out);
  return out;
}

/// The number of "video12"; -1 for other names.
int number_of(std::string_view name) {
  constexpr std::string_view kPrefix = "video";
  if (!name.starts_with(kPrefix)) return -1;
  name.remove_prefix(kPrefix.size());
  int number = -1;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  return error == std::errc() && end == name.data() + name.size() ? number : -1;
}

/// What udev found out when the device was plugged in: ID_V4L_CAPABILITIES=:capture:.
DeviceKind kind_by_udev(const fs::path& sys, const fs::path& root) {
  std::ifstream data(below(root, "/run/udev/data") / ("c" + first_line(sys / "dev")));
  for (std::string line; std::getline(data, line);) {
    if (!line.starts_with("E:ID_V4L_CAPABILITIES=")) continue;
    if (line.find(":capture:") != std::string::npos) return DeviceKind::Camera;
    return line.ends_with("=:") ? DeviceKind::Metadata : DeviceKind::Other;
  }
  return DeviceKind::Unknown;
}

std::string link_to(const char* folder, const std::string& name, const fs::path& root) {
  for (const std::string& link : names_in(below(root, folder))) {
    std::error_code error;
    const fs::path target = fs::read_symlink(below(root, folder) / link, error);
    if (!error && target.filename() == name) return std::string(folder) + "/" + link;
  }
  return "";
}

std::string text_of(const __u8* text, std::size_t size) {
  const auto* letters = reinterpret_cast<const char*>(text);
  return {letters, ::strnlen(letters, size)};
}

}  // namespace

Identity identity_of(const VideoHandle& device) {
  v4l2_capability found{};
  if (device.control(VIDIOC_QUERYCAP, found) < 0) return {};
  const std::uint32_t has =
      (found.capabilities & V4L2_CAP_DEVICE_CAPS) != 0 ? found.device_caps : found.capabilities;
  Identity out;
  out.kind = (has & V4L2_CAP_VIDEO_CAPTURE) != 0  ? DeviceKind::Camera
             : (has & V4L2_CAP_META_CAPTURE) != 0 ? DeviceKind::Metadata
                                                  : DeviceKind::Other;
  out.streams = (has & V4L2_CAP_STREAMING) != 0;
  out.card = text_of(found.card, sizeof found.card);
  out.bus = text_of(found.bus_info, sizeof found.bus_info);
  return out;
}

std::vector<CameraDevice> list_cameras(VideoCalls& calls, const fs::path& root) {
  std::vector<std::string> names = names_in(below(root, "/dev"));
  std::erase_if(names, [](const std::string& name) { return number_of(name) < 0; });
  std::ranges::sort(names, {}, number_of);
  std::vector<CameraDevice> out;
  for (const std::string& name : names) {
    CameraDevice device;
    device.path = "/dev/" + name;
    device.by_id = link_to(kById, name, root);
    const fs::path sys = below(root, "/sys/class/video4linux") / name;
    device.card = first_line(sys / "name");
    std::error_code error;
    const fs::path parent = fs::canonical(sys / "device", error);
    if (!error) device.parent = parent;
    const VideoHandle handle(calls, below(root, device.path));
    device.error = handle.error();
    if (device.error == 0) {
      const Identity identity = identity_of(handle);
      device.kind = identity.kind;
      if (!identity.card.empty()) device.card = identity.card;
      if (device.kind == DeviceKind::Camera) device.formats = offers_of(handle);
    }
    if (device.kind == DeviceKind::Unknown) device.kind = kind_by_udev(sys, root);
    out.push_back(std::move(device));
  }
  return out;
}

std::vector<CameraDevice> list_cameras(const fs::path& root) {
  return list_cameras(system_video_calls(), root);
}

std::string path_of(const std::string& name, const fs::path& root) {
  if (name.find('/') != std::string::npos) return name;
  std::error_code error;
  for (const char* folder : {kById, kByPath, "/dev"}) {
    const fs::path path = fs::path(folder) / name;
    if (fs::exists(below(root, path), error)) return path;
  }
  std::string known;
  for (const std::string& link : names_in(below(root, kById))) {
    known += (known.empty() ? "; there are " : ", ") + link;
  }
  throw camera_error(name, "there is no such camera in " + std::string(kById) + known);
}

std::string lasting_name(const std::string& path, const fs::path& root) {
  if (path.starts_with("/dev/v4l/")) return path;
  const std::string link = link_to(kById, fs::path(path).filename(), root);
  return link.empty() ? path : link;
}

}  // namespace eyebridge::camera
