#include "fault/fault_script.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "config/entries.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/hal/device_kind.hpp"

namespace eyebridge::hal {
namespace {

struct EffectName {
  std::string_view name;
  FaultEffect effect;
};
constexpr std::array<EffectName, 4> kEffects = {{{"lose", FaultEffect::Lose},
                                                 {"drop", FaultEffect::Drop},
                                                 {"freeze", FaultEffect::Freeze},
                                                 {"delay", FaultEffect::Delay}}};

/// The words of one rule, taken from the left.
class Words {
 public:
  Words(std::string_view rule, SourceLocation where) : rest_(rule), where_(std::move(where)) {}

  std::string_view next() {
    rest_ = trimmed(rest_);
    const std::string_view word = rest_.substr(0, rest_.find_first_of(" \t"));
    rest_.remove_prefix(word.size());
    return word;
  }
  [[nodiscard]] std::string_view peek() const { return Words(*this).next(); }
  [[noreturn]] void reject(std::string_view found, const std::string& expected) const {
    throw ConfigError(where_, fmt::format("found {}, expected {}",
                                          found.empty() ? "nothing" : in_quotes(found), expected));
  }
  [[nodiscard]] Time duration(std::string_view text) const {
    return from_seconds(parse_duration(text, where_));
  }

 private:
  std::string_view rest_;
  SourceLocation where_;
};

std::optional<double> number(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

void read_device(Words& words, FaultRule& rule) {
  const std::string_view word = words.next();
  const std::size_t colon = word.find(':');
  rule.device = word.substr(0, colon);
  if (rule.device != "all" && std::ranges::find(kDeviceKinds, rule.device) == kDeviceKinds.end()) {
    words.reject(word, fmt::format("a device: all, {}", fmt::join(kDeviceKinds, ", ")));
  }
  if (colon == std::string_view::npos) return;
  const auto id = number(word.substr(colon + 1));
  if (!id || *id < 1 || *id > 99 || *id != static_cast<int>(*id)) {
    words.reject(word, "a device's number after the ':', 1 to 99");
  }
  rule.id = static_cast<int>(*id);
}

void read_effect(Words& words, FaultRule& rule) {
  const std::string_view word = words.next();
  const auto* row = std::ranges::find(kEffects, word, &EffectName::name);
  if (row == kEffects.end()) words.reject(word, "lose, freeze, drop PERCENT% or delay DURATION");
  rule.effect = row->effect;
  if (rule.effect == FaultEffect::Delay) rule.value = to_seconds(words.duration(words.next()));
  if (rule.effect == FaultEffect::Drop) {
    const std::string_view share = words.next();
    const auto percent =
        share.ends_with('%') ? number(share.substr(0, share.size() - 1)) : std::nullopt;
    if (!percent || !(*percent >= 0.0 && *percent <= 100.0)) {
      words.reject(share, "a share of the calls, 0% to 100%");
    }
    rule.value = *percent / 100.0;
  }
}

void read_times(Words& words, FaultRule& rule) {
  if (words.peek().empty()) return;
  const std::string_view word = words.next();
  if (!word.starts_with('@')) words.reject(word, "a time as in @2s or @2s..4s, or the rule's end");
  const std::size_t dots = word.find("..");
  rule.from = words.duration(word.substr(1, dots == std::string_view::npos ? dots : dots - 1));
  if (dots != std::string_view::npos) rule.to = words.duration(word.substr(dots + 2));
  if (rule.to <= rule.from) words.reject(word, "an end after the beginning");
  if (!words.peek().empty()) words.reject(words.peek(), "';' or the end after a rule");
}

}  // namespace

bool FaultRule::holds(std::string_view kind, int number, Time now) const {
  return (device == "all" || device == kind) && (id == 0 || id == number) && now >= from &&
         now < to;
}

FaultScript parse_fault_script(std::string_view text, const SourceLocation& where) {
  FaultScript script;
  for (const Entry& entry : split_entries(text, where)) {
    Words words(entry.text, entry.where);
    FaultRule rule;
    rule.text = entry.text;
    read_device(words, rule);
    read_effect(words, rule);
    read_times(words, rule);
    script.push_back(std::move(rule));
  }
  return script;
}

}  // namespace eyebridge::hal
