#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "eyebridge/base/pose.hpp"
#include "eyebridge/world/world_model.hpp"

namespace eyebridge::bench {

/// The place in which the peers were measured, and where its robots start.
struct Arena {
  std::shared_ptr<const world::WorldModel> model;
  std::vector<Pose> starts;  ///< As many as there are robots.
};

/// Where files stand: walls.csv (cx, cy, length, thickness, angle) and robots.csv (x, y, theta);
/// metres, radians, origin in the centre of 40 x 40 m.
///
/// Up to `in_one` robots share one such place. More get as many of them as are needed for so many
/// each, side by side with shared outer walls, as square as the number allows; `robots` is a
/// multiple of `in_one` then. `empty` more places have no robots. In each
/// place are `boxes` fixed boxes of 0.1 m. Throws std::runtime_error, which
/// names file and line.
Arena read_arena(const std::filesystem::path& folder, std::size_t robots, std::size_t in_one,
                 std::size_t empty, std::size_t boxes);

}  // namespace eyebridge::bench
