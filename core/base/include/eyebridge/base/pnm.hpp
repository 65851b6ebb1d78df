#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace eyebridge {

/// What a pixel of a PNM file is.
enum class PnmKind {
  Bitmap,  ///< One byte, 0 or 1; 1 is black.
  Grey,    ///< One byte, 0 black … 255 white.
  Colour,  ///< R, G, B.
};

/// Bytes a pixel.
constexpr std::size_t pnm_channels(PnmKind kind) { return kind == PnmKind::Colour ? 3 : 1; }

/// A picture as a PNM file holds it, the top row first.
struct PnmPicture {
  PnmKind kind = PnmKind::Grey;
  int columns = 0;
  int rows = 0;
  std::vector<std::uint8_t> bytes;

  friend bool operator==(const PnmPicture&, const PnmPicture&) = default;
};

/// Reads P1 to P6 (Netpbm's pbm(5), pgm(5), ppm(5)) with comments; values are scaled to 255, of 16
/// bits, too. Binary values beyond the largest one count as that; bytes after the picture are
/// ignored. Throws ConfigError with `file`, line and column, also for more than `most_pixels`.
/// Never takes more memory than 8 bytes for each byte of the file, whatever sizes the file claims.
PnmPicture read_pnm(std::string_view bytes, const std::string& file,
                    std::size_t most_pixels = static_cast<std::size_t>(-1));

}  // namespace eyebridge
