#include <algorithm>
#include <string>

#include "eyebridge/files/map_files.hpp"

namespace eyebridge::files {
namespace {

/// Reads one PGM picture (Netpbm's pgm(5)).
class PgmReader {
 public:
  PgmReader(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  GreyPicture read() {
    if (!bytes_.starts_with("P5") && !bytes_.starts_with("P2")) {
      fail("no PGM picture: expected a file that begins with P5 or P2");
    }
    const bool plain = bytes_[1] == '2';
    step();
    step();
    GreyPicture picture;
    picture.columns = number("the width", 1, 1 << 24);
    picture.rows = number("the height", 1, 1 << 24);
    const std::size_t count =
        static_cast<std::size_t>(picture.columns) * static_cast<std::size_t>(picture.rows);
    if (count > kMaxMapCells) {
      fail("picture of " + size_text(picture) + " pixels: expected at most " +
           std::to_string(kMaxMapCells));
    }
    const int white = number("the value of white", 1, 255);
    if (plain) {
      read_plain(picture, count, white);
    } else {
      read_binary(picture, count, white);
    }
    return picture;
  }

 private:
  static std::string size_text(const GreyPicture& picture) {
    return std::to_string(picture.columns) + " x " + std::to_string(picture.rows);
  }
  static std::uint8_t scaled(int value, int white) {
    return static_cast<std::uint8_t>(white == 255 ? value : (255 * value + white / 2) / white);
  }

  void read_plain(GreyPicture& picture, std::size_t count, int white) {
    // Each value takes two bytes at least: no file makes us take more memory than it has itself.
    if ((bytes_.size() - at_) / 2 + 1 < count) {
      fail("file ends within its pixels: expected " + size_text(picture));
    }
    picture.greys.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      picture.greys.push_back(scaled(number("a grey", 0, white), white));
    }
  }

  void read_binary(GreyPicture& picture, std::size_t count, int white) {
    if (at_ == bytes_.size() || !is_blank(bytes_[at_])) {
      fail("expected a blank or the end of the line before the pixels");
    }
    step();
    const std::size_t rest = bytes_.size() - at_;
    if (rest < count) {
      fail("file has " + std::to_string(rest) + " bytes of pixels: expected " +
           std::to_string(count) + ", " + size_text(picture));
    }
    picture.greys.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      const int value = static_cast<std::uint8_t>(bytes_[at_ + i]);
      picture.greys[i] = scaled(std::min(value, white), white);
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

  static bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v';
  }
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
  std::size_t at_ = 0;
  int line_ = 1;
  int column_ = 1;
};

}  // namespace

GreyPicture read_pgm(std::string_view bytes, const std::string& file) {
  return PgmReader(bytes, file).read();
}

}  // namespace eyebridge::files
