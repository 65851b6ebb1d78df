#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "board/dbc_fields.hpp"
#include "eyebridge/bridges/client/dbc_plan.hpp"
#include "eyebridge/bridges/dbc/database.hpp"

namespace eyebridge::hal {

// Names of a mapping file, looked up in the robot's DBC file.

/// A signal, and what a mapping file says of it.
struct DbcSignalRef {
  const bridges::dbc::Message* message = nullptr;
  std::size_t index = 0;
  [[nodiscard]] const bridges::dbc::Signal& signal() const { return message->signals[index]; }
};

/// What wheels are, for units that need it.
struct DbcWheelShape {
  std::optional<double> diameter;         ///< Metres.
  std::optional<double> ticks_per_metre;  ///< Of the encoder.
  double max_speed = 0;                   ///< Metres per second at 100 %.
};

/// The message `name`, of 1 … 64 bytes; `key` is the entry that names it.
const bridges::dbc::Message& find_message(const bridges::dbc::Database& database,
                                          const std::string& name, const DbcFields& fields,
                                          std::string_view key);
/// A signal of `message` that fits into it.
DbcSignalRef find_signal(const bridges::dbc::Message& message, const std::string& name,
                         const DbcFields& fields, std::string_view key);
/// "Message.Signal", which entry `key` says.
DbcSignalRef signal_of(DbcFields& fields, std::string_view key,
                       const bridges::dbc::Database& database);

/// The number of `signal`'s units in 1 m/s, by entry 'unit' or the DBC file's own unit.
double units_per_speed(DbcFields& fields, const bridges::dbc::Signal& signal,
                       const DbcWheelShape& wheel);
/// Metres in one unit of `signal`.
double metres_per_unit(DbcFields& fields, const bridges::dbc::Signal& signal);
/// Radians in one.
double radians_per_unit(DbcFields& fields, const bridges::dbc::Signal& signal);
/// Encoder ticks in one.
double ticks_per_unit(DbcFields& fields, const bridges::dbc::Signal& signal,
                      const DbcWheelShape& wheel);
/// Entries 'scale' and 'sign': the factor by which a signal's value is multiplied first.
double factor_of(DbcFields& fields);

}  // namespace eyebridge::hal
