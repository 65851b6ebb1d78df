#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace eyebridge::bridges::io7 {

/// The most arguments that a request has.
inline constexpr std::size_t kMaxArguments = 4;
/// The most values that a reply has.
inline constexpr std::size_t kMaxValues = 3;

/// One argument of a request, or one value of a reply: how it travels and what it may be.
struct Field {
  std::string_view name;
  int first = 0;           ///< Lowest value that is accepted.
  int last = 0;            ///< Highest value that is accepted.
  std::uint8_t width = 1;  ///< Bytes in the binary form; two's complement when `first` < 0.
  bool letter = false;     ///< One of "ioIJ", sent as itself in both forms.
};

/// How a letter is answered.
enum class ReplyKind : std::uint8_t {
  None,     ///< Not at all.
  Values,   ///< With the numbers in `Command::values`.
  Version,  ///< With IO7_VERSION_LENGTH characters.
  List,     ///< With lines of text of any number.
};

/// One letter of the protocol, for both directions and all forms.
struct Command {
  char letter = 0;
  std::string_view name;
  std::array<Field, kMaxArguments> argument_fields{};
  std::uint8_t argument_count = 0;
  ReplyKind reply = ReplyKind::None;
  std::array<Field, kMaxValues> value_fields{};
  std::uint8_t value_count = 0;
  bool documented = true;  ///< False for the v-omega letters, which are guesses by analogy.

  [[nodiscard]] constexpr std::span<const Field> arguments() const {
    return {argument_fields.data(), argument_count};
  }
  [[nodiscard]] constexpr std::span<const Field> values() const {
    return {value_fields.data(), value_count};
  }
  /// Bytes of the answer in the raw form, without a prompt; 0 where there is none, or text.
  [[nodiscard]] std::size_t raw_reply_length() const;
};

/// All letters that a bridge may ever send. `E`, the demo drive, is not among them.
std::span<const Command> commands();

/// The row of `letter`; null when it is none that a bridge may send.
const Command* find_command(char letter);

}  // namespace eyebridge::bridges::io7
