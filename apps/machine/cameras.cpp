#include "cameras.hpp"

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

#include "holders.hpp"

namespace eyebridge::apps {
namespace {

using camera::CameraDevice;
using camera::DeviceKind;

std::string name_of(const CameraDevice& device) {
  return device.path.substr(device.path.rfind('/') + 1);
}

const char* purpose(DeviceKind kind) {
  switch (kind) {
    case DeviceKind::Camera:
      return "camera";
    case DeviceKind::Metadata:
      return "metadata of a camera, no pictures";
    case DeviceKind::Other:
      return "gives no pictures";
    case DeviceKind::Unknown:
      break;
  }
  return "does not say what it is";
}

std::string card_of(const CameraDevice& device) {
  return device.card.empty() ? "without a name" : device.card;
}

/// The name that stays the same in a URL.
std::string lasting_name(const CameraDevice& device) {
  return device.by_id.empty() ? device.path : device.by_id.substr(device.by_id.rfind('/') + 1);
}

std::string how_to_be_permitted(const Camera& camera) {
  return how_to_be_permitted(camera.access,
                             "only root may use it: a udev rule must give it to a group");
}

/// "30, 15 /s"; "" where the driver says nothing.
std::string rates_text(const std::vector<double>& rates) {
  std::string out;
  for (const double rate : rates) out += fmt::format("{}{:.4g}", out.empty() ? "" : ", ", rate);
  return out.empty() ? out : " at " + out + " /s";
}

std::string size_text(const camera::OfferedSize& size) {
  std::string least = fmt::format("{}x{}", size.least.width, size.least.height);
  if (!size.is_range()) return least;
  return fmt::format("{} to {}x{} in steps of {}x{}", least, size.most.width, size.most.height,
                     size.step.width, size.step.height);
}

/// One line for all sizes that have the same rates.
void add_format(std::string& out, const camera::OfferedFormat& format) {
  std::string label = format.name;
  if (format.sizes.empty()) out += fmt::format("    {:<7} any size\n", label);
  for (std::size_t i = 0; i < format.sizes.size();) {
    const std::vector<double>& rates = format.sizes[i].rates;
    std::string sizes;
    for (; i < format.sizes.size() && format.sizes[i].rates == rates; ++i) {
      sizes += (sizes.empty() ? "" : ", ") + size_text(format.sizes[i]);
    }
    out += fmt::format("    {:<7} {}{}\n", label, sizes, rates_text(rates));
    label.clear();
  }
}

void add_formats(std::string& out, const CameraDevice& device) {
  constexpr int kMost = 8;  // names of formats that are of no use here
  std::string others;
  int count = 0;
  for (const camera::OfferedFormat& format : device.formats) {
    if (format.is_read) {
      add_format(out, format);
    } else if (++count <= kMost) {
      others += (others.empty() ? "" : ", ") + format.name;
    }
  }
  if (count > kMost) others += fmt::format(" and {} more", count - kMost);
  if (!others.empty()) out += "    also    " + others + " (not used)\n";
}

std::string trouble_of(const Camera& camera) {
  if (!camera.access.permitted) return how_to_be_permitted(camera);
  if (camera.device.error != 0) {
    return fmt::format("cannot be opened: {} (errno {})", std::strerror(camera.device.error),
                       camera.device.error);
  }
  return "";
}

}  // namespace

std::vector<Camera> look_at_cameras(const std::filesystem::path& root) {
  std::vector<Camera> out;
  for (CameraDevice& device : camera::list_cameras(root)) {
    Camera camera;
    camera.access = access_of(device.path, root);
    camera.holders = holders_of(device.path, root);
    camera.device = std::move(device);
    out.push_back(std::move(camera));
  }
  return out;
}

std::vector<Finding> judge_cameras(const std::vector<Camera>& cameras) {
  constexpr const char* kWhat = "V4L2 cameras";
  if (cameras.empty()) return {{kWhat, false, false, "no /dev/video*", "plug one in"}};
  std::string names;
  std::vector<Finding> out = {{kWhat, false, false, "", ""}};
  for (const Camera& camera : cameras) {
    const CameraDevice& device = camera.device;
    const std::string trouble = trouble_of(camera);
    const bool gives_pictures =
        device.kind == DeviceKind::Camera || device.kind == DeviceKind::Unknown;
    Finding finding{"  " + name_of(device), false, gives_pictures && trouble.empty(), "", trouble};
    finding.detail = fmt::format("{}, {}", card_of(device), purpose(device.kind));
    if (device.kind == DeviceKind::Camera && !device.by_id.empty()) {
      finding.advice.push_back("stays the same when re-plugged: v4l2:" + lasting_name(device));
    }
    if (!camera.holders.empty()) {
      finding.advice.push_back("in use by " + listed(camera.holders) + ": end it first");
    }
    if (device.kind == DeviceKind::Camera) names += (names.empty() ? "" : " ") + device.path;
    out.push_back(std::move(finding));
  }
  out[0].found = !names.empty();
  out[0].detail = names.empty() ? "none of /dev/video* is known to be a camera" : names;
  if (out[0].found) out[0].advice.emplace_back("what they offer: eyebridge camera list");
  return out;
}

std::string table_of(const std::vector<Camera>& cameras) {
  std::string out;
  std::string first;
  for (const Camera& camera : cameras) {
    const CameraDevice& device = camera.device;
    out += fmt::format("{:<13} {}", device.path, card_of(device));
    if (device.kind != DeviceKind::Camera) out += fmt::format(": {}", purpose(device.kind));
    out += '\n';
    if (!device.by_id.empty()) out += "    " + lasting_name(device) + "\n";
    if (const std::string trouble = trouble_of(camera); !trouble.empty()) {
      out += "    " + trouble + "\n";
    }
    if (!camera.holders.empty()) out += "    in use by " + listed(camera.holders) + "\n";
    add_formats(out, device);
    if (first.empty() && device.kind == DeviceKind::Camera) first = lasting_name(device);
  }
  if (first.empty()) {
    if (cameras.empty()) return "Found no camera (no /dev/video*).\n";
    return out + "None of these is a camera.\n";
  }
  return out +
         fmt::format("A program with the first:  eyebridge run --camera v4l2:{} PROGRAM\n", first);
}

}  // namespace eyebridge::apps
