#include "fake_video.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace eyebridge::camera::testing {
namespace {

namespace fs = std::filesystem;

template <class Argument>
Argument& as(void* argument) {
  return *static_cast<Argument*>(argument);
}

template <std::size_t kSize>
void copy(const std::string& text, __u8 (&to)[kSize]) {
  std::memcpy(to, text.data(), std::min(text.size(), kSize - 1));
}

const FakeFormat* find(const std::vector<FakeFormat>& formats, std::uint32_t fourcc) {
  const auto found = std::ranges::find(formats, fourcc, &FakeFormat::fourcc);
  return found == formats.end() ? nullptr : &*found;
}

std::size_t bytes_of(const v4l2_pix_format& pix) {
  const std::size_t pixels = std::size_t{pix.width} * pix.height;
  return pix.pixelformat == V4L2_PIX_FMT_GREY ? pixels : 3 * pixels;
}

Time interval(double fps) { return from_seconds(1.0 / fps); }

}  // namespace

FakeCamera& FakeVideo::add(const std::string& name, FakeCamera camera) {
  const fs::path node = fs::path(root()) / "dev" / name;
  fs::create_directories(node.parent_path());
  std::ofstream(node).close();
  return cameras_[fs::canonical(node)] = std::move(camera);
}

void FakeVideo::link(const std::string& by_id, const std::string& name) const {
  const fs::path folder = fs::path(root()) / "dev/v4l/by-id";
  fs::create_directories(folder);
  fs::create_symlink("../../" + name, folder / by_id);
}

void FakeVideo::unlink(const std::string& by_id) const {
  fs::remove(fs::path(root()) / "dev/v4l/by-id" / by_id);
}

void FakeVideo::add_sys(const std::string& name, const std::string& device) const {
  const fs::path sys = fs::path(root()) / "sys/class/video4linux" / name;
  fs::create_directories(sys);
  const fs::path parent = fs::path(root()) / "sys/devices" / device;
  fs::create_directories(parent);
  fs::create_directory_symlink(parent, sys / "device");
}

void FakeVideo::pass(Time time) {
  const Time until = now_ + std::max(time, Time(0));
  for (auto& [number, open] : open_) {
    if (!open.streaming) continue;
    const FakeCamera& camera = *open.camera;
    const bool silent = camera.is_silent || camera.starts <= camera.restarts_to_speak;
    for (; open.next <= until; open.next += interval(camera.fps)) {
      if (!camera.is_gone && !silent) shoot(open, open.next);
    }
  }
  now_ = until;
}

void FakeVideo::shoot(Open& open, Time at) const {
  const FakeCamera& camera = *open.camera;
  const std::uint32_t sequence = open.sequence++;
  if (open.queued.empty()) return;
  v4l2_buffer buffer{};
  buffer.index = open.queued.front();
  open.queued.pop_front();
  Bytes& memory = open.memory[buffer.index];
  const Bytes picture =
      camera.picture ? camera.picture(sequence)
                     : Bytes(bytes_of(camera.format.fmt.pix), static_cast<std::uint8_t>(sequence));
  const std::size_t size = std::min(picture.size(), memory.size());
  std::memcpy(memory.data(), picture.data(), size);
  buffer.bytesused = static_cast<std::uint32_t>(size);
  buffer.flags = camera.marks_damaged ? V4L2_BUF_FLAG_ERROR : 0;
  if (camera.counts) {
    buffer.sequence = sequence;
    buffer.flags |= V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC;
    const Time stamp = at - now_ + monotonic();
    buffer.timestamp.tv_sec = stamp.count() / 1'000'000'000;
    buffer.timestamp.tv_usec = stamp.count() % 1'000'000'000 / 1000;
  }
  open.done.push_back(buffer);
}

int FakeVideo::open_devices() const { return static_cast<int>(open_.size()); }

int FakeVideo::open(const std::string& path, bool converting) {
  std::error_code error;
  const auto found = cameras_.find(fs::weakly_canonical(path, error));
  if (found == cameras_.end()) return -ENOENT;
  FakeCamera& camera = found->second;
  if (camera.is_gone) return -ENODEV;
  if (camera.open_fails != 0) return -camera.open_fails;
  Open& open = open_[++last_];
  open.camera = &camera;
  open.converting = converting;
  return last_;
}

void FakeVideo::close(int device) { open_.erase(device); }

std::uint8_t* FakeVideo::map(int device, std::size_t, std::int64_t offset) {
  ++mappings_;
  return open_.at(device).memory.at(static_cast<std::size_t>(offset)).data();
}

void FakeVideo::unmap(std::uint8_t*, std::size_t) { --mappings_; }

int FakeVideo::wait(int device, Time timeout) {
  const Time until = now_ + std::max(timeout, Time(0));
  if (device < 0) {
    pass(until - now_);
    return 0;
  }
  Open& open = open_.at(device);
  if (open.camera->is_gone || !open.streaming) return -EIO;
  while (open.done.empty() && now_ < until) {
    pass(std::min(until, std::max(open.next, now_ + Time(1))) - now_);
  }
  return open.done.empty() ? 0 : 1;
}

int FakeVideo::control(int device, unsigned long request, void* argument) {
  Open& open = open_.at(device);
  if (open.camera->is_gone) return -ENODEV;
  if (const auto fails = open.camera->fails.find(request); fails != open.camera->fails.end()) {
    return -fails->second;
  }
  return answer(open, request, argument);
}

int FakeVideo::answer(Open& open, unsigned long request, void* argument) {
  FakeCamera& camera = *open.camera;
  switch (request) {
    case VIDIOC_QUERY_EXT_CTRL: {
      auto& control = as<v4l2_query_ext_ctrl>(argument);
      const std::uint32_t index = control.id & 0xFFFFU;  // ids count from 1
      if (index >= camera.controls.size()) return -EINVAL;
      const FakeControl& from = camera.controls[index];
      control = {};
      control.id = index + 1;
      control.type = from.type;
      std::memcpy(control.name, from.name.data(), std::min<std::size_t>(from.name.size(), 31));
      control.minimum = from.least;
      control.maximum = from.most;
      control.flags = from.flags;
      return 0;
    }
    case VIDIOC_QUERYMENU: {
      auto& item = as<v4l2_querymenu>(argument);
      const FakeControl& control = camera.controls.at(item.id - 1);
      if (item.index >= control.items.size() || control.items[item.index].empty()) return -EINVAL;
      std::memcpy(item.name, control.items[item.index].data(), control.items[item.index].size());
      return 0;
    }
    case VIDIOC_S_EXT_CTRLS: {
      const v4l2_ext_control& one = *as<v4l2_ext_controls>(argument).controls;
      FakeControl& control = camera.controls.at(one.id - 1);
      control.value = one.value;
      camera.set_controls.push_back(control.name + "=" + std::to_string(one.value));
      return 0;
    }
    default:
      return describe(open, request, argument);
  }
}

int FakeVideo::describe(Open& open, unsigned long request, void* argument) {
  FakeCamera& camera = *open.camera;
  switch (request) {
    case VIDIOC_QUERYCAP: {
      auto& capability = as<v4l2_capability>(argument);
      copy(camera.card, capability.card);
      capability.capabilities = V4L2_CAP_DEVICE_CAPS;
      capability.device_caps = camera.can;
      return 0;
    }
    case VIDIOC_ENUM_FMT: {
      auto& format = as<v4l2_fmtdesc>(argument);
      if (format.index >= formats(open).size()) return -EINVAL;
      format.pixelformat = formats(open)[format.index].fourcc;
      return 0;
    }
    case VIDIOC_ENUM_FRAMESIZES: {
      auto& size = as<v4l2_frmsizeenum>(argument);
      const FakeFormat* format = find(formats(open), size.pixel_format);
      if (format == nullptr || size.index >= format->sizes.size()) return -EINVAL;
      size.type = V4L2_FRMSIZE_TYPE_DISCRETE;
      size.discrete.width = static_cast<std::uint32_t>(format->sizes[size.index].first);
      size.discrete.height = static_cast<std::uint32_t>(format->sizes[size.index].second);
      return 0;
    }
    case VIDIOC_ENUM_FRAMEINTERVALS: {
      auto& rate = as<v4l2_frmivalenum>(argument);
      const FakeFormat* format = find(formats(open), rate.pixel_format);
      if (format == nullptr || rate.index >= format->rates.size()) return -EINVAL;
      rate.type = V4L2_FRMIVAL_TYPE_DISCRETE;
      rate.discrete = {1000, static_cast<std::uint32_t>(1000 * format->rates[rate.index])};
      return 0;
    }
    case VIDIOC_S_FMT: {
      auto& format = as<v4l2_format>(argument);
      format.fmt.pix.bytesperline = 0;
      camera.format = format;
      return 0;
    }
    case VIDIOC_G_PARM:
    case VIDIOC_S_PARM: {
      auto& capture = as<v4l2_streamparm>(argument).parm.capture;
      if (request == VIDIOC_S_PARM) {
        camera.fps = static_cast<double>(capture.timeperframe.denominator) /
                     static_cast<double>(capture.timeperframe.numerator);
      }
      capture.capability = V4L2_CAP_TIMEPERFRAME;
      capture.timeperframe = {1000, static_cast<std::uint32_t>(std::lround(1000 * camera.fps))};
      return 0;
    }
    default:
      return stream(open, request, argument);
  }
}

int FakeVideo::stream(Open& open, unsigned long request, void* argument) {
  switch (request) {
    case VIDIOC_REQBUFS:
      open.memory.assign(as<v4l2_requestbuffers>(argument).count,
                         Bytes(bytes_of(open.camera->format.fmt.pix)));
      return 0;
    case VIDIOC_QUERYBUF: {
      auto& buffer = as<v4l2_buffer>(argument);
      buffer.length = static_cast<std::uint32_t>(open.memory.at(buffer.index).size());
      buffer.m.offset = buffer.index;
      return 0;
    }
    case VIDIOC_QBUF:
      open.queued.push_back(as<v4l2_buffer>(argument).index);
      return 0;
    case VIDIOC_STREAMON:
      open.streaming = true;
      ++open.camera->starts;
      open.sequence = 0;
      open.next = now_ + interval(open.camera->fps);
      return 0;
    case VIDIOC_STREAMOFF:
      open.streaming = false;
      open.queued.clear();
      open.done.clear();
      return 0;
    case VIDIOC_DQBUF:
      if (open.done.empty()) return -EAGAIN;
      as<v4l2_buffer>(argument) = open.done.front();
      open.done.pop_front();
      return 0;
    default:
      return -ENOTTY;
  }
}

}  // namespace eyebridge::camera::testing
