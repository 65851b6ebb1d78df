#include "board/dbc_names.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "eyebridge/base/text.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/bridges/dbc/signal.hpp"

namespace eyebridge::hal {
namespace {

namespace dbc = bridges::dbc;

struct UnitValue {
  std::string_view name;
  double value;
};

template <class Entry>
std::vector<std::string> names_of(const std::vector<Entry>& entries) {
  std::vector<std::string> names;
  for (const Entry& entry : entries) names.push_back(entry.name);
  return names;
}

template <class Entry>
long count_of(const std::vector<Entry>& entries, std::string_view name) {
  return std::ranges::count(entries, name, &Entry::name);
}

/// The value of the unit that `fields` or the DBC file names.
double value_of_unit(DbcFields& fields, const dbc::Signal& signal,
                     const std::vector<UnitValue>& units) {
  const auto written = fields.text("unit");
  const std::string name = written.value_or(signal.unit);
  const auto found = std::ranges::find(units, name, &UnitValue::name);
  if (found != units.end()) return found->value;
  std::string list;
  for (const UnitValue& unit : units) list += (list.empty() ? "" : ", ") + std::string(unit.name);
  if (written) {
    fields.refuse("unit",
                  fmt::format("found the unit {}, expected one of {}", in_quotes(name), list));
  }
  fields.refuse("signal", fmt::format("found no 'unit' in {}, and {} for {} in the DBC file, "
                                      "expected one of {}",
                                      fields.name(), in_quotes(name), signal.name, list));
}

}  // namespace

const dbc::Message& find_message(const dbc::Database& database, const std::string& name,
                                 const DbcFields& fields, std::string_view key) {
  const dbc::Message* const found = database.find(name);
  if (found == nullptr) {
    const bool is_twice = count_of(database.messages, name) > 1;
    fields.refuse(key,
                  fmt::format("found the message {}, expected one that the DBC file has{}{}",
                              in_quotes(name), is_twice ? " once" : "",
                              is_twice ? "" : nearest_names(name, names_of(database.messages))));
  }
  constexpr int kLongest = 64;
  if (found->length < 1 || found->length > kLongest) {
    fields.refuse(key, fmt::format("found the message {} of {} bytes, expected 1 … {}",
                                   in_quotes(name), found->length, kLongest));
  }
  return *found;
}

DbcSignalRef find_signal(const dbc::Message& message, const std::string& name,
                         const DbcFields& fields, std::string_view key) {
  const dbc::Signal* const found = message.find(name);
  if (found == nullptr) {
    const bool is_twice = count_of(message.signals, name) > 1;
    fields.refuse(key, fmt::format("found the signal {}, expected one that {} has{}{}",
                                   in_quotes(name), message.name, is_twice ? " once" : "",
                                   is_twice ? "" : nearest_names(name, names_of(message.signals))));
  }
  if (!dbc::fits(*found, static_cast<std::size_t>(message.length))) {
    fields.refuse(key, fmt::format("found the signal {} beyond the {} bytes of {}, expected one "
                                   "that fits",
                                   in_quotes(name), message.length, message.name));
  }
  return {&message, static_cast<std::size_t>(found - message.signals.data())};
}

DbcSignalRef signal_of(DbcFields& fields, std::string_view key, const dbc::Database& database) {
  const std::string name = fields.need_text(key, "\"Message.Signal\"");
  const std::size_t dot = name.find('.');
  if (dot == std::string::npos) {
    fields.refuse(key, fmt::format("found {}, expected \"Message.Signal\"", in_quotes(name)));
  }
  const std::string of = name.substr(0, dot);
  const dbc::Message& message = find_message(database, of, fields, key);
  return find_signal(message, name.substr(dot + 1), fields, key);
}

double units_per_speed(DbcFields& fields, const dbc::Signal& signal, const DbcWheelShape& wheel) {
  std::vector<UnitValue> units{{"m/s", 1.0}, {"mm/s", 1000.0}, {"km/h", 3.6}};
  if (wheel.diameter) {
    units.push_back({"rad/s", 2 / *wheel.diameter});
    units.push_back({"deg/s", rad_to_deg(2 / *wheel.diameter)});
    units.push_back({"rpm", 60 / (kPi * *wheel.diameter)});
  }
  if (wheel.ticks_per_metre) units.push_back({"ticks/s", *wheel.ticks_per_metre});
  units.push_back({"%", 100 / wheel.max_speed});
  return value_of_unit(fields, signal, units);
}

double metres_per_unit(DbcFields& fields, const dbc::Signal& signal) {
  return value_of_unit(fields, signal, {{"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}});
}

double radians_per_unit(DbcFields& fields, const dbc::Signal& signal) {
  return value_of_unit(fields, signal,
                       {{"rad", 1.0}, {"deg", deg_to_rad(1)}, {"degrees", deg_to_rad(1)}});
}

double ticks_per_unit(DbcFields& fields, const dbc::Signal& signal, const DbcWheelShape& wheel) {
  std::vector<UnitValue> units{{"ticks", 1.0}};
  if (wheel.ticks_per_metre) {
    const double ticks = *wheel.ticks_per_metre;
    units.push_back({"m", ticks});
    units.push_back({"mm", ticks / 1000});
    if (wheel.diameter) {
      units.push_back({"rad", ticks * *wheel.diameter / 2});
      units.push_back({"deg", ticks * deg_to_rad(*wheel.diameter / 2)});
      units.push_back({"turns", ticks * *wheel.diameter * kPi});
    }
  }
  return value_of_unit(fields, signal, units);
}

double factor_of(DbcFields& fields) {
  constexpr double kMost = 1e9;
  const double scale = fields.number("scale", 1 / kMost, kMost).value_or(1.0);
  const long sign = fields.whole("sign", -1, 1).value_or(1);
  if (sign == 0) fields.refuse("sign", "found 0 for 'sign', expected 1 or -1");
  return static_cast<double>(sign) * scale;
}

}  // namespace eyebridge::hal
