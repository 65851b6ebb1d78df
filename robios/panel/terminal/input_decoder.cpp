#include "terminal/input_decoder.hpp"

namespace eyebridge::robios {
namespace {

constexpr std::uint8_t kEscape = 0x1B;
// Bits of a button: its number, keys held meanwhile, motion, wheel and further buttons.
constexpr int kButtonBits = 0x03;
constexpr int kNoPress = 0x20 | 0x40 | 0x80;
constexpr int kOldOffset = 32;  // X10 adds this to button, column and row, so that all are visible
constexpr int kMostNumber = 100'000;

std::optional<TerminalEvent> click(int button, int column, int row) {
  if ((button & (kButtonBits | kNoPress)) != 0 || column < 1 || row < 1) return std::nullopt;
  return TerminalEvent{0, column - 1, row - 1};
}

/// The remote control's key (eyebot.h: IRTV_…) that a character stands for, or 0.
int remote_of_character(std::uint8_t byte) {
  if (byte >= '0' && byte <= '9') return byte;
  switch (byte) {
    case 'r':
    case 'g':
    case 'y':
    case 'b':
    case 'p':
      return byte - 'a' + 'A';
    case 'R':
    case 'G':
    case 'Y':
    case 'B':
    case 'P':
      return byte;
    case '\r':
    case '\n':
      return 'O';
    default:
      return 0;
  }
}

/// Likewise the last byte of an arrow's sequence.
std::optional<TerminalEvent> arrow(std::uint8_t byte) {
  if (byte < 'A' || byte > 'D') return std::nullopt;
  return TerminalEvent{0, 0, 0, "UD>L"[byte - 'A']};
}

}  // namespace

std::optional<TerminalEvent> InputDecoder::push(std::uint8_t byte) {
  if (byte == kEscape && state_ != State::OldMouse) {
    state_ = State::Escape;
    return std::nullopt;
  }
  switch (state_) {
    case State::Escape:
      if (byte == '[') {
        begin_control();
        return std::nullopt;
      }
      state_ = byte == 'O' ? State::Function : State::Ground;
      if (byte == 'O') return std::nullopt;
      break;  // a lone Escape, or a key held with Alt: the character counts
    case State::Function:
      state_ = State::Ground;
      return arrow(byte);
    case State::Control:
      return control_byte(byte);
    case State::OldMouse:
      old_mouse_.at(count_++) = byte;
      if (count_ < old_mouse_.size()) return std::nullopt;
      state_ = State::Ground;
      return click(old_mouse_[0] - kOldOffset, old_mouse_[1] - kOldOffset,
                   old_mouse_[2] - kOldOffset);
    case State::Ground:
      break;
  }
  return typed(byte);
}

std::optional<TerminalEvent> InputDecoder::typed(std::uint8_t byte) {
  const int remote = remote_of_character(byte);
  if (remote == 0) return std::nullopt;
  const bool is_key = byte >= '1' && byte <= '4';
  return TerminalEvent{is_key ? 1 << (byte - '1') : 0, 0, 0, remote};
}

void InputDecoder::begin_control() {
  state_ = State::Control;
  is_sgr_ = false;
  is_bare_ = true;
  numbers_ = {};
  count_ = 1;
}

std::optional<TerminalEvent> InputDecoder::control_byte(std::uint8_t byte) {
  const bool bare = is_bare_;
  is_bare_ = false;
  if (byte >= 0x40 && byte <= 0x7E) {  // the last byte
    state_ = State::Ground;
    if (byte == 'M' && bare) {
      state_ = State::OldMouse;
      count_ = 0;
    }
    if (bare) return arrow(byte);
    return byte == 'M' && is_sgr_ ? sgr_click() : std::nullopt;
  }
  if (byte < 0x20 || byte > 0x7E) {  // a control character, or no ASCII at all: broken off
    state_ = State::Ground;
  } else if (byte == '<' && bare) {
    is_sgr_ = true;
  } else if (byte == ';') {
    ++count_;
    if (count_ > numbers_.size()) is_sgr_ = false;
  } else if (byte >= '0' && byte <= '9' && is_sgr_) {
    int& number = numbers_.at(count_ - 1);
    number = number * 10 + (byte - '0');
    if (number > kMostNumber) is_sgr_ = false;
  } else {
    is_sgr_ = false;
  }
  return std::nullopt;
}

std::optional<TerminalEvent> InputDecoder::sgr_click() const {
  if (count_ != numbers_.size()) return std::nullopt;
  return click(numbers_[0], numbers_[1], numbers_[2]);
}

}  // namespace eyebridge::robios
