#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "eyebridge/base/result.hpp"
#include "image.hpp"

namespace eyebridge::robios {

/// What a pixel of a PNM file is.
enum class PnmKind {
  Bitmap,  ///< One byte, 0 or 1; 1 is black.
  Grey,    ///< One byte, 0 black … 255 white.
  Colour,  ///< R, G, B.
};

/// An image as a PNM file holds it.
struct PnmImage {
  PnmKind kind = PnmKind::Grey;
  ImageSize size;
  std::vector<std::uint8_t> bytes;

  friend bool operator==(const PnmImage&, const PnmImage&) = default;
};

/// Bytes a pixel.
constexpr std::size_t pnm_channels(PnmKind kind) { return kind == PnmKind::Colour ? 3 : 1; }

/// Reads P1..P6 with comments; values are scaled to 255. Bytes after the image are ignored. Fails
/// with Corrupt, naming `name`, the byte, what was found and what was expected. Never takes more
/// memory than 8 bytes for each byte of the file, whatever sizes the file claims. Pure.
Result<PnmImage> read_pnm(ConstBytes file, const std::string& name);
/// read_pnm() on a file of at most 256 MB. Fails with Unsupported when it cannot be read.
Result<PnmImage> read_pnm_file(const std::filesystem::path& path);

/// The image as a binary file: P4, P5 or P6. Pure.
std::vector<std::uint8_t> write_pnm(const PnmImage& image);
/// write_pnm() to a file. Fails with Unsupported, naming the file and the reason.
Result<void> write_pnm_file(const PnmImage& image, const std::filesystem::path& path);

/// Copies `image` to one of `size` pixels and the same kind, top-left aligned: what is missing is
/// 0, what is too much is cut off. `out` holds size.pixels() * pnm_channels(kind) bytes.
void fit(const PnmImage& image, ImageSize size, Bytes out);

}  // namespace eyebridge::robios
