#include "dbc_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "dbc_text.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/bridges/can_frame.hpp"
#include "eyebridge/bridges/dbc/read_dbc.hpp"

namespace eyebridge::bridges::dbc {
namespace {

constexpr std::uint64_t kExtendedBit = 0x8000'0000;
/// Message of signals that belong to none, as Vector's editor writes it.
constexpr std::uint64_t kNoMessage = 0xC000'0000;
constexpr std::uint64_t kLongestMessage = 65'535;  // of transport protocols over many frames
constexpr int kDeepest = 16;                       // multiplexers over one another

}  // namespace

const std::vector<Reader::Statement>& Reader::statements() {
  static const std::vector<Statement> all{{"NS_", &Reader::symbols, true},
                                          {"VERSION", &Reader::version, true},
                                          {"BU_", &Reader::nodes, true},
                                          {"BO_", &Reader::message, true},
                                          {"SG_", &Reader::signal, true},
                                          {"SG_MUL_VAL_", &Reader::selection, false},
                                          {"SIG_VALTYPE_", &Reader::value_type, false},
                                          {"VAL_TABLE_", &Reader::value_table, false},
                                          {"VAL_", &Reader::values, false},
                                          {"CM_", &Reader::comment, false},
                                          {"BA_DEF_", &Reader::definition, false},
                                          {"BA_DEF_DEF_", &Reader::default_value, false},
                                          {"BA_", &Reader::attribute, false}};
  return all;
}

Database Reader::read() {
  scan_.cross_lines(true);
  while (!scan_.at_end()) {
    read_statement();
    scan_.cross_lines(true);
  }
  apply_defaults();
  for (Message& each : database_.messages) resolve(each);
  apply_long_names();
  return std::move(database_);
}

void Reader::read_statement() {
  const std::string_view keyword = scan_.peek_word();
  if (keyword.starts_with("//")) return scan_.skip_line();
  const auto known = std::ranges::find(statements(), keyword, &Statement::keyword);
  if (known == statements().end()) return scan_.skip_statement();
  (void)scan_.word("a keyword");
  scan_.cross_lines(!known->ends_with_line);
  (this->*known->read)();
}

/// NS_: keywords of the file, one a line.
void Reader::symbols() {
  scan_.take(':');
  while (scan_.at_line_end()) {
    scan_.skip_line();
    const std::size_t begin = scan_.position();
    if (scan_.at_end()) return;
    if (!scan_.peek_word().empty()) (void)scan_.word("a keyword");
    if (!scan_.at_line_end()) return scan_.back_to(begin);
  }
}

void Reader::version() {
  database_.version = scan_.text("a version in quotes");
  scan_.take(';');
}

void Reader::nodes() {
  scan_.expect(':');
  while (!scan_.at_line_end()) {
    if (scan_.take(',') || scan_.take(';')) continue;
    database_.nodes.emplace_back(scan_.word("the name of a node"));
  }
}

/// BO_ 2566844672 Name: 8 Sender
void Reader::message() {
  Message out;
  out.line = scan_.line();
  const std::size_t at = scan_.position();
  const std::uint64_t number = scan_.whole("an identifier, 0 … 4294967295", 0xFFFF'FFFF);
  out.name = scan_.word("the name of the message");
  scan_.expect(':');
  out.length = static_cast<int>(scan_.whole("a length in bytes", kLongestMessage));
  if (!scan_.at_line_end()) out.sender = scan_.word("the sender");
  after_message_ = true;
  in_message_ = number != kNoMessage;
  if (!in_message_) return;
  const std::uint64_t id = number & ~kExtendedBit;
  if (id > CanFrame::kMaxExtendedId) {
    scan_.refuse_at(at, "found the identifier " + std::to_string(number) +
                            ", expected 11 bits, or 29 bits and bit 31");
  }
  out.id = static_cast<std::uint32_t>(id);
  // Some files leave bit 31 out; there is no other way to send such an identifier.
  out.extended = (number & kExtendedBit) != 0 || id > CanFrame::kMaxStandardId;
  out.fd = out.length > static_cast<int>(CanFrame::kMaxClassic);
  by_number_.emplace(number, database_.messages.size());
  database_.messages.push_back(std::move(out));
}

/// SG_ Name m1 : 7|16@0- (0.1,0) [-100|100] "m/s"  Receiver, Receiver
void Reader::signal() {
  if (!after_message_) {
    scan_.refuse_at(scan_.position(), "found a signal, expected its message before it: BO_");
  }
  Signal out;
  out.line = scan_.line();
  out.name = scan_.word("the name of the signal");
  if (scan_.peek() != ':') {
    const std::size_t at = scan_.position();
    const std::string_view mark = scan_.word("':', M, or m and a number");
    if (mark.empty() || (mark.front() != 'm' && mark != "M")) {
      scan_.refuse_at(at, "found " + in_quotes(mark) + ", expected ':', M, or m and a number");
    }
    multiplex_line(out, mark);
  }
  scan_.expect(':');
  out.start = static_cast<int>(scan_.whole("its first bit", kLongestMessage * 8));
  scan_.expect('|');
  const std::size_t at = scan_.position();
  const std::uint64_t length = scan_.whole("its length in bits", kLongestMessage * 8);
  if (length == 0) scan_.refuse_at(at, "found a signal of 0 bits, expected 1 or more");
  scan_.expect('@');
  out.order =
      scan_.whole("0 (Motorola) or 1 (Intel)", 1) == 0 ? ByteOrder::Motorola : ByteOrder::Intel;
  if (scan_.take('-')) {
    out.kind = NumberKind::Signed;
  } else {
    scan_.expect('+');
  }
  scan_.expect('(');
  out.factor = scan_.number("a factor");
  scan_.expect(',');
  out.offset = scan_.number("an offset");
  scan_.expect(')');
  scan_.expect('[');
  out.minimum = scan_.number("the smallest value");
  scan_.expect('|');
  out.maximum = scan_.number("the largest value");
  scan_.expect(']');
  out.unit = scan_.text("a unit in quotes");
  while (!scan_.at_line_end()) {
    if (scan_.take(',') || scan_.take(';')) continue;
    out.receivers.emplace_back(scan_.word("a receiver"));
  }
  // Longer ones are texts, over many frames.
  if (!in_message_ || length > 64) return;
  out.length = static_cast<int>(length);
  database_.messages.back().signals.push_back(std::move(out));
}

/// M, m12, m12M
void Reader::multiplex_line(Signal& signal, std::string_view mark) {
  signal.multiplexer = mark.back() == 'M';
  if (mark.front() == 'M') return;
  if (signal.multiplexer) mark.remove_suffix(1);
  std::uint64_t value = 0;
  const char* const end = mark.data() + mark.size();
  const auto [stop, error] = std::from_chars(mark.data() + 1, end, value);
  if (error != std::errc{} || stop != end) scan_.refuse("m and a number before this");
  signal.selected_by = {{value, value}};
}

Message* Reader::message_reference() {
  const auto found = by_number_.find(scan_.whole("the identifier of a message", 0xFFFF'FFFF));
  return found == by_number_.end() ? nullptr : &database_.messages[found->second];
}

Signal* Reader::signal_reference(Message* message) {
  const std::string_view name = scan_.word("the name of a signal");
  if (message == nullptr) return nullptr;
  const auto found = std::ranges::find(message->signals, name, &Signal::name);
  return found == message->signals.end() ? nullptr : &*found;
}

/// SG_MUL_VAL_ 100 Name Multiplexer 0-3, 7-7;
void Reader::selection() {
  Message* const message = message_reference();
  Signal* const signal = signal_reference(message);
  const Signal* const selector = signal_reference(message);
  std::vector<SelectorRange> ranges;
  do {
    SelectorRange& range = ranges.emplace_back();
    range.first = scan_.whole("a number of the multiplexer", UINT64_MAX);
    scan_.expect('-');
    range.last = scan_.whole("a number of the multiplexer", UINT64_MAX);
  } while (scan_.take(','));
  scan_.end_statement();
  if (signal == nullptr || selector == nullptr) return;
  signal->selector = static_cast<std::size_t>(selector - message->signals.data());
  signal->selected_by = std::move(ranges);
}

/// SIG_VALTYPE_ 100 Name : 1;
void Reader::value_type() {
  Signal* const signal = signal_reference(message_reference());
  scan_.take(':');
  const std::size_t at = scan_.position();
  const std::uint64_t type = scan_.whole("0 (integer), 1 (float) or 2 (double)", 3);
  scan_.end_statement();
  if (signal == nullptr || type == 0 || type == 3) return;
  if (signal->length != (type == 1 ? 32 : 64)) {
    scan_.refuse_at(at, "found a float of " + std::to_string(signal->length) + " bits, expected " +
                            (type == 1 ? "32" : "64"));
  }
  signal->kind = type == 1 ? NumberKind::Float32 : NumberKind::Float64;
}

std::vector<NamedValue> Reader::named_values() {
  constexpr double kMost = 9e18;
  std::vector<NamedValue> out;
  for (char next = scan_.peek(); next == '-' || next == '+' || (next >= '0' && next <= '9');
       next = scan_.peek()) {
    const double value = std::clamp(scan_.number("a value"), -kMost, kMost);
    out.push_back({std::llround(value), scan_.text("the value's name in quotes")});
  }
  return out;
}

void Reader::value_table() {
  const std::string name(scan_.word("the name of the table"));
  tables_[name] = named_values();
  scan_.end_statement();
}

/// VAL_ 100 Name 0 "Off" 1 "On"; or of an environment variable.
void Reader::values() {
  const std::string_view first = scan_.peek_word();
  if (first.empty() || first.front() < '0' || first.front() > '9') return scan_.skip_statement();
  Signal* const signal = signal_reference(message_reference());
  std::vector<NamedValue> found = named_values();
  if (found.empty() && !scan_.peek_word().empty()) {
    const auto table = tables_.find(scan_.peek_word());
    if (table == tables_.end()) scan_.refuse("values, or the name of a VAL_TABLE_");
    (void)scan_.word("the name of a VAL_TABLE_");
    found = table->second;
  }
  scan_.end_statement();
  if (signal != nullptr) signal->values = std::move(found);
}

void Reader::resolve(Message& message) {
  const auto refuse = [&](const Signal& signal, const std::string& text) {
    SourceLocation where = scan_.place(0);
    throw ConfigError({where.file, signal.line, 0}, signal.name + " " + text);
  };
  const auto root = std::ranges::find_if(message.signals, [](const Signal& signal) {
    return signal.multiplexer && signal.selected_by.empty();
  });
  for (Signal& each : message.signals) {
    if (each.selected_by.empty() || each.selector) continue;
    if (root == message.signals.end()) {
      refuse(each, "is selected by a multiplexer, expected one (M) in " + message.name);
    }
    each.selector = static_cast<std::size_t>(root - message.signals.begin());
  }
  for (const Signal& each : message.signals) {
    const Signal* above = &each;
    for (int depth = 0; above->selector; ++depth) {
      if (depth == kDeepest) refuse(each, "is selected in a circle, expected an end of it");
      above = &message.signals[*above->selector];
    }
  }
}

Database read_dbc(std::string_view text, const std::string& file) {
  const std::string utf8 = to_utf8(text);
  return Reader(utf8, file).read();
}

}  // namespace eyebridge::bridges::dbc
