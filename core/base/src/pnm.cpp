#include "eyebridge/base/pnm.hpp"

#include <algorithm>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge {
namespace {

constexpr int kLongestSide = 1 << 24;
constexpr int kLargestValue = 65535;

class PnmReader {
 public:
  PnmReader(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  PnmPicture read(std::size_t most_pixels) {
    if (bytes_.size() < 2 || bytes_[0] != 'P' || bytes_[1] < '1' || bytes_[1] > '6') {
      fail("no PNM picture: expected a file that begins with P1 to P6");
    }
    const int form = bytes_[1] - '0';
    const bool binary = form > 3;
    const bool bitmap = form % 3 == 1;
    step();
    step();
    PnmPicture picture;
    picture.kind = bitmap ? PnmKind::Bitmap : form % 3 == 2 ? PnmKind::Grey : PnmKind::Colour;
    picture.columns = number("the width", 1, kLongestSide);
    picture.rows = number("the height", 1, kLongestSide);
    const auto columns = static_cast<std::size_t>(picture.columns);
    const auto rows = static_cast<std::size_t>(picture.rows);
    size_ = std::to_string(columns) + " x " + std::to_string(rows);
    if (columns * rows > most_pixels) {
      fail("picture of " + size_ + " pixels: expected at most " + std::to_string(most_pixels));
    }
    largest_ = bitmap ? 1 : number("the largest value", 1, kLargestValue);
    if (binary) {
      if (at_ == bytes_.size() || !is_blank(bytes_[at_])) {
        fail("expected a blank or the end of the line before the pixels");
      }
      step();
    }
    const std::size_t values = columns * rows * pnm_channels(picture.kind);
    // Before any memory is taken: the pixels must be there. In text a value takes two bytes, of a
    // bitmap one.
    const std::size_t row_bytes = (columns + 7) / 8;
    const std::size_t needed = !binary  ? (bitmap ? values : 2 * values - 1)
                               : bitmap ? row_bytes * rows
                                        : values * value_bytes();
    if (bytes_.size() - at_ < needed) {
      fail("file has " + std::to_string(bytes_.size() - at_) + " bytes of pixels: expected " +
           (binary ? "" : "at least ") + std::to_string(needed) + ", " + size_);
    }
    picture.bytes.reserve(values);
    if (binary && bitmap) {
      unpack_bits(picture, row_bytes);
      return picture;
    }
    for (std::size_t i = 0; i < values; ++i) {
      const int value = binary   ? std::min(binary_value(), largest_)
                        : bitmap ? bit()
                                 : number("a value", 0, largest_);
      picture.bytes.push_back(
          static_cast<std::uint8_t>(bitmap ? value : (value * 255 + largest_ / 2) / largest_));
    }
    return picture;
  }

 private:
  [[nodiscard]] std::size_t value_bytes() const { return largest_ > 255 ? 2 : 1; }

  int binary_value() {
    int value = 0;
    for (std::size_t i = 0; i < value_bytes(); ++i) {
      value = value * 256 + static_cast<std::uint8_t>(bytes_[at_++]);
    }
    return value;
  }

  void unpack_bits(PnmPicture& picture, std::size_t row_bytes) {
    for (int row = 0; row < picture.rows; ++row, at_ += row_bytes) {
      for (std::size_t i = 0; i < static_cast<std::size_t>(picture.columns); ++i) {
        const unsigned byte = static_cast<std::uint8_t>(bytes_[at_ + i / 8]);
        picture.bytes.push_back(static_cast<std::uint8_t>((byte >> (7 - i % 8)) & 1U));
      }
    }
  }

  /// The next number of the header, or of a plain picture.
  int number(const char* what, int low, int high) {
    skip();
    const SourceLocation where = here();
    const std::size_t first = at_;
    std::int64_t value = 0;
    while (at_ < bytes_.size() && bytes_[at_] >= '0' && bytes_[at_] <= '9') {
      value = std::min<std::int64_t>(10 * value + (bytes_[at_] - '0'), 1'000'000'000);
      step();
    }
    if (at_ == first) {
      const bool end = at_ == bytes_.size();
      throw ConfigError(where, std::string(end ? "file ends" : "no number") + ": expected " + what);
    }
    if (value < low || value > high) {
      throw ConfigError(
          where, std::string(what) + " is " +
                     std::string(bytes_.substr(first, std::min<std::size_t>(at_ - first, 20))) +
                     ": expected " + std::to_string(low) + " to " + std::to_string(high));
    }
    return static_cast<int>(value);
  }

  /// In P1 the digits need no blanks between them.
  int bit() {
    skip();
    if (at_ == bytes_.size() || bytes_[at_] < '0' || bytes_[at_] > '1') {
      fail(at_ == bytes_.size() ? "file ends: expected 0 or 1" : "expected 0 or 1");
    }
    const int value = bytes_[at_] - '0';
    step();
    return value;
  }

  static bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
  /// Over blanks and comments, which end with their line.
  void skip() {
    while (at_ < bytes_.size() && (is_blank(bytes_[at_]) || bytes_[at_] == '#')) {
      if (bytes_[at_] == '#') {
        while (at_ < bytes_.size() && bytes_[at_] != '\n') step();
      } else {
        step();
      }
    }
  }
  void step() {
    if (bytes_[at_] == '\n') {
      ++line_;
      column_ = 0;
    }
    ++column_;
    ++at_;
  }
  [[nodiscard]] SourceLocation here() const { return {file_, line_, column_}; }
  [[noreturn]] void fail(const std::string& text) const { throw ConfigError(here(), text); }

  std::string_view bytes_;
  const std::string& file_;
  std::string size_;
  std::size_t at_ = 0;
  int line_ = 1;
  int column_ = 1;
  int largest_ = 1;
};

}  // namespace

PnmPicture read_pnm(std::string_view bytes, const std::string& file, std::size_t most_pixels) {
  return PnmReader(bytes, file).read(most_pixels);
}

}  // namespace eyebridge
