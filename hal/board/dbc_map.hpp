#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "board/board_tables.hpp"
#include "eyebridge/bridges/client/dbc_plan.hpp"
#include "eyebridge/bridges/dbc/database.hpp"

namespace eyebridge::hal {

/// A reading of the robot that is a length or an angle: its value times `scale` is metres or
/// radians.
struct DbcQuantity {
  std::size_t reading = 0;  ///< Of the plan.
  double scale = 1;
};

struct DbcEncoder {
  int id = 1;
  std::size_t reading = 0;
  int bits = 32;             ///< Of its counter, which wraps.
  double ticks_per_bit = 1;  ///< Below 0: it counts backwards as the wheel rolls forwards.
};

struct DbcRange {
  int id = 1;
  DbcQuantity distance;
};

/// Where the robot itself says that it is.
struct DbcPose {
  DbcQuantity x, y, theta;
};

/// A robot as its DBC file and its mapping file describe it.
struct DbcRobot {
  bridges::DbcPlan plan;  ///< Its wheels are the left one and the right one.
  BoardTables tables;
  std::array<double, 2> value_per_speed{};  ///< Of a wheel's signal, for 1 m/s forward.
  double max_wheel_speed = 0;               ///< Metres per second: what 100 % of a motor are.
  std::vector<DbcEncoder> encoders;
  std::vector<DbcRange> ranges;
  std::optional<DbcPose> pose;
};

/// Reads `text`, a mapping file in TOML that messages call `file`, for a robot with these messages.
/// Throws ConfigError: for names that are not in `database` (with the nearest ones), unknown units,
/// numbers that cannot be.
DbcRobot read_dbc_map(std::string_view text, const std::string& file,
                      const bridges::dbc::Database& database);

/// The robot of a DBC file and a mapping file. Throws ConfigError.
DbcRobot load_dbc_robot(const std::string& dbc_path, const std::string& map_path);

}  // namespace eyebridge::hal
