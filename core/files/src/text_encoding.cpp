#include "text_encoding.hpp"

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge::files {
namespace {

constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";

unsigned byte_of(std::string_view bytes, std::size_t i) {
  return static_cast<unsigned char>(bytes[i]);
}

void put(std::string& out, std::uint32_t code) {
  const auto add = [&](std::uint32_t byte) { out += static_cast<char>(byte); };
  if (code < 0x80) {
    add(code);
  } else if (code < 0x800) {
    add(0xC0 | code >> 6);
    add(0x80 | (code & 0x3F));
  } else if (code < 0x10000) {
    add(0xE0 | code >> 12);
    add(0x80 | (code >> 6 & 0x3F));
    add(0x80 | (code & 0x3F));
  } else {
    add(0xF0 | code >> 18);
    add(0x80 | (code >> 12 & 0x3F));
    add(0x80 | (code >> 6 & 0x3F));
    add(0x80 | (code & 0x3F));
  }
}

/// Bytes of the character at `i` of UTF-8; 0: it is none.
std::size_t length_at(std::string_view bytes, std::size_t i) {
  const unsigned first = byte_of(bytes, i);
  const std::size_t length = first < 0x80   ? 1
                             : first < 0xC2 ? 0
                             : first < 0xE0 ? 2
                             : first < 0xF0 ? 3
                             : first < 0xF5 ? 4
                                            : 0;
  if (i + length > bytes.size()) return 0;
  for (std::size_t k = 1; k < length; ++k) {
    if ((byte_of(bytes, i + k) & 0xC0) != 0x80) return 0;
  }
  return length;
}

bool is_utf8(std::string_view bytes) {
  for (std::size_t i = 0; i < bytes.size();) {
    const std::size_t length = length_at(bytes, i);
    if (length == 0) return false;
    i += length;
  }
  return true;
}

std::string from_latin1(std::string_view bytes) {
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); ++i) put(out, byte_of(bytes, i));
  return out;
}

enum class Utf16 { None, LittleEndian, BigEndian };

/// By its mark; without one, by zeros in every other byte of what it begins with.
Utf16 utf16_of(std::string_view bytes) {
  if (bytes.starts_with("\xFF\xFE")) return Utf16::LittleEndian;
  if (bytes.starts_with("\xFE\xFF")) return Utf16::BigEndian;
  constexpr std::size_t kLooked = 64;
  constexpr std::size_t kFewest = 8;
  const std::size_t size = std::min(bytes.size() & ~std::size_t{1}, kLooked);
  if (size < kFewest) return Utf16::None;
  std::size_t zeros[2] = {};
  for (std::size_t i = 0; i < size; ++i) {
    if (bytes[i] == 0) ++zeros[i % 2];
  }
  if (zeros[1] == size / 2 && zeros[0] == 0) return Utf16::LittleEndian;
  if (zeros[0] == size / 2 && zeros[1] == 0) return Utf16::BigEndian;
  return Utf16::None;
}

std::string from_utf16(std::string_view bytes, Utf16 order, const std::string& file) {
  const std::size_t low = order == Utf16::LittleEndian ? 0 : 1;
  const auto unit = [&](std::size_t i) {
    return static_cast<std::uint32_t>(byte_of(bytes, i + low) | byte_of(bytes, i + 1 - low) << 8U);
  };
  const auto refuse = [&](const std::string& what) {
    throw ConfigError({file, 0, 0}, what + ": expected whole UTF-16; save the file as UTF-8");
  };
  if (bytes.size() % 2 != 0) refuse("a text in UTF-16 that ends with half a character");
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 2) {
    std::uint32_t code = unit(i);
    if (code == 0xFEFF && i == 0) continue;  // the mark
    if (code >= 0xD800 && code < 0xE000) {
      const std::uint32_t next = code < 0xDC00 && i + 3 < bytes.size() ? unit(i + 2) : 0;
      if (next < 0xDC00 || next >= 0xE000) refuse("half of a pair at byte " + std::to_string(i));
      code = 0x10000 + ((code - 0xD800) << 10U) + (next - 0xDC00);
      i += 2;
    }
    put(out, code);
  }
  return out;
}

bool is_lines_and_blanks(std::string_view text) {
  return text.find('\r') == std::string_view::npos &&
         text.find("\xC2\xA0") == std::string_view::npos &&
         text.find("\xE2\x80\xAF") == std::string_view::npos;
}

std::string with_plain_lines_and_blanks(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\r') {
      if (i + 1 == text.size() || text[i + 1] != '\n') out += '\n';
    } else if (text.substr(i).starts_with("\xC2\xA0")) {
      out += ' ';
      i += 1;
    } else if (text.substr(i).starts_with("\xE2\x80\xAF")) {
      out += ' ';
      i += 2;
    } else {
      out += text[i];
    }
  }
  return out;
}

}  // namespace

std::string as_utf8(std::string bytes, const std::string& file) {
  using namespace std::string_view_literals;
  if (bytes.starts_with("\xFF\xFE\0\0"sv) || bytes.starts_with("\0\0\xFE\xFF"sv)) {
    throw ConfigError({file, 0, 0}, "a text in UTF-32: save it as UTF-8");
  }
  const Utf16 order = utf16_of(bytes);
  if (order != Utf16::None) {
    bytes = from_utf16(bytes, order, file);
  } else if (!is_utf8(bytes)) {
    bytes = from_latin1(bytes);
  }
  if (bytes.starts_with(kUtf8Mark)) bytes.erase(0, kUtf8Mark.size());
  if (is_lines_and_blanks(bytes)) return bytes;
  return with_plain_lines_and_blanks(bytes);
}

}  // namespace eyebridge::files
