#pragma once

#include <vector>

#include "eyebridge/world/world.hpp"

namespace eyebridge::world {

/// One leg of a mover's round, in the order in which it goes them: a way back has each twice.
struct PathLeg {
  double speed = 0.0;      ///< Metres per second.
  double end_speed = 0.0;  ///< At most, where it ends, so that what comes next can be kept.
  double wait = 0.0;       ///< Seconds where it ends.
};

/// An object that moves by itself, on a way of straight legs.
struct Mover {
  BodyId body = kNoBody;
  double speed = 0.0;              ///< Metres per second.
  bool loop = true;                ///< Else there and back.
  std::vector<Vec2> stops;         ///< Its first place, then the way-points.
  std::size_t target = 1;          ///< Index of the stop that it heads for.
  bool forward = true;             ///< Whether the stops come in their order; in a loop always.
  double yields_within = 0.0;      ///< As in ObjectSpec.
  double acceleration = 0.0;       ///< As in Path.
  std::vector<PathLeg> profile{};  ///< Empty: one speed, and no waits.
  double present = 0.0;            ///< Speed, of one with a profile.
  double waits = 0.0;              ///< Seconds that it goes on standing.

  /// Heads for the stop after the one that was reached.
  void turn_to_next();
  /// The leg that it is on, of one with a profile.
  [[nodiscard]] const PathLeg& leg() const;
};

/// The legs of `path` from `stops[0]`, the place of its object; empty for one speed without waits.
std::vector<PathLeg> profile_of(const Path& path, const std::vector<Vec2>& stops);

}  // namespace eyebridge::world
