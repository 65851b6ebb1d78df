#include "eyebridge/bridges/io7/probe.hpp"

#include <algorithm>
#include <array>

#include "eyebridge/bridges/io7/help_list.hpp"
#include "opcodes.h"
#include "text.hpp"

namespace eyebridge::bridges::io7 {
namespace {

constexpr int kEnters = 3;
constexpr std::size_t kHearings = 9;  ///< Of what a line spoils each time.
constexpr int kSpoiltLists = 9;       ///< In a row, which are no lists at all.
constexpr int kLowestBattery = 50;    // 0.5 V, in 10 mV; the highest is IO7_VOLTAGE_LAST.
constexpr std::array kTerminators = {Terminator::Cr, Terminator::Lf, Terminator::CrLf};

std::string_view after_last_line_end(std::string_view text) {
  const std::size_t end = text.find_last_of("\r\n");
  return end == std::string_view::npos ? text : text.substr(end + 1);
}

bool has_line_end(std::string_view text) {
  return std::any_of(text.begin(), text.end(), is_line_end);
}

bool all_printable(std::string_view text) {
  return std::all_of(text.begin(), text.end(), is_printable);
}

/// Both readings of two bytes.
struct Readings {
  int msb_first;
  int lsb_first;
};
Readings readings(std::string_view body) {
  const int first = static_cast<unsigned char>(body[0]);
  const int second = static_cast<unsigned char>(body[1]);
  return {first << 8 | second, second << 8 | first};
}

}  // namespace

Probe::Probe() {
  expect_ = "a prompt, or nothing";
  send("\r");
}

Probe::Step Probe::step() const { return {send_.view(), expect_}; }

void Probe::send(std::string_view text) {
  send_.length = static_cast<std::uint8_t>(text.size());
  std::copy(text.begin(), text.end(), send_.bytes.begin());
}

void Probe::send_line_end() {
  const auto end = bytes_of(report_.profile.terminator);
  send({reinterpret_cast<const char*>(end.data()), end.size()});
}

bool Probe::send(const Request& request) {
  const auto bytes = encode(request, report_.profile);
  if (bytes) send_ = *bytes;
  return bytes.has_value();
}

void Probe::give_up(Errc code, std::string what) {
  error_ = {code, "IO7 probe: " + std::move(what)};
  state_ = State::Failed;
}

void Probe::retry_or_fail(std::string_view body, std::string_view expected) {
  if (++attempts_ < 2) {  // The same bytes once more.
    ++report_.repeats;
    return;
  }
  give_up(body.empty() ? Errc::Timeout : Errc::Corrupt,
          "expected " + std::string(expected) + ", found " + quoted(body));
}

Result<ProbeReport> Probe::report() const {
  if (state_ == State::Done) return report_;
  if (state_ == State::Failed) return tl::unexpected(error_);
  return fail(Errc::Timeout, "IO7 probe: not finished");
}

std::string_view Probe::without_echo(std::string_view body) const {
  if (report_.profile.echo && !body.empty()) {
    const std::string_view sent(reinterpret_cast<const char*>(send_.bytes.data()), send_.length);
    const std::string_view bare = trim(sent);
    if (body.starts_with(sent)) {
      body.remove_prefix(sent.size());
    } else if (body.starts_with(bare)) {
      body.remove_prefix(bare.size());
    }
    if (body.starts_with("\n")) body.remove_prefix(1);
  }
  return body;
}

std::string_view Probe::without_frame(std::string_view body) const {
  body = without_echo(body);
  const std::string_view prompt = report_.profile.prompt.view();
  // A raw reading may well end in the byte that is the prompt.
  const bool reading = state_ == State::Voltage || state_ == State::AsciiForm ||
                       state_ == State::BinaryForm || state_ == State::BinaryAgain;
  const bool prompts =
      !reading || report_.profile.reply_form == ReplyForm::Text || report_.profile.prompt_after_raw;
  if (prompts && !prompt.empty() && body.ends_with(prompt)) body.remove_suffix(prompt.size());
  return body;
}

void Probe::answer(std::span<const std::uint8_t> received) {
  const std::string_view body(reinterpret_cast<const char*>(received.data()), received.size());
  heard_ = heard_ || !body.empty();
  switch (state_) {
    case State::Enter:
      return answer_enter(body);
    case State::List:
      return answer_list(body);
    case State::Version:
    case State::VersionAgain:
      return answer_version(body);
    case State::Quieten:  // Whatever it says: the next `v` tells.
      attempts_ = 0;
      state_ = State::VersionAgain;
      expect_ = "the version, as text or as 4 bytes";
      send(request(IO7_VERSION));
      return;
    case State::Voltage:
      return answer_voltage(body);
    case State::OpenLine:
      return answer_open_line(body);
    case State::AsciiForm:
    case State::BinaryForm:
    case State::BinaryAgain:
      return answer_form(body);
    case State::LineEnd:  // Whatever it says to what was no line.
      return finish();
    case State::Done:
    case State::Failed:
      return;
  }
}

void Probe::answer_enter(std::string_view body) {
  const std::string_view tail = after_last_line_end(body);
  Prompt seen;
  if (tail.size() <= seen.bytes.size() && all_printable(tail)) {
    std::copy(tail.begin(), tail.end(), seen.bytes.begin());
    seen.length = static_cast<std::uint8_t>(tail.size());
  }
  const bool repeats = attempts_ > 0 && seen == report_.profile.prompt;
  report_.profile.prompt = seen;
  enter_ = body;
  if (++attempts_ < kEnters && !repeats) return;
  if (!repeats) report_.profile.prompt = {};
  attempts_ = 0;
  ask_list();
}

void Probe::ask_list() {
  state_ = State::List;
  expect_ = "a list of command letters";
  // The one letter that is sent without being listed: it is what asks for the list.
  report_.profile.terminator = kTerminators[static_cast<std::size_t>(attempts_) / 2];
  report_.profile.letters = LetterSet("h");
  send(request(IO7_HELP));
}

void Probe::answer_list(std::string_view body) {
  const std::string_view text = without_frame(body);
  const auto letters = parse_help(text);
  if (!letters && !lists_.empty() && ++attempts_ < kSpoiltLists) {
    ++report_.repeats;
    return;  // The same bytes once more.
  }
  if (!letters) {
    if (lists_.empty() && static_cast<std::size_t>(++attempts_) < 2 * kTerminators.size()) {
      ++report_.repeats;
      return ask_list();
    }
    if (!heard_) return give_up(Errc::Timeout, "the board is silent");
    return give_up(Errc::Corrupt, letters.error().what);
  }
  const bool is_heard_before = report_.list == text;
  report_.list = std::string(text);
  lists_.push_back(*letters);
  if (!is_heard_before && lists_.size() < kHearings) {
    attempts_ = 0;
    report_.repeats += lists_.size() > 1;
    return;
  }
  report_.profile.letters = is_heard_before ? *letters : mostly_heard();
  attempts_ = 0;
  if (!send(request(IO7_VERSION))) {
    return give_up(Errc::Unsupported, "the board lists no 'v', expected it to tell the reply form");
  }
  state_ = State::Version;
  expect_ = "the version, as text or as 4 bytes";
}

LetterSet Probe::mostly_heard() const {
  LetterSet letters;
  for (char letter = 'A'; letter <= 'z'; ++letter) {
    const auto heard =
        std::ranges::count_if(lists_, [&](const LetterSet& list) { return list.has(letter); });
    if (2 * static_cast<std::size_t>(heard) > lists_.size()) letters.insert(letter);
  }
  return letters;
}

void Probe::answer_version(std::string_view body) {
  Profile& profile = report_.profile;
  if (body.size() > 2 && body[0] == IO7_VERSION && is_line_end(body[1])) profile.echo = true;
  const std::string_view bare = without_frame(body);
  const bool raw = bare.size() == IO7_VERSION_LENGTH && all_printable(bare);
  const std::string_view text = after_label(bare);
  if (!raw && (!has_line_end(bare) || text.empty() || !all_printable(text))) {
    return retry_or_fail(body, "the version");
  }
  report_.version = std::string(raw ? bare : text);
  versions_.push_back(report_.version);
  if (std::ranges::count(versions_, report_.version) == 1) {
    if (versions_.size() == kHearings)
      return retry_or_fail(body, "the version that it told before");
    report_.repeats += versions_.size() > 1;
    return;  // The same bytes once more.
  }
  attempts_ = 0;
  profile.reply_form = raw ? ReplyForm::Raw : ReplyForm::Text;
  profile.prompt_after_raw =
      raw && !profile.prompt.view().empty() && body.ends_with(profile.prompt.view());
  if (state_ == State::VersionAgain) return ask_voltage();
  report_.was_verbose = !raw;
  if (raw || !quieten()) ask_voltage();
}

// A board that takes bytes has not understood it as a line: it is told again once that is known.
bool Probe::quieten() {
  if (!send(verbose(false))) return false;
  state_ = State::Quieten;
  expect_ = "anything; text replies are being switched off";
  return true;
}

void Probe::ask_voltage() {
  if (!send(request(IO7_VOLTAGE))) return ask_form();
  state_ = State::Voltage;
  expect_ = "the supply voltage";
}

std::optional<int> Probe::number_in(std::string_view body, std::size_t width) {
  const std::string_view bare = without_frame(body);
  if (report_.profile.reply_form == ReplyForm::Text) {
    int value = 0;
    const bool read = has_line_end(bare) && read_integers(after_label(bare), std::span(&value, 1));
    return read ? std::optional(value) : std::nullopt;
  }
  if (bare.size() != width) return std::nullopt;
  if (width == 1) return static_cast<unsigned char>(bare[0]);
  const auto [msb_first, lsb_first] = readings(bare);
  return report_.profile.byte_order == ByteOrder::MsbFirst ? msb_first : lsb_first;
}

void Probe::note_witness(char letter, std::string_view body) {
  const std::string_view bytes = without_frame(body);
  report_.byte_order_proven = true;
  report_.byte_order_witness = letter;
  std::copy_n(bytes.begin(), report_.witness_bytes.size(), report_.witness_bytes.begin());
}

void Probe::answer_voltage(std::string_view body) {
  auto value = number_in(body, 2);
  if (!value) return retry_or_fail(body, "the supply voltage");
  if (report_.profile.reply_form == ReplyForm::Raw) {
    const auto [msb_first, lsb_first] = readings(without_frame(body));
    const auto plausible = [](int v) { return v >= kLowestBattery && v <= IO7_VOLTAGE_LAST; };
    if (plausible(msb_first) != plausible(lsb_first)) {
      note_witness(IO7_VOLTAGE, body);
      report_.profile.byte_order = plausible(msb_first) ? ByteOrder::MsbFirst : ByteOrder::LsbFirst;
      value = number_in(body, 2);
    }
  }
  report_.battery_cv = value;
  ask_form();
}

void Probe::ask_form() {
  attempts_ = 0;
  // Readings only, and first the one that also witnesses the byte order.
  for (const Request& reading : {analog(0), psd(1), encoder(1), digital_in(0)}) {
    if (!send(reading)) continue;
    form_request_ = reading;
    send_.length =
        static_cast<std::uint8_t>(send_.length - bytes_of(report_.profile.terminator).size());
    state_ = State::OpenLine;
    expect_ = "nothing yet, if requests are text";
    return;
  }
  state_ = State::Done;
}

void Probe::answer_open_line(std::string_view body) {
  if (!without_echo(body).empty()) return try_bytes();
  state_ = State::AsciiForm;
  expect_ = "a reading, if requests are text";
  send_line_end();
}

void Probe::try_bytes() {
  report_.profile.request_form = RequestForm::Binary;
  state_ = State::BinaryForm;
  expect_ = "a reading, if requests are bytes";
  send(form_request_);
}

void Probe::answer_form(std::string_view body) {
  Profile& profile = report_.profile;
  const Field& field = find_command(form_request_.letter)->values()[0];
  auto value = number_in(body, field.width);
  if (value && profile.reply_form == ReplyForm::Raw && !report_.byte_order_proven &&
      field.last == IO7_ADC_LAST) {
    const auto [msb_first, lsb_first] = readings(without_frame(body));
    if ((msb_first > IO7_ADC_LAST) != (lsb_first > IO7_ADC_LAST)) {
      note_witness(form_request_.letter, body);
      profile.byte_order = lsb_first > IO7_ADC_LAST ? ByteOrder::MsbFirst : ByteOrder::LsbFirst;
      value = std::min(msb_first, lsb_first);
    }
  }
  const bool good = value && *value >= field.first && *value <= field.last;
  if (state_ == State::AsciiForm && (!good || body == enter_)) return try_bytes();
  if (state_ == State::BinaryAgain && without_echo(body).empty()) {
    // The first answer was a late one to the line; the bytes still wait there for an end.
    profile.request_form = RequestForm::Ascii;
    state_ = State::LineEnd;
    expect_ = "anything";
    return send_line_end();
  }
  if (!good) {
    return give_up(Errc::Corrupt, std::string("no reading from '") + form_request_.letter +
                                      "' in either request form, found " + quoted(body));
  }
  if (state_ == State::BinaryForm) {
    state_ = State::BinaryAgain;
    expect_ = "the reading again: the first one may have been late";
    send(form_request_);
    return;
  }
  finish();
}

void Probe::finish() {
  const Profile& profile = report_.profile;
  report_.request_form_proven = true;
  const bool is_quiet =
      profile.request_form == RequestForm::Ascii || profile.reply_form == ReplyForm::Raw;
  if (is_quiet || !quieten()) state_ = State::Done;
}

}  // namespace eyebridge::bridges::io7
