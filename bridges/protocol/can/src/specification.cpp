// The tables of SPECIFICATION.md.
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <string>
#include <string_view>

#include "eyebridge/bridges/can/generated.hpp"
#include "eyebridge/bridges/can/table.hpp"
#include "marked_part.hpp"
#include "signals.hpp"

namespace eyebridge::bridges::can {
namespace {

std::string hex_text(std::int64_t value, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%0*llX", digits, static_cast<unsigned long long>(value));
  return text;
}

/// Unit, scale, bank and range: all but the name and the place.
std::string kind_of(const Signal& signal) {
  std::string out;
  if (signal.scale != 1.0) {
    char text[32];
    std::snprintf(text, sizeof text, " ×%g", signal.scale);
    out += text;
  }
  if (!signal.unit.empty()) out += " " + std::string(signal.unit);
  const bool is_whole = signal.first == signals::lowest(signal.length, signal.is_signed) &&
                        signal.last == signals::highest(signal.length, signal.is_signed);
  if (!is_whole) {
    out += " [" + std::to_string(signal.first) + ".." + std::to_string(signal.last) +
           (signal.may_be_absent ? " or absent]" : "]");
  }
  if (signal.bank >= 0) out += " in bank " + std::to_string(signal.bank);
  return out;
}

std::string place_of(const Signal& signal) {
  return std::string(signal.name) + " " + std::to_string(signal.start) + ":" +
         std::to_string(signal.length) + (signal.is_signed ? "s" : "");
}

/// Psd12Raw without its number: names that differ in it alone are one series.
std::string series_of(std::string_view name) {
  std::string out(name);
  std::erase_if(out, [](unsigned char c) { return std::isdigit(c) != 0; });
  return out;
}

bool follows(const Signal& next, const Signal& before) {
  return next.start == before.start + before.length && next.length == before.length &&
         next.is_signed == before.is_signed && kind_of(next) == kind_of(before) &&
         next.name != series_of(next.name) && series_of(next.name) == series_of(before.name);
}

std::string signals_text(std::span<const Signal> all) {
  std::string out;
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::size_t last = i;
    while (last + 1 < all.size() && follows(all[last + 1], all[last])) ++last;
    out += (out.empty() ? "" : ", ") + place_of(all[i]);
    if (last - i >= 2) {
      i = last;
      out += " … " + place_of(all[i]);
    }
    out += kind_of(all[i]);
  }
  return out;
}

std::string messages_text() {
  std::string out =
      "| id | name | bytes | ms | signals | what | example |\n|---|---|---|---|---|---|---|\n";
  for (const MessageSpec& spec : messages()) {
    const int node = spec.last_node == kNodeAll ? kNodeAll : kFirstNode;
    out += "| " + hex_text(spec.id(node), 3) + " | " + std::string(spec.name) + " | " +
           std::to_string(spec.length) + " | " +
           (spec.period_ms == 0 ? "event" : std::to_string(spec.period_ms)) + " | " +
           signals_text(spec.signals) + " | " + std::string(spec.comment) + " | " +
           (spec.example.empty() ? "" : "`" + std::string(spec.example) + "` ") + "|\n";
  }
  return out;
}

std::string notes_text() {
  std::string out = "\n| signal | meaning |\n|---|---|\n";
  for (const MessageSpec& spec : messages()) {
    for (const Signal& signal : spec.signals) {
      if (signal.comment.empty()) continue;
      out += "| " + std::string(spec.name) + " " + std::string(signal.name) + " | " +
             std::string(signal.comment) + " |\n";
    }
  }
  return out;
}

std::string names_text() {
  std::string out = "\n| numbers | value | name in `opcodes.h` | meaning |\n|---|---|---|---|\n";
  for (const NameGroup* group : name_groups()) {
    std::string title(group->title);
    if (group->are_bits) title += " (bits)";
    if (group->is_closed) title += " (others are refused)";
    for (const Name& name : group->names) {
      out += "| " + title + " | " +
             (group->hex_digits == 0 ? std::to_string(name.number)
                                     : "0x" + hex_text(name.number, group->hex_digits)) +
             " | `EYECAN_" + std::string(group->prefix) + std::string(name.name) + "` | " +
             std::string(name.meaning) + " |\n";
      title.clear();
    }
  }
  return out;
}

}  // namespace

Result<std::string> update_specification(std::string_view old) {
  return with_marked_part(
      old, "<!-- Written by make_protocol from bridges/protocol/can: do not edit. -->",
      "<!-- End of what make_protocol writes. -->",
      "\n" + messages_text() + notes_text() + names_text() + "\n");
}

}  // namespace eyebridge::bridges::can
