#pragma once

#include <string>
#include <vector>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge::hal {

// What an HDT file says about a board, in our units: what is connected, and the tables that turn
// raw numbers into ours. Ids count from 1, as programs ask for them.

struct BoardMotorTable {
  int id = 1;
  std::vector<double> duty;  ///< 101 values 0 … 1, for wanted 0 … 100 %; empty: as wanted.
};

struct BoardServoTable {
  int id = 1;
  std::vector<int> position;  ///< 256 values 0 … 255; empty: evenly.
  int lower_10us = -1;        ///< Pulse widths of positions 0 and 255; -1: the board's own.
  int upper_10us = -1;
};

struct BoardPsdTable {
  int id = 1;
  /// Metres by raw value, evenly over 12 bits (a longer one: an entry each); kBoardOutOfRange where
  /// nothing is seen. Empty: the board's own.
  std::vector<double> metres;
};

/// What a PSD reads where it sees nothing: the 9999 mm of RoBIOS.
inline constexpr double kBoardOutOfRange = 9.999;

/// The wheels as the v-omega controller sees them. The defaults are those of an S4 EyeBot.
struct BoardDriveShape {
  double wheel_base = 0.09;             ///< Metres; > 0.
  double left_ticks_per_metre = 6484;   ///< Of encoder 1; > 0.
  double right_ticks_per_metre = 6484;  ///< Of encoder 2; > 0.
  double max_linear = 0.6;              ///< Metres per second.
  double max_angular = 5.2;             ///< Radians per second.
  bool left_reversed = false;           ///< Motor 1 and encoder 1 count backwards as forwards.
  bool right_reversed = false;          ///< Likewise motor 2 and encoder 2.
};

/// Everything.
struct BoardTables {
  std::vector<BoardMotorTable> motors;
  std::vector<BoardServoTable> servos;
  std::vector<BoardPsdTable> psds;
  std::vector<int> encoders;
  BoardDriveShape drive;
};

/// The defaults without an HDT file: motors and encoders 1 … 4, servos 1 … 14, PSDs 1 … 6, a drive
/// like that of an S4, and every PSD a Sharp GP2Y0A21 at a 12-bit converter of 2.7 V.
BoardTables default_board_tables();

/// Reads `path`, an HDT file: what it does not list is not there, but for the wheels, which without
/// a DRIVE line count as an S4's, with a warning. Throws ConfigError; also for a DRIVE that is not
/// differential, lacks an ENCODER, or has others than motor and encoder 1 left and 2 right.
BoardTables read_board_tables(const std::string& path, std::vector<Warning>& warnings);

}  // namespace eyebridge::hal
