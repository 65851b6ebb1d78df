#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string_view>

#include "board/dbc_map.hpp"
#include "eyebridge/base/config_error.hpp"
#include "eyebridge/bridges/client/dbc_plan.hpp"
#include "eyebridge/bridges/dbc/read_dbc.hpp"
#include "eyebridge/bridges/dbc/signal.hpp"

// What the fuzz targets of DBC and mapping files and the test over their corpora do with one input.
// A wrong accept ends the process: that is a finding.
namespace eyebridge::fuzz {

inline void demand(bool truth) {
  if (!truth) std::abort();
}

/// What is read has signals that can be read and written in frames of any length.
inline void dbc(std::string_view text) {
  using namespace bridges;
  dbc::Database database;
  try {
    database = dbc::read_dbc(text, "fuzz.dbc");
  } catch (const ConfigError& error) {
    demand(std::string_view(error.what()).starts_with("fuzz.dbc:"));
    return;
  }
  std::array<std::uint8_t, 64> data{};
  for (std::size_t i = 0; i < data.size(); ++i) data[i] = static_cast<std::uint8_t>(i * 37);
  for (const dbc::Message& message : database.messages) {
    demand(message.id <= CanFrame::kMaxExtendedId && message.length >= 0);
    for (const std::size_t length : {std::size_t{0}, std::size_t{8}, data.size()}) {
      const std::span<std::uint8_t> bytes(data.data(), length);
      for (std::size_t i = 0; i < message.signals.size(); ++i) {
        const dbc::Signal& signal = message.signals[i];
        demand(signal.length >= 1 && signal.length <= 64 && signal.start >= 0);
        (void)dbc::is_present(message, i, bytes);
        if (!dbc::fits(signal, length)) continue;
        const auto before = data;
        const std::uint64_t bits = dbc::raw_bits(signal, bytes);
        dbc::put_bits(signal, bits, bytes);
        demand(data == before);
        (void)dbc::whole_number(signal, bits);
        (void)dbc::bits_for(signal, dbc::value_of(signal, bits));
        (void)dbc::bits_for(signal, 1.0);
      }
    }
  }
}

/// A mapping file for a small robot: what is accepted can be sent.
inline void dbc_map(std::string_view text) {
  using namespace bridges;
  static const dbc::Database database = dbc::read_dbc(
      "BO_ 1 Go: 8 H\n SG_ Crc : 0|8@1+ (1,0) [0|0] \"\" R\n SG_ Count : 8|4@1+ (1,0) [0|0] \"\" "
      "R\n"
      " SG_ On : 12|1@1+ (1,0) [0|0] \"\" R\n SG_ L : 16|16@1- (0.1,0) [0|0] \"rpm\" R\n"
      " SG_ R : 39|16@0- (0.1,0) [0|0] \"rpm\" R\n SG_ Far : 64|8@1+ (1,0) [0|0] \"\" R\n"
      "BO_ 2 Say: 8 R\n SG_ M M : 0|8@1+ (1,0) [0|0] \"\" H\n SG_ A m0 : 8|24@1+ (1,0) [0|0] \"\" "
      "H\n"
      " SG_ B m1 : 8|24@1- (1,0) [0|0] \"mm\" H\n SG_ F : 32|32@1- (1,0) [0|0] \"m\" H\n"
      "SIG_VALTYPE_ 2 F : 1;\nBA_ \"GenMsgCycleTime\" BO_ 2 20;\n",
      "fuzz.dbc");
  hal::DbcRobot robot;
  try {
    robot = hal::read_dbc_map(text, "fuzz.toml", database);
  } catch (const ConfigError& error) {
    demand(std::string_view(error.what()).starts_with("fuzz.toml"));
    return;
  }
  demand(robot.plan.wheels.size() == 2 && !robot.plan.commands.empty());
  demand(robot.plan.heartbeat < robot.plan.statuses.size());
  demand(robot.plan.heartbeat_limit > Time{0});
  for (const DbcReading& reading : robot.plan.readings) {
    demand(reading.status < robot.plan.statuses.size());
    demand(reading.signal < robot.plan.statuses[reading.status].signals.size());
  }
  for (const DbcCommand& command : robot.plan.commands) {
    demand(command.period > Time{0});
    std::uint64_t counter = 0;
    for (int i = 0; i < 20; ++i) counter = next_counter(command, counter);
    demand(why_not_sendable(dbc_frame(command, command.resting, counter)) == nullptr);
  }
  for (std::size_t i = 0; i < 2; ++i) {
    const DbcSetPoint& wheel = robot.plan.wheels[i];
    const dbc::Signal& signal = robot.plan.commands[wheel.command].message.signals[wheel.signal];
    for (const double speed : {robot.max_wheel_speed, 0.0, -robot.max_wheel_speed}) {
      demand(dbc::bits_for(signal, speed * robot.value_per_speed.at(i)).has_value());
    }
  }
}

}  // namespace eyebridge::fuzz
