#pragma once

#include <optional>
#include <utility>

#include "eyebridge/robot/robot_model.hpp"
#include "text.hpp"

namespace eyebridge::files {

/// What a line `psd_kind` says: by what distance sensors measure.
///
///   psd_kind ray[:ID]
///   psd_kind ultrasound[:ID] BEAM_DEG CRITICAL_DEG [MIN_MM MAX_MM]
///   psd_kind infrared[:ID] MIN_MM MAX_MM
///   psd_kind down[:ID]
struct PsdKind {
  std::optional<int> id;  ///< None: all of them.
  SourceLocation where;
  robot::RangeKind kind = robot::RangeKind::Ray;
  robot::UltrasoundModel ultrasound{};
  std::optional<std::pair<double, double>> range{};  ///< Metres; none: as it was.
};

/// "min_mm max_mm" from token `first` on, in metres. Throws ConfigError.
std::pair<double, double> read_range_limits(const Statement& s, std::size_t first);

/// Reads such a line. Throws ConfigError.
PsdKind read_psd_kind(const Statement& s);

/// Does what it says. Throws ConfigError when `model` does not have that sensor.
void apply_psd_kind(const PsdKind& kind, robot::RobotModel& model);

}  // namespace eyebridge::files
