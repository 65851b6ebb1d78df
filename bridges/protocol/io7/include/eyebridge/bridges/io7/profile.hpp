#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace eyebridge::bridges::io7 {

/// How a request is written.
enum class RequestForm : std::uint8_t {
  Ascii,   ///< `m 1 50` and a terminator.
  Binary,  ///< The letter, then its arguments as bytes; nothing else.
};

/// What ends an ASCII request.
enum class Terminator : std::uint8_t { Cr, Lf, CrLf };

/// How a reply is written.
enum class ReplyForm : std::uint8_t {
  Text,  ///< A line that ends in CR and/or LF.
  Raw,   ///< The bytes of the values, without an end.
};

/// Order of the bytes of a number, in binary requests and raw replies.
enum class ByteOrder : std::uint8_t { MsbFirst, LsbFirst };

/// A set of 7-bit letters. No allocation.
class LetterSet {
 public:
  constexpr LetterSet() = default;
  constexpr explicit LetterSet(std::string_view letters) {
    for (const char letter : letters) insert(letter);
  }
  /// Adds `letter`; bytes that are no 7-bit character are ignored.
  constexpr void insert(char letter) {
    const auto code = static_cast<unsigned char>(letter);
    if (code < 128) words_[code / 64] |= std::uint64_t{1} << (code % 64);
  }
  [[nodiscard]] constexpr bool has(char letter) const {
    const auto code = static_cast<unsigned char>(letter);
    return code < 128 && ((words_[code / 64] >> (code % 64)) & 1U) != 0;
  }
  [[nodiscard]] constexpr bool empty() const { return words_[0] == 0 && words_[1] == 0; }

  friend constexpr bool operator==(const LetterSet&, const LetterSet&) = default;

 private:
  std::array<std::uint64_t, 2> words_{};
};

/// What the prompt of a board looks like: up to eight bytes, usually ">" or nothing.
struct Prompt {
  std::array<char, 8> bytes{};
  std::uint8_t length = 0;

  [[nodiscard]] constexpr std::string_view view() const { return {bytes.data(), length}; }

  friend constexpr bool operator==(const Prompt&, const Prompt&) = default;
};

/// Everything about one board's dialect that its documentation leaves open. Found by `Probe`, or
/// written down for a board that is known. The default is the command page read literally.
struct Profile {
  RequestForm request_form = RequestForm::Ascii;
  Terminator terminator = Terminator::Cr;
  ReplyForm reply_form = ReplyForm::Raw;
  ByteOrder byte_order = ByteOrder::MsbFirst;
  Prompt prompt{};                ///< Follows every text reply; empty when the board has none.
  bool prompt_after_raw = false;  ///< It follows raw replies too.
  bool echo = false;              ///< The board sends each request back before it answers.
  bool vw_letters = false;        ///< Allow the undocumented v-omega letters, where listed.
  LetterSet letters{};            ///< What the board's own list names. Nothing else is ever sent.

  friend constexpr bool operator==(const Profile&, const Profile&) = default;
};

/// The bytes of `terminator`.
std::span<const std::uint8_t> bytes_of(Terminator terminator);

/// All letters of the published command page but `E`: for a board whose list is known beforehand.
LetterSet documented_letters();

}  // namespace eyebridge::bridges::io7
