#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "pictures/decoders.hpp"

// Layout: Microsoft, "Bitmap Storage" (BITMAPFILEHEADER, BITMAPCOREHEADER, BITMAPINFOHEADER).
namespace eyebridge::camera {
namespace {

constexpr std::size_t kFileHeader = 14;
constexpr std::uint32_t kCoreHeader = 12;  // bytes; OS/2
constexpr std::uint32_t kBitFields = 3;    // a compression that is none
constexpr std::uint32_t kInfoHeader = 40;  // bytes; Windows, and the start of all later ones

[[noreturn]] void bmp_failed(const std::string& reason) {
  throw std::runtime_error("BMP: " + reason);
}

/// Little-endian numbers at places of a file; throws at its end.
class Bytes {
 public:
  explicit Bytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  [[nodiscard]] std::span<const std::uint8_t> at(std::uint64_t place, std::uint64_t count) const {
    if (place > bytes_.size() || count > bytes_.size() - place) bmp_failed("the file is cut");
    return bytes_.subspan(place, count);
  }
  [[nodiscard]] std::uint32_t u16(std::uint64_t place) const {
    const auto b = at(place, 2);
    return b[0] | static_cast<std::uint32_t>(b[1]) << 8U;
  }
  [[nodiscard]] std::uint32_t u32(std::uint64_t place) const {
    return u16(place) | u16(place + 2) << 16U;
  }
  [[nodiscard]] std::int32_t i32(std::uint64_t place) const {
    return static_cast<std::int32_t>(u32(place));
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

struct Header {
  std::int64_t width = 0;
  std::int64_t height = 0;  ///< Negative: the first row is the top one.
  std::uint32_t bits = 0;
  std::uint64_t palette = 0;       ///< Place in the file.
  std::uint64_t colours = 0;       ///< Of the palette.
  std::uint64_t colour_bytes = 0;  ///< Blue, green, red, and perhaps one more.
  std::uint64_t pixels = 0;        ///< Place in the file.
};

Header read_header(const Bytes& file) {
  Header header;
  const std::uint32_t size = file.u32(kFileHeader);
  header.pixels = file.u32(10);
  header.palette = kFileHeader + std::uint64_t{size};
  if (size == kCoreHeader) {
    header.width = file.u16(18);
    header.height = file.u16(20);
    header.bits = file.u16(24);
    header.colour_bytes = 3;
  } else if (size >= kInfoHeader) {
    header.width = file.i32(18);
    header.height = file.i32(22);
    header.bits = file.u16(28);
    const std::uint32_t compression = file.u32(30);
    if (compression == kBitFields && header.bits == 32) {
      // Where each colour's bits are: as everywhere, or not read.
      if (file.u32(54) != 0xFF0000U || file.u32(58) != 0xFF00U || file.u32(62) != 0xFFU) {
        bmp_failed("colours in other bits than red, green and blue of 8 each");
      }
    } else if (compression != 0) {
      bmp_failed("compressed, expected an uncompressed one");
    }
    header.colours = file.u32(46);
    header.colour_bytes = 4;
  } else {
    bmp_failed("a header of " + std::to_string(size) + " bytes, expected 12 or at least 40");
  }
  if (header.bits != 8 && header.bits != 24 && header.bits != 32) {
    bmp_failed(std::to_string(header.bits) + " bits a pixel, expected 8, 24 or 32");
  }
  if (header.colours == 0) header.colours = 256;
  if (header.bits == 8 && header.colours > 256) {
    bmp_failed(std::to_string(header.colours) + " colours, expected at most 256");
  }
  return header;
}

/// Blue, green, red to red, green, blue.
void copy_colour(const std::uint8_t* from, std::uint8_t* to) {
  to[0] = from[2];
  to[1] = from[1];
  to[2] = from[0];
}

}  // namespace

Size bmp_size(std::span<const std::uint8_t> bytes) {
  const Header header = read_header(Bytes(bytes));
  if (header.width < 1 || header.height == 0) bmp_failed("no picture in it");
  // Both are of at most 32 bits.
  return {static_cast<int>(header.width), static_cast<int>(std::abs(header.height))};
}

Frame decode_bmp(std::span<const std::uint8_t> bytes, std::uint64_t most_pixels) {
  const Bytes file(bytes);
  const Header header = read_header(file);
  const bool top_down = header.height < 0;
  const std::int64_t rows = top_down ? -header.height : header.height;
  if (header.width < 1) bmp_failed("a width of " + std::to_string(header.width));
  const std::uint64_t pixel = header.bits / 8;
  const std::uint64_t row_bytes = (static_cast<std::uint64_t>(header.width) * pixel + 3) / 4 * 4;
  // Before memory is taken: a file of some bytes may claim any size.
  const auto all = file.at(header.pixels, row_bytes * static_cast<std::uint64_t>(rows));
  const auto palette = header.bits == 8
                           ? file.at(header.palette, header.colours * header.colour_bytes)
                           : std::span<const std::uint8_t>();
  Frame frame = frame_to_decode(header.width, rows, most_pixels);
  for (std::int64_t y = 0; y < rows; ++y) {
    const std::uint8_t* from = &all[static_cast<std::uint64_t>(y) * row_bytes];
    const std::int64_t target = top_down ? y : rows - 1 - y;
    std::uint8_t* to = &frame.bytes[static_cast<std::size_t>(target * frame.stride)];
    for (std::int64_t x = 0; x < header.width; ++x, from += pixel, to += 3) {
      if (header.bits > 8) {
        copy_colour(from, to);
        continue;
      }
      if (*from >= header.colours) bmp_failed("a colour that its palette lacks");
      copy_colour(&palette[*from * header.colour_bytes], to);
    }
  }
  return frame;
}

}  // namespace eyebridge::camera
