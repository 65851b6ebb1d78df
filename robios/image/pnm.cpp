#include "pnm.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <optional>

namespace eyebridge::robios {
namespace {

constexpr int kLargestSide = 65535;
constexpr int kLargestValue = 65535;
constexpr std::uintmax_t kLargestFile = 256u << 20;

bool is_blank(std::uint8_t c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
bool is_digit(std::uint8_t c) { return c >= '0' && c <= '9'; }

class Reader {
 public:
  Reader(ConstBytes file, const std::string& name) : file_(file), name_(name) {}

  Result<PnmImage> read() {
    const int form = magic();
    if (form == 0) {
      return reject("P1 to P6");
    }
    const auto width = number(kLargestSide);
    const auto height = width ? number(kLargestSide) : std::nullopt;
    if (!height || *width < 1 || *height < 1) {
      return reject("width and height, 1 to 65535 each");
    }
    const bool bitmap = form == 1 || form == 4;
    const auto limit = bitmap ? std::optional(1) : number(kLargestValue);
    if (!limit || *limit < 1) {
      return reject("the largest value, 1 to 65535");
    }
    limit_ = *limit;

    PnmImage image;
    image.size = {*width, *height};
    image.kind = bitmap ? PnmKind::Bitmap : form % 3 == 2 ? PnmKind::Grey : PnmKind::Colour;
    const std::size_t values = image.size.pixels() * pnm_channels(image.kind);
    const bool binary = form > 3;
    if (binary && (position_ == file_.size() || !is_blank(file_[position_++]))) {
      return reject("a blank before the pixels");
    }
    // Before any memory is taken: the pixels must be there. In text a value is a byte at least.
    const std::size_t row_bytes = (static_cast<std::size_t>(*width) + 7) / 8;
    const std::size_t needed = form == 4 ? row_bytes * static_cast<std::size_t>(*height)
                               : binary  ? values * value_bytes()
                                         : values;
    if (file_.size() - position_ < needed) {
      return reject(std::to_string(needed) + " bytes of pixels");
    }
    image.bytes.reserve(values);
    if (form == 4) {
      unpack_bits(image, row_bytes);
      return image;
    }
    for (std::size_t i = 0; i < values; ++i) {
      const auto value = form == 1 ? bit() : binary ? binary_value() : number(kLargestValue);
      if (!value || *value > limit_) {
        return reject("a value of 0 to " + std::to_string(limit_));
      }
      image.bytes.push_back(
          static_cast<std::uint8_t>(bitmap ? *value : (*value * 255 + limit_ / 2) / limit_));
    }
    return image;
  }

 private:
  tl::unexpected<Error> reject(const std::string& expected) const {
    const std::string found =
        position_ >= file_.size() ? "the end" : "byte " + std::to_string(file_[position_]);
    return fail(Errc::Corrupt, name_ + ": at byte " + std::to_string(position_) + ": found " +
                                   found + ", expected " + expected);
  }

  int magic() {
    if (file_.size() < 2 || file_[0] != 'P' || file_[1] < '1' || file_[1] > '6') {
      return 0;
    }
    position_ = 2;
    return file_[1] - '0';
  }

  void skip_blanks() {
    while (position_ < file_.size()) {
      if (file_[position_] == '#') {
        while (position_ < file_.size() && file_[position_] != '\n') {
          ++position_;
        }
      } else if (is_blank(file_[position_])) {
        ++position_;
      } else {
        return;
      }
    }
  }

  /// A decimal number of at most `largest`; the position stays on what is not one.
  std::optional<int> number(int largest) {
    skip_blanks();
    const std::size_t start = position_;
    int value = 0;
    while (position_ < file_.size() && is_digit(file_[position_])) {
      value = value * 10 + (file_[position_] - '0');
      ++position_;
      if (value > largest) {
        position_ = start;
        return std::nullopt;
      }
    }
    return position_ > start ? std::optional(value) : std::nullopt;
  }

  /// In P1 the digits need no blanks between them.
  std::optional<int> bit() {
    skip_blanks();
    if (position_ == file_.size() || file_[position_] < '0' || file_[position_] > '1') {
      return std::nullopt;
    }
    return file_[position_++] - '0';
  }

  [[nodiscard]] std::size_t value_bytes() const { return limit_ > 255 ? 2 : 1; }

  std::optional<int> binary_value() {
    int value = 0;
    for (std::size_t i = 0; i < value_bytes(); ++i) {
      value = value * 256 + file_[position_++];
    }
    return value;
  }

  void unpack_bits(PnmImage& image, std::size_t row_bytes) {
    for (int y = 0; y < image.size.height; ++y) {
      for (std::size_t x = 0; x < static_cast<std::size_t>(image.size.width); ++x) {
        const unsigned byte = file_[position_ + x / 8];
        image.bytes.push_back(static_cast<std::uint8_t>((byte >> (7 - x % 8)) & 1u));
      }
      position_ += row_bytes;
    }
  }

  ConstBytes file_;
  const std::string& name_;
  std::size_t position_ = 0;
  int limit_ = 1;
};

Result<void> io_failure(const std::filesystem::path& path, const std::string& doing) {
  return fail(Errc::Unsupported, path.string() + ": " + doing + ": " + std::strerror(errno));
}

}  // namespace

Result<PnmImage> read_pnm(ConstBytes file, const std::string& name) {
  return Reader(file, name).read();
}

Result<PnmImage> read_pnm_file(const std::filesystem::path& path) {
  std::error_code status;
  if (!std::filesystem::is_regular_file(path, status)) {
    return fail(Errc::Unsupported, path.string() + ": no such file");
  }
  const std::uintmax_t size = std::filesystem::file_size(path, status);
  if (status || size > kLargestFile) {
    return fail(Errc::Unsupported, path.string() + ": larger than 256 MB");
  }
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  std::vector<std::uint8_t> bytes(size);
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): iostreams speak char
  in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  if (!in) {
    return tl::unexpected(io_failure(path, "cannot be read").error());
  }
  return read_pnm(bytes, path.string());
}

std::vector<std::uint8_t> write_pnm(const PnmImage& image) {
  const char form = image.kind == PnmKind::Bitmap ? '4' : image.kind == PnmKind::Grey ? '5' : '6';
  std::string header = std::string("P") + form + "\n" + std::to_string(image.size.width) + " " +
                       std::to_string(image.size.height) + "\n";
  if (image.kind != PnmKind::Bitmap) {
    header += "255\n";
  }
  std::vector<std::uint8_t> out(header.begin(), header.end());
  if (image.kind != PnmKind::Bitmap) {
    out.insert(out.end(), image.bytes.begin(), image.bytes.end());
    return out;
  }
  const auto width = static_cast<std::size_t>(image.size.width);
  for (std::size_t i = 0; i < image.bytes.size(); ++i) {
    const std::size_t x = i % width;
    if (x % 8 == 0) {
      out.push_back(0);
    }
    if (image.bytes[i] != 0) {
      out.back() = static_cast<std::uint8_t>(out.back() | (0x80u >> (x % 8)));
    }
  }
  return out;
}

Result<void> write_pnm_file(const PnmImage& image, const std::filesystem::path& path) {
  const std::vector<std::uint8_t> bytes = write_pnm(image);
  errno = 0;
  std::ofstream out(path, std::ios::binary);
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): iostreams speak char
  out.write(reinterpret_cast<const char*>(bytes.data()),
            static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) {
    return io_failure(path, "cannot be written");
  }
  return {};
}

void fit(const PnmImage& image, ImageSize size, Bytes out) {
  const std::size_t channels = pnm_channels(image.kind);
  const std::size_t row = static_cast<std::size_t>(size.width) * channels;
  const std::size_t from_row = static_cast<std::size_t>(image.size.width) * channels;
  const std::size_t copied = std::min(row, from_row);
  std::fill_n(out.begin(), row * static_cast<std::size_t>(size.height), std::uint8_t{0});
  for (std::size_t y = 0; y < static_cast<std::size_t>(std::min(size.height, image.size.height));
       ++y) {
    std::copy_n(image.bytes.begin() + static_cast<std::ptrdiff_t>(y * from_row), copied,
                out.begin() + static_cast<std::ptrdiff_t>(y * row));
  }
}

}  // namespace eyebridge::robios
