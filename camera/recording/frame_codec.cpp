#include "eyebridge/camera/recording/frame_codec.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>
#include <string>

#include <turbojpeg.h>
#include <zlib.h>

#include "eyebridge/camera/convert.hpp"
#include "pictures/decoders.hpp"

namespace eyebridge::camera {
namespace {

constexpr int kJpegQuality = 90;
constexpr std::array<std::string_view, 2> kCodecs{"lossless", "mjpeg"};
constexpr std::array<std::string_view, 3> kFormats{"rgb24", "bgra32", "grey8"};

template <class Value, std::size_t kCount>
std::optional<Value> find(const std::array<std::string_view, kCount>& names,
                          std::string_view name) {
  for (std::size_t i = 0; i < kCount; ++i) {
    if (names[i] == name) return static_cast<Value>(i);
  }
  return std::nullopt;
}

/// The bytes of `frame`, row by row without padding, each minus that of the pixel at its left.
std::vector<std::uint8_t> differences(const Frame& frame) {
  const auto step = static_cast<std::size_t>(bytes_per_pixel(frame.format));
  const std::size_t row_bytes = static_cast<std::size_t>(frame.width) * step;
  std::vector<std::uint8_t> bytes(row_bytes * static_cast<std::size_t>(frame.height));
  for (int y = 0; y < frame.height; ++y) {
    const std::uint8_t* in = frame.row(y).data();
    std::uint8_t* out = bytes.data() + static_cast<std::size_t>(y) * row_bytes;
    std::copy(in, in + step, out);
    for (std::size_t i = step; i < row_bytes; ++i) {
      out[i] = static_cast<std::uint8_t>(in[i] - in[i - step]);
    }
  }
  return bytes;
}

/// The reverse, in place.
void add_up(Frame& frame) {
  const auto step = static_cast<std::size_t>(bytes_per_pixel(frame.format));
  const auto stride = static_cast<std::size_t>(frame.stride);
  for (std::size_t row = 0; row < frame.bytes.size(); row += stride) {
    for (std::size_t i = row + step; i < row + stride; ++i) {
      frame.bytes[i] = static_cast<std::uint8_t>(frame.bytes[i] + frame.bytes[i - step]);
    }
  }
}

std::vector<std::uint8_t> deflated(const std::vector<std::uint8_t>& bytes) {
  z_stream stream{};
  // Differences of noisy pixels repeat no strings: runs and Huffman codes alone are twice as fast
  // as the search for them, and as short (bench_recording).
  if (deflateInit2(&stream, 1, Z_DEFLATED, MAX_WBITS, MAX_MEM_LEVEL, Z_RLE) != Z_OK) {
    throw std::runtime_error("zlib: out of memory");
  }
  std::vector<std::uint8_t> out(deflateBound(&stream, bytes.size()));
  stream.next_in = const_cast<std::uint8_t*>(bytes.data());  // zlib does not write to it
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = out.data();
  stream.avail_out = static_cast<uInt>(out.size());
  const int code = deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  if (code != Z_STREAM_END) throw std::runtime_error("zlib: the pixels cannot be packed");
  return out;
}

Frame inflated(std::span<const std::uint8_t> data, Size size, PixelFormat format) {
  // No bit of deflate's holds more than that (zlib.net, "Technical Details"): a few damaged bytes
  // must not cost the memory of a huge picture.
  constexpr std::uint64_t kMostPerByte = 1032;
  const auto pixels =
      static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height);
  if (pixels * static_cast<std::uint64_t>(bytes_per_pixel(format)) > kMostPerByte * data.size()) {
    throw std::runtime_error("fewer pixels than its size says");
  }
  Frame frame = make_frame(size.width, size.height, format);
  uLongf length = frame.bytes.size();
  const int code = uncompress(frame.bytes.data(), &length, data.data(), data.size());
  if (code == Z_BUF_ERROR && length == frame.bytes.size()) {
    throw std::runtime_error("more pixels than its size says");
  }
  if (code != Z_OK) throw std::runtime_error("its pixels are damaged");
  if (length != frame.bytes.size()) throw std::runtime_error("fewer pixels than its size says");
  add_up(frame);
  return frame;
}

struct Destroy {
  void operator()(void* encoder) const { tjDestroy(encoder); }
  void operator()(unsigned char* data) const { tjFree(data); }
};

std::vector<std::uint8_t> jpeg_of(const Frame& frame) {
  const bool grey = frame.format == PixelFormat::Grey8;
  const int pixels = grey ? TJPF_GRAY : frame.format == PixelFormat::Bgra32 ? TJPF_BGRA : TJPF_RGB;
  const std::unique_ptr<void, Destroy> encoder(tjInitCompress());
  unsigned char* data = nullptr;
  unsigned long size = 0;  // NOLINT(google-runtime-int): turbojpeg's
  const int code =
      tjCompress2(encoder.get(), frame.bytes.data(), frame.width, frame.stride, frame.height,
                  pixels, &data, &size, grey ? TJSAMP_GRAY : TJSAMP_444, kJpegQuality, 0);
  const std::unique_ptr<unsigned char, Destroy> owner(data);
  if (code != 0) throw std::runtime_error(std::string("JPEG: ") + tjGetErrorStr2(encoder.get()));
  return {data, data + size};
}

Frame from_jpeg(std::span<const std::uint8_t> data, Size size, PixelFormat format) {
  const auto most =
      static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height);
  Frame frame = decode_jpeg(data, most);
  if (Size{frame.width, frame.height} != size) {
    throw std::runtime_error("a JPEG of " + std::to_string(frame.width) + " x " +
                             std::to_string(frame.height) + " pixels, expected " +
                             std::to_string(size.width) + " x " + std::to_string(size.height));
  }
  return format == PixelFormat::Grey8 ? to_grey8(frame) : frame;
}

}  // namespace

std::string_view name_of(FrameCodec codec) { return kCodecs[static_cast<std::size_t>(codec)]; }

std::optional<FrameCodec> find_frame_codec(std::string_view name) {
  return find<FrameCodec>(kCodecs, name);
}

std::string_view name_of(PixelFormat format) { return kFormats[static_cast<std::size_t>(format)]; }

std::optional<PixelFormat> find_pixel_format(std::string_view name) {
  return find<PixelFormat>(kFormats, name);
}

std::vector<std::uint8_t> encode_frame(const Frame& frame, FrameCodec codec) {
  return codec == FrameCodec::Mjpeg ? jpeg_of(frame) : deflated(differences(frame));
}

Frame decode_frame(std::span<const std::uint8_t> data, FrameCodec codec, Size size,
                   PixelFormat format) {
  return codec == FrameCodec::Mjpeg ? from_jpeg(data, size, format) : inflated(data, size, format);
}

}  // namespace eyebridge::camera
