#include "eyebridge/camera/convert.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <utility>
#include <vector>

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
  to.odd = from.odd;
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

/// The sums of the bytes that lie above each other in `rows`. A picture would need 2^24 rows to
/// overflow them.
void sum_rows(const Frame& frame, Span rows, std::vector<std::uint32_t>& sums) {
  const auto first = frame.row(rows.begin);
  sums.assign(first.begin(), first.end());
  for (int y = rows.begin + 1; y < rows.end; ++y) {
    const std::uint8_t* in = frame.row(y).data();
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += in[i];
  }
}

/// The rounded means of the boxes that `columns` cut out of `sums`, which are over `rows` rows.
/// `Sum` holds the sum of a box.
template <class Sum, int kChannels>
void mean_columns(const std::vector<std::uint32_t>& sums, const std::vector<Span>& columns,
                  int rows, std::uint8_t* out) {
  for (const Span& column : columns) {
    std::array<Sum, kChannels> box_sums{};
    const std::uint32_t* in = sums.data() + static_cast<std::ptrdiff_t>(column.begin) * kChannels;
    for (int u = column.begin; u < column.end; ++u) {
      for (std::size_t c = 0; c < kChannels; ++c) box_sums[c] += *in++;
    }
    const Sum count = static_cast<Sum>(rows) * static_cast<Sum>(column.end - column.begin);
    for (const Sum sum : box_sums) {
      *out++ = static_cast<std::uint8_t>((sum + count / 2) / count);
    }
  }
}

/// A row of means of boxes of four pixels, the usual case: two passes that compilers make vectors
/// of.
template <int kChannels>
void halve(const std::uint8_t* upper, const std::uint8_t* lower, int width,
           std::vector<std::uint16_t>& sums, std::uint8_t* out) {
  const std::size_t bytes = static_cast<std::size_t>(2 * width) * kChannels;
  sums.resize(bytes);
  std::uint16_t* const sum = sums.data();
  for (std::size_t i = 0; i < bytes; ++i) {
    sum[i] = static_cast<std::uint16_t>(upper[i] + lower[i] + 1);
  }
  const std::uint16_t* in = sum;
  for (int x = 0; x < width; ++x, in += 2 * kChannels) {
    for (int c = 0; c < kChannels; ++c) {
      *out++ = static_cast<std::uint8_t>((in[c] + in[c + kChannels]) / 4);
    }
  }
}

/// Fills `to` with the part of `frame` that lies in `cut_columns` and `cut_rows`.
template <int kChannels>
void scale(const Frame& frame, Span cut_columns, Span cut_rows, Frame& to) {
  const int cut_width = cut_columns.end - cut_columns.begin;
  const int cut_height = cut_rows.end - cut_rows.begin;
  std::vector<Span> columns(static_cast<std::size_t>(to.width));
  for (int x = 0; x < to.width; ++x) {
    columns[static_cast<std::size_t>(x)] = box(x, to.width, cut_columns.begin, cut_width);
  }
  const bool is_half = cut_width == 2 * to.width && cut_height == 2 * to.height;
  // 32 bits hold the sum of so many pixels, and divide faster.
  constexpr long long kMost = 1 << 24;
  const bool is_small =
      static_cast<long long>(cut_width / to.width + 1) * (cut_height / to.height + 1) < kMost;
  std::vector<std::uint32_t> sums;
  std::vector<std::uint16_t> sums_of_two;
  for (int y = 0; y < to.height; ++y) {
    const Span rows = box(y, to.height, cut_rows.begin, cut_height);
    const int count = rows.end - rows.begin;
    if (is_half) {
      const std::ptrdiff_t left = static_cast<std::ptrdiff_t>(cut_columns.begin) * kChannels;
      halve<kChannels>(frame.row(rows.begin).data() + left, frame.row(rows.begin + 1).data() + left,
                       to.width, sums_of_two, row_of(to, y));
      continue;
    }
    sum_rows(frame, rows, sums);
    if (is_small) {
      mean_columns<std::uint32_t, kChannels>(sums, columns, count, row_of(to, y));
    } else {
      mean_columns<std::uint64_t, kChannels>(sums, columns, count, row_of(to, y));
    }
  }
}

}  // namespace

Frame make_frame(int width, int height, PixelFormat format) {
  return make_frame(width, height, format, {});
}

Frame make_frame(int width, int height, PixelFormat format, std::vector<std::uint8_t>&& memory) {
  assert(width > 0 && height > 0);
  Frame frame;
  frame.width = width;
  frame.height = height;
  frame.format = format;
  frame.stride = width * bytes_per_pixel(format);
  frame.bytes = std::move(memory);
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

Frame fit(Frame&& frame, int width, int height) {
  if (frame.width == width && frame.height == height) return std::move(frame);
  return fit(std::as_const(frame), width, height);
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
  to.odd = frame.odd;
  const Span columns{left, left + cut_width};
  const Span rows{top, top + cut_height};
  switch (bytes_per_pixel(frame.format)) {
    case 1:
      scale<1>(frame, columns, rows, to);
      break;
    case 3:
      scale<3>(frame, columns, rows, to);
      break;
    default:
      scale<4>(frame, columns, rows, to);
  }
  return to;
}

}  // namespace eyebridge::camera
