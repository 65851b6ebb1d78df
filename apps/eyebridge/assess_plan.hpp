#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sweep/assessment.hpp"
#include "sweep_plan.hpp"

namespace eyebridge::apps {

/// What `eyebridge assess` was told on its command line.
struct AssessFlags {
  SweepFlags sweep;
  std::vector<std::string> worlds;  ///< Each one or several, with commas between.
  std::string seeds = "20";         ///< How many, or a range.
  std::vector<std::string> goals;   ///< "X,Y,RADIUS", "WORLD:X,Y,RADIUS" or "none".
  bool no_collisions = false;
  std::string out = "assessment";  ///< Folder.
};

/// The runs of an assessment, and what they must come to.
struct Assessment {
  SweepPlan plan;
  bool no_collisions = false;
  std::optional<Goal> goal;
  std::map<std::size_t, Goal> goals;  ///< Index of a world in the plan's axis -> its own.

  /// For `plan`, which is this one with its paths made absolute.
  [[nodiscard]] Criteria criteria(const SweepPlan& run) const;
};

/// The assessment of `words`, a controller and its arguments. Reads the worlds that have goals.
/// Throws ConfigError.
Assessment make_assessment(const AssessFlags& flags, const std::vector<std::string>& words);

}  // namespace eyebridge::apps
