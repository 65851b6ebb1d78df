#include "hdt_table_reader.hpp"

#include <algorithm>

namespace eyebridge::files {
namespace {

constexpr std::size_t kMostValues = 65536;
constexpr int kLargest = 1000000;

/// What a table must be for a kind of device.
struct Rule {
  const char* device;
  std::size_t fewest;
  std::size_t most;
  int top;
};

Rule rule_for(HdtUse use) {
  switch (use) {
    case HdtUse::Motor:
      return {"MOTOR", 101, 101, 100};
    case HdtUse::Servo:
      return {"SERVO", 256, 256, 255};
    case HdtUse::Psd:
    case HdtUse::Drive:
      break;
  }
  return {"PSD", 2, kMostValues, 65535};
}

}  // namespace

bool HdtTableReader::take(const Statement& s) {
  const std::string keyword = lower(s.text(0));
  if (open_) {
    add(s, 0);
    return true;
  }
  if (keyword != "table") return false;
  begin(s);
  return true;
}

void HdtTableReader::begin(const Statement& s) {
  if (s.size() < 2) s.fail(1, "line ends: expected the name of the table");
  for (const HdtTable& other : tables_) {
    if (other.name == s.text(1)) {
      s.fail(1, "table " + in_quotes(other.name) + " is given twice, first in line " +
                    std::to_string(other.where.line) + ": expected one");
    }
  }
  tables_.push_back({std::string(s.text(1)), {}, s.where(0)});
  places_.emplace_back();
  open_ = true;
  add(s, 2);
}

void HdtTableReader::add(const Statement& s, std::size_t from) {
  HdtTable& table = tables_.back();
  for (std::size_t i = from; i < s.size(); ++i) {
    if (!s.token(i).quoted && lower(s.text(i)) == "end") {
      open_ = false;
      return;  // the dialects end the line with TABLE or the table's name
    }
    const std::string of = "table " + in_quotes(table.name);
    if (!s.is_number(i)) {
      s.fail(i, in_quotes(s.text(i)) + " found in " + of + ", which begins in line " +
                    std::to_string(table.where.line) + ": expected a whole number or END TABLE");
    }
    if (table.values.size() == kMostValues) {
      s.fail(i, of + " is too long: expected at most " + std::to_string(kMostValues) + " values");
    }
    table.values.push_back(s.integer(i, "a value of " + of, -kLargest, kLargest));
    places_.back().push_back({s.line(), s.token(i).column});
  }
}

void HdtTableReader::finish(int last_line) const {
  if (!open_) return;
  throw ConfigError({file_, std::max(1, last_line), 1},
                    "file ends in table " + in_quotes(tables_.back().name) +
                        ", which begins in line " + std::to_string(tables_.back().where.line) +
                        ": expected END TABLE");
}

std::size_t HdtTableReader::index_for(const HdtReference& use) const {
  const auto found = std::find_if(tables_.begin(), tables_.end(),
                                  [&](const HdtTable& t) { return t.name == use.name; });
  if (found == tables_.end()) {
    throw ConfigError(use.where, "no table " + in_quotes(use.name) +
                                     " in this file: expected the name of a TABLE");
  }
  const auto index = static_cast<std::size_t>(found - tables_.begin());
  const Rule rule = rule_for(use.use);
  const std::string of =
      "table " + in_quotes(use.name) + " of " + rule.device + " " + std::to_string(use.id);
  const std::size_t count = found->values.size();
  if (count < rule.fewest || count > rule.most) {
    throw ConfigError(found->where, of + " has " + std::to_string(count) + " values: expected " +
                                        (rule.fewest == rule.most ? "" : "at least ") +
                                        std::to_string(rule.fewest));
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (found->values[i] >= 0 && found->values[i] <= rule.top) continue;
    const Place place = places_[index][i];
    throw ConfigError({file_, place.line, place.column},
                      std::to_string(found->values[i]) + " found in " + of + ": expected 0 to " +
                          std::to_string(rule.top));
  }
  return index;
}

}  // namespace eyebridge::files
