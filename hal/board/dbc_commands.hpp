#pragma once

#include <vector>

#include "board/dbc_fields.hpp"
#include "eyebridge/bridges/client/dbc_plan.hpp"
#include "eyebridge/bridges/dbc/database.hpp"

namespace eyebridge::hal {

/// Reads a [[command]] of a mapping file: message, period, constants, counter, checksum. `others`
/// are those before it. Throws ConfigError.
bridges::DbcCommand read_dbc_command(DbcFields& fields, const bridges::dbc::Database& database,
                                     const std::vector<bridges::DbcCommand>& others);

}  // namespace eyebridge::hal
