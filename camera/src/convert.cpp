#include "eyebridge/camera/convert.hpp"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace eyebridge::camera {
namespace {

std::uint8_t* row_of(Frame& frame, int y) {
  return frame.bytes.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.stride);
}

/// The same picture in another format: `convert(in, out)` handles one pixel.
template <class Convert>
Frame converted(const Frame& from, PixelFormat format, Convert convert) {
  Frame to = make_frame(from.width, from.height, format);
  to.time = from.time;
  to.sequence = from.sequence;
  const int in_step = bytes_per_pixel(from.format);
  const int out_step = bytes_per_pixel(format);
  for (int y = 0; y < from.height; ++y) {
    const std::uint8_t* in = from.row(y).data();
    std::uint8_t* out = row_of(to, y);
    for (int x = 0; x < from.width; ++x, in += in_step, out += out_step) convert(in, out);
  }
  return to;
}

struct Span {
  int begin;
  int end;
};

/// The source pixels under pixel `at` of `count` that are spread over `length` from `start` on.
Span box(int at, int count, int start, int length) {
  const auto edge = [&](int i) {
    return start + static_cast<int>(static_cast<long long>(i) * length / count);
  };
  const int begin = edge(at);
  return {begin, std::max(begin + 1, edge(at + 1))};
}

}  // namespace

Frame make_frame(int width, int height, PixelFormat format) {
  assert(width > 0 && height > 0);
  Frame frame;
  frame.width = width;
  frame.height = height;
  frame.format = format;
  frame.stride = width * bytes_per_pixel(format);
  frame.bytes.resize(static_cast<std::size_t>(frame.stride) * static_cast<std::size_t>(height));
  return frame;
}

Frame to_rgb24(const Frame& frame) {
  switch (frame.format) {
    case PixelFormat::Rgb24:
      return frame;
    case PixelFormat::Bgra32:
      return converted(frame, PixelFormat::Rgb24, [](const std::uint8_t* in, std::uint8_t* out) {
        out[0] = in[2];
        out[1] = in[1];
        out[2] = in[0];
      });
    case PixelFormat::Grey8:
      break;
  }
  return converted(frame, PixelFormat::Rgb24, [](const std::uint8_t* in, std::uint8_t* out) {
    out[0] = out[1] = out[2] = *in;
  });
}

Frame to_grey8(const Frame& frame) {
  if (frame.format == PixelFormat::Grey8) return frame;
  // The order of red and blue does not matter to a mean.
  return converted(frame, PixelFormat::Grey8, [](const std::uint8_t* in, std::uint8_t* out) {
    *out = static_cast<std::uint8_t>((in[0] + in[1] + in[2]) / 3);
  });
}

Frame fit(const Frame& frame, int width, int height) {
  if (frame.width == width && frame.height == height) return frame;
  int cut_width = frame.width;
  int cut_height = frame.height;
  if (static_cast<long long>(frame.width) * height > static_cast<long long>(frame.height) * width) {
    cut_width =
        std::max(1, static_cast<int>(static_cast<long long>(frame.height) * width / height));
  } else {
    cut_height =
        std::max(1, static_cast<int>(static_cast<long long>(frame.width) * height / width));
  }
  const int left = (frame.width - cut_width) / 2;
  const int top = (frame.height - cut_height) / 2;

  Frame to = make_frame(width, height, frame.format);
  to.time = frame.time;
  to.sequence = frame.sequence;
  const int channels = bytes_per_pixel(frame.format);
  for (int y = 0; y < height; ++y) {
    const Span rows = box(y, height, top, cut_height);
    std::uint8_t* out = row_of(to, y);
    for (int x = 0; x < width; ++x) {
      const Span columns = box(x, width, left, cut_width);
      const int count = (rows.end - rows.begin) * (columns.end - columns.begin);
      for (int c = 0; c < channels; ++c) {
        int sum = 0;
        for (int v = rows.begin; v < rows.end; ++v) {
          const std::uint8_t* in = frame.row(v).data();
          for (int u = columns.begin; u < columns.end; ++u) sum += in[u * channels + c];
        }
        *out++ = static_cast<std::uint8_t>((sum + count / 2) / count);
      }
    }
  }
  return to;
}

}  // namespace eyebridge::camera
