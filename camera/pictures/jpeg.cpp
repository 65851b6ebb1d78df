#include <memory>
#include <stdexcept>
#include <string>

#include <turbojpeg.h>

#include "pictures/decoders.hpp"

namespace eyebridge::camera {
namespace {

struct DestroyDecoder {
  void operator()(void* decoder) const { tjDestroy(decoder); }
};
using Decoder = std::unique_ptr<void, DestroyDecoder>;

[[noreturn]] void jpeg_failed(const Decoder& decoder) {
  throw std::runtime_error(std::string("JPEG: ") + tjGetErrorStr2(decoder.get()));
}

Decoder make_decoder() {
  Decoder decoder(tjInitDecompress());
  if (!decoder) jpeg_failed(decoder);
  return decoder;
}

Size read_size(const Decoder& decoder, std::span<const std::uint8_t> bytes) {
  Size size;
  int subsampling = 0;
  int colours = 0;
  if (tjDecompressHeader3(decoder.get(), bytes.data(), bytes.size(), &size.width, &size.height,
                          &subsampling, &colours) != 0) {
    jpeg_failed(decoder);
  }
  // Cut before its picture begins, a file still passes as one of tables alone.
  if (size.width == 0) throw std::runtime_error("JPEG: no picture in it");
  return size;
}

}  // namespace

Size jpeg_size(std::span<const std::uint8_t> bytes) { return read_size(make_decoder(), bytes); }

Frame decode_jpeg(std::span<const std::uint8_t> bytes, std::uint64_t most_pixels) {
  const Decoder decoder = make_decoder();
  const auto [width, height] = read_size(decoder, bytes);
  Frame frame = frame_to_decode(width, height, most_pixels);
  // A small file of very many scans takes minutes otherwise.
  constexpr int kFlags = TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS | TJFLAG_ACCURATEDCT;
  if (tjDecompress2(decoder.get(), bytes.data(), bytes.size(), frame.bytes.data(), width,
                    frame.stride, height, TJPF_RGB, kFlags) != 0) {
    jpeg_failed(decoder);
  }
  return frame;
}

}  // namespace eyebridge::camera
