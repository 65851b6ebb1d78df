#include "eyebridge/bridges/io7/reply_parser.hpp"

#include <algorithm>
#include <string>

#include "text.hpp"

namespace eyebridge::bridges::io7 {

void ReplyParser::start(const Request& request, const Profile& profile) {
  profile_ = profile;
  command_ = find_command(request.letter);
  echoed_ = 0;
  length_ = 0;
  any_ = false;
  fault_ = Fault::None;
  reply_ = Reply{.letter = request.letter};
  echo_ = RequestBytes{};
  state_ = State::Idle;
  if (command_ == nullptr) return;
  if (profile.echo) {
    if (const auto sent = encode(request, profile)) echo_ = *sent;
    // Interactive boards answer Enter with a line end of their own: it is skipped like a blank
    // line.
    if (profile.reply_form == ReplyForm::Text && profile.request_form == RequestForm::Ascii) {
      const auto end = bytes_of(profile.terminator).size();
      if (echo_.length > end) echo_.length = static_cast<std::uint8_t>(echo_.length - end);
    }
  }
  const bool text = profile.reply_form == ReplyForm::Text || command_->reply == ReplyKind::List;
  const bool prompts = !profile.prompt.view().empty() && (text || profile.prompt_after_raw);
  const bool silent = command_->reply == ReplyKind::None && echo_.length == 0 && !prompts;
  state_ = silent ? State::Complete : State::Waiting;
}

ReplyParser::State ReplyParser::fail_with(Fault fault) {
  fault_ = fault;
  return state_ = State::Corrupt;
}

ReplyParser::State ReplyParser::push(std::uint8_t byte) {
  if (state_ != State::Waiting) {
    // The second half of CR LF after a line that was complete at its CR.
    const bool rest_of_line = state_ == State::Complete && profile_.reply_form == ReplyForm::Text &&
                              is_line_end(static_cast<char>(byte));
    if (!rest_of_line) ++stray_;
    return state_;
  }
  any_ = true;
  if (echoed_ < echo_.length) {
    if (byte != echo_.bytes[echoed_]) return fail_with(Fault::Echo);
    ++echoed_;
    const bool prompts = !profile_.prompt.view().empty() &&
                         (profile_.reply_form == ReplyForm::Text || profile_.prompt_after_raw);
    if (echoed_ == echo_.length && command_->reply == ReplyKind::None && !prompts) {
      state_ = State::Complete;
    }
    return state_;
  }
  const bool text = profile_.reply_form == ReplyForm::Text || command_->reply == ReplyKind::List;
  return text ? push_text(byte) : push_raw(byte);
}

ReplyParser::State ReplyParser::push_raw(std::uint8_t byte) {
  text_[length_++] = static_cast<char>(byte);
  const std::size_t body = command_->raw_reply_length();
  const std::string_view prompt =
      profile_.prompt_after_raw ? profile_.prompt.view() : std::string_view{};
  if (length_ > body && static_cast<char>(byte) != prompt[length_ - body - 1]) {
    return fail_with(Fault::Prompt);
  }
  return length_ == body + prompt.size() ? finish_raw() : state_;
}

ReplyParser::State ReplyParser::finish_raw() {
  std::size_t at = 0;
  const auto next = [&] { return static_cast<int>(static_cast<unsigned char>(text_[at++])); };
  if (command_->reply == ReplyKind::Version) {
    std::copy_n(text_.begin(), reply_.version.size(), reply_.version.begin());
    if (!std::all_of(reply_.version.begin(), reply_.version.end(), is_printable)) {
      return fail_with(Fault::Version);
    }
  }
  for (std::size_t i = 0; i < command_->value_count; ++i) {
    const Field& field = command_->value_fields[i];
    int value = next();
    if (field.width == 2) {
      const int second = next();
      value =
          profile_.byte_order == ByteOrder::MsbFirst ? value << 8 | second : second << 8 | value;
    }
    if (field.first < 0 && value >= 1 << (8 * field.width - 1)) value -= 1 << (8 * field.width);
    if (!take_value(i, value)) return state_;
  }
  return state_ = State::Complete;
}

bool ReplyParser::take_value(std::size_t index, int value) {
  const Field& field = command_->value_fields[index];
  // Text may show a 16-bit counter with its sign.
  if (field.last == IO7_COUNTER_LAST && value < 0 && value >= -(IO7_COUNTER_LAST + 1) / 2) {
    value += IO7_COUNTER_LAST + 1;
  }
  if (value < field.first || value > field.last) {
    fail_with(Fault::Range);
    return false;
  }
  reply_.values[index] = value;
  reply_.count = static_cast<std::uint8_t>(index + 1);
  return true;
}

bool ReplyParser::ends_with_prompt() const {
  const std::string_view all = text();
  const std::string_view prompt = profile_.prompt.view();
  if (prompt.empty() || !all.ends_with(prompt)) return false;
  return all.size() == prompt.size() || is_line_end(all[all.size() - prompt.size() - 1]);
}

ReplyParser::State ReplyParser::push_text(std::uint8_t byte) {
  const char c = static_cast<char>(byte);
  if (length_ == 0 && is_line_end(c)) return state_;
  if (length_ == text_.size()) return fail_with(Fault::TooLong);
  text_[length_++] = c;
  if (!profile_.prompt.view().empty()) {
    if (!ends_with_prompt()) return state_;
    length_ -= profile_.prompt.length;
    return finish_line();
  }
  const bool line = is_line_end(c) && command_->reply != ReplyKind::List;
  return line ? finish_line() : state_;
}

ReplyParser::State ReplyParser::finish_line() {
  switch (command_->reply) {
    case ReplyKind::None:
    case ReplyKind::List:
      return state_ = State::Complete;
    case ReplyKind::Version: {
      const std::string_view version = after_label(text());
      if (version.size() != reply_.version.size() ||
          !std::all_of(version.begin(), version.end(), is_printable)) {
        return fail_with(Fault::Version);
      }
      std::copy(version.begin(), version.end(), reply_.version.begin());
      return state_ = State::Complete;
    }
    case ReplyKind::Values:
      break;
  }
  std::array<int, kMaxValues> values{};
  if (!read_integers(after_label(text()), std::span(values).first(command_->value_count))) {
    return fail_with(Fault::Number);
  }
  for (std::size_t i = 0; i < command_->value_count; ++i) {
    if (!take_value(i, values[i])) return state_;
  }
  return state_ = State::Complete;
}

ReplyParser::State ReplyParser::quiet() {
  if (state_ != State::Waiting || !any_) return state_;
  const bool whole_list = command_->reply == ReplyKind::List && echoed_ == echo_.length &&
                          length_ > 0 && is_line_end(text_[length_ - 1]);
  return whole_list ? finish_line() : fail_with(Fault::Short);
}

Result<Reply> ReplyParser::reply() const {
  if (state_ == State::Complete) return reply_;
  const std::string request = std::string("IO7 '") + reply_.letter + "': ";
  if (state_ != State::Corrupt) return fail(Errc::Timeout, request + "no reply");
  const char* expected = "";
  switch (fault_) {
    case Fault::None:
      break;
    case Fault::Echo:
      expected = "the echo differs from the request";
      break;
    case Fault::TooLong:
      expected = "the text does not end";
      break;
    case Fault::Number:
      expected = "expected a line with its numbers";
      break;
    case Fault::Range:
      expected = "a value is outside its range";
      break;
    case Fault::Version:
      expected = "expected 4 printable characters";
      break;
    case Fault::Short:
      expected = "the reply is too short";
      break;
    case Fault::Prompt:
      expected = "expected the prompt after it";
      break;
  }
  return fail(Errc::Corrupt, request + expected + ", found " + quoted(text()));
}

}  // namespace eyebridge::bridges::io7
