#include "pixels/mjpeg_decoder.hpp"

#include <string>

#include <turbojpeg.h>

namespace eyebridge::camera {
namespace {

// A warning of libjpeg-turbo's means that pixels are missing or wrong. Upsampling by copies costs
// less than by interpolation; of a camera's chroma there is not more to see anyway.
constexpr int kFlags = TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS | TJFLAG_FASTUPSAMPLE;

tl::unexpected<Error> corrupt(const std::string& reason) {
  return fail(Errc::Corrupt, "MJPEG: " + reason);
}

/// The smallest scale at which a picture of `size` has at least `least` pixels.
Size scaled_size(Size size, Size least) {
  int count = 0;
  const tjscalingfactor* factors = tjGetScalingFactors(&count);
  Size best = size;
  for (int i = 0; i < count; ++i) {
    const Size scaled{TJSCALED(size.width, factors[i]), TJSCALED(size.height, factors[i])};
    const bool enough = scaled.width >= least.width && scaled.height >= least.height;
    if (enough && scaled.width < best.width) best = scaled;
  }
  return best;
}

}  // namespace

void MjpegDecoder::Destroy::operator()(void* decoder) const { tjDestroy(decoder); }

Result<Frame> MjpegDecoder::decode(std::span<const std::uint8_t> bytes, Size size, Size least,
                                   FramePool& pool) {
  Result<Frame> frame = decode_once(bytes, size, least, pool);
  // A decoder that failed keeps tables and flags of the bad frame.
  if (!frame) decoder_.reset();
  return frame;
}

Result<Frame> MjpegDecoder::decode_once(std::span<const std::uint8_t> bytes, Size size, Size least,
                                        FramePool& pool) {
  if (!decoder_) decoder_.reset(tjInitDecompress());
  if (!decoder_) return corrupt("no decoder: " + std::string(tjGetErrorStr2(nullptr)));
  Size found;
  int subsampling = 0;
  int colours = 0;
  if (tjDecompressHeader3(decoder_.get(), bytes.data(), bytes.size(), &found.width, &found.height,
                          &subsampling, &colours) != 0) {
    return corrupt(tjGetErrorStr2(decoder_.get()));
  }
  if (found != size) {
    return corrupt("a picture of " + std::to_string(found.width) + "x" +
                   std::to_string(found.height) + " in a stream of " + std::to_string(size.width) +
                   "x" + std::to_string(size.height));
  }
  const Size out = scaled_size(size, least);
  Frame frame = pool.make(out.width, out.height, PixelFormat::Rgb24);
  if (tjDecompress2(decoder_.get(), bytes.data(), bytes.size(), frame.bytes.data(), out.width,
                    frame.stride, out.height, TJPF_RGB, kFlags) != 0) {
    return corrupt(tjGetErrorStr2(decoder_.get()));
  }
  return frame;
}

}  // namespace eyebridge::camera
