#pragma once

#include <QString>
#include <optional>

#include "editor/plan.hpp"

namespace eyebridge::gui {

/// A plan as a maze, or why it is none.
struct MazeFit {
  std::optional<world::WorldModel> maze;  ///< With its grid: write_maze() takes it.
  QString why;                            ///< The first thing that does not fit, with its place.
};

/// Looks for a grid: the plan's own, if it has one, else the coarsest one on which
/// all walls lie and in whose cells all starts and things stand. Things that no drawing has count
/// only where `all_things` says so; then markers and robots must not be there either.
MazeFit fit_maze(const Plan& plan, bool all_things);

}  // namespace eyebridge::gui
