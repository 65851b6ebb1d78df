// Remarks and attributes: what a file says of its messages besides their layout.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include "dbc_reader.hpp"

namespace eyebridge::bridges::dbc {
namespace {

constexpr std::string_view kPeriod = "GenMsgCycleTime";
constexpr std::string_view kDelay = "GenMsgStartDelayTime";
constexpr std::string_view kFormat = "VFrameFormat";
constexpr std::string_view kLongMessage = "SystemMessageLongSymbol";
constexpr std::string_view kLongSignal = "SystemSignalLongSymbol";

/// Milliseconds above 0; none for anything else.
std::optional<int> milliseconds(const std::string& text) {
  constexpr double kMost = 1e9;
  double value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || !(value >= 0.5) || value > kMost) return std::nullopt;
  return static_cast<int>(std::lround(value));
}

bool is_owner(std::string_view word) {
  return word == "BO_" || word == "SG_" || word == "BU_" || word == "EV_";
}

}  // namespace

Reader::Owner Reader::owner(std::string_view kind) {
  Owner out{kind};
  if (kind == "BO_" || kind == "SG_") out.message = message_reference();
  if (kind == "SG_") out.signal = signal_reference(out.message);
  if (kind == "BU_" || kind == "EV_") (void)scan_.word("a name");
  return out;
}

/// CM_ SG_ 100 Name "text";
void Reader::comment() {
  Owner of;
  if (is_owner(scan_.peek_word())) of = owner(scan_.word("a kind"));
  std::string text = scan_.text("a remark in quotes");
  scan_.end_statement();
  if (of.signal != nullptr) {
    of.signal->comment = std::move(text);
  } else if (of.kind == "BO_" && of.message != nullptr) {
    of.message->comment = std::move(text);
  }
}

/// BA_DEF_ BO_ "VFrameFormat" ENUM "StandardCAN","ExtendedCAN";
void Reader::definition() {
  if (is_owner(scan_.peek_word())) (void)scan_.word("a kind");
  const std::string name = scan_.text("the attribute's name in quotes");
  const std::string_view type = scan_.word("INT, HEX, FLOAT, STRING or ENUM");
  if (type != "ENUM") return scan_.skip_statement();
  std::vector<std::string>& names = enumerations_[name];
  names.clear();
  while (scan_.peek() == '"') {
    names.push_back(scan_.text("a value in quotes"));
    scan_.take(',');
  }
  scan_.end_statement();
}

std::string Reader::attribute_value() {
  if (scan_.peek() == '"') return scan_.text("a value");
  return std::string(scan_.word("a value"));
}

void Reader::default_value() {
  const std::string name = scan_.text("the attribute's name in quotes");
  defaults_[name] = attribute_value();
  scan_.end_statement();
}

/// BA_ "GenMsgCycleTime" BO_ 100 20;
void Reader::attribute() {
  const std::string name = scan_.text("the attribute's name in quotes");
  Owner of;
  if (is_owner(scan_.peek_word())) of = owner(scan_.word("a kind"));
  const std::string value = attribute_value();
  scan_.end_statement();
  apply(name, value, of);
}

void Reader::apply(const std::string& name, const std::string& value, const Owner& owner) {
  const bool is_long = (name == kLongMessage && owner.kind == "BO_") || name == kLongSignal;
  if (owner.message == nullptr || (owner.kind == "SG_" && owner.signal == nullptr)) return;
  Message& message = *owner.message;
  const auto index = static_cast<std::size_t>(&message - database_.messages.data());
  if (is_long && !value.empty()) {
    std::optional<std::size_t> signal;
    if (owner.signal != nullptr) {
      signal = static_cast<std::size_t>(owner.signal - message.signals.data());
    }
    long_names_.push_back({index, signal, value});
  }
  if (owner.kind != "BO_") return;
  told_[name].push_back(index);
  set(message, name, value);
}

void Reader::set(Message& message, std::string_view name, const std::string& value) const {
  if (name == kPeriod) message.period_ms = milliseconds(value);
  if (name == kDelay) message.start_delay_ms = milliseconds(value);
  if (name == kFormat) message.fd = message.fd || is_fd_format(value);
}

/// A format is told by its name, or by its number in the list of them.
bool Reader::is_fd_format(const std::string& value) const {
  const auto names = enumerations_.find(kFormat);
  std::size_t index = 0;
  const char* const end = value.data() + value.size();
  const auto [stop, error] = std::from_chars(value.data(), end, index);
  const bool is_number = error == std::errc{} && stop == end;
  if (is_number && names != enumerations_.end()) {
    return index < names->second.size() && names->second[index].ends_with("_FD");
  }
  // Without the list: the numbers that Vector's own has.
  return is_number ? index == 14 || index == 15 : value.ends_with("_FD");
}

void Reader::apply_defaults() {
  for (const std::string_view name : {kPeriod, kDelay, kFormat}) {
    const auto found = defaults_.find(name);
    if (found == defaults_.end()) continue;
    std::vector<bool> is_told(database_.messages.size());
    for (const std::size_t index : told_[found->first]) is_told[index] = true;
    for (std::size_t i = 0; i < is_told.size(); ++i) {
      if (!is_told[i]) set(database_.messages[i], name, found->second);
    }
  }
}

void Reader::apply_long_names() {
  for (const LongName& each : long_names_) {
    Message& message = database_.messages[each.message];
    (each.signal ? message.signals[*each.signal].name : message.name) = each.name;
  }
}

}  // namespace eyebridge::bridges::dbc
