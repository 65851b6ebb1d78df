#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "eyebridge/base/result.hpp"
#include "eyebridge/bridges/io7/command_table.hpp"
#include "eyebridge/bridges/io7/profile.hpp"
#include "eyebridge/bridges/io7/request.hpp"

namespace eyebridge::bridges::io7 {

/// The most text that a reply may have: the command list is the longest.
inline constexpr std::size_t kMaxReplyText = 4096;

/// What a board answered.
struct Reply {
  char letter = 0;
  std::array<int, kMaxValues> values{};
  std::uint8_t count = 0;                          ///< Values in use.
  std::array<char, IO7_VERSION_LENGTH> version{};  ///< Of letter `v` only.

  friend constexpr bool operator==(const Reply&, const Reply&) = default;
};

/// Finds the reply to one request in the bytes that follow it. Pure: no clock, no I/O, no
/// allocation (only the text of an error allocates).
///
/// Replies have no frame, so a byte too many or too few would shift all that follow. Therefore: one
/// request in flight; start() before each; any byte after a complete reply counts as stray; after
/// an error the caller waits until the line is quiet and starts anew.
class ReplyParser {
 public:
  enum class State : std::uint8_t {
    Idle,      ///< Nothing was asked: whatever comes is stray.
    Waiting,   ///< The reply is not complete.
    Complete,  ///< reply() holds it.
    Corrupt,   ///< What came cannot be the reply; reply() says why.
  };

  /// Expects the reply to `request`. A request without a reply is complete at once, unless the
  /// board echoes or prompts.
  void start(const Request& request, const Profile& profile);

  /// Takes the next byte of the line.
  State push(std::uint8_t byte);

  /// Says that the line has been quiet: ends a list on a board without a prompt; a reply that still
  /// lacks bytes becomes Corrupt. When nothing at all came it stays Waiting: that is a time-out.
  State quiet();

  [[nodiscard]] State state() const { return state_; }
  /// The reply once Complete. Corrupt gives what was wrong; before that, Timeout.
  [[nodiscard]] Result<Reply> reply() const;
  /// The lines of a List reply, once Complete. Valid until the next start().
  [[nodiscard]] std::string_view text() const { return {text_.data(), length_}; }
  /// Bytes that belonged to no reply, since construction.
  [[nodiscard]] std::uint32_t stray() const { return stray_; }

 private:
  enum class Fault : std::uint8_t { None, Echo, TooLong, Number, Range, Version, Short, Prompt };

  State fail_with(Fault fault);
  State push_raw(std::uint8_t byte);
  State push_text(std::uint8_t byte);
  State finish_raw();
  State finish_line();
  bool take_value(std::size_t index, int value);
  [[nodiscard]] bool ends_with_prompt() const;

  Profile profile_{};
  const Command* command_ = nullptr;
  RequestBytes echo_{};
  std::size_t echoed_ = 0;
  State state_ = State::Idle;
  Fault fault_ = Fault::None;
  std::array<char, kMaxReplyText> text_{};
  std::size_t length_ = 0;
  bool any_ = false;  ///< A byte came since start().
  Reply reply_{};
  std::uint32_t stray_ = 0;
};

}  // namespace eyebridge::bridges::io7
