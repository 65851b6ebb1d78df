#pragma once

#include <memory>
#include <string>

#include "eyebridge/files/load.hpp"

namespace CLI {
class App;
}

namespace eyebridge::apps {

/// Flags of the commands about worlds: how to read one.
struct ReadingFlags {
  std::string robot;  ///< Empty: a world without robots has none.
  std::string cell;

  /// Throws ConfigError.
  [[nodiscard]] files::LoadOptions options() const;
};

/// Adds `--robot` and `--cell`.
std::shared_ptr<ReadingFlags> add_reading_flags(CLI::App& command);
/// Adds `--cell` alone.
std::shared_ptr<ReadingFlags> add_cell_flag(CLI::App& command);

}  // namespace eyebridge::apps
