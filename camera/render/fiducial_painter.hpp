#pragma once

#include <array>
#include <vector>

#include "eyebridge/camera/fiducials.hpp"
#include "optics/lens.hpp"
#include "render/gl_functions.hpp"
#include "render/picture_painter.hpp"
#include "render/visible_walls.hpp"

namespace eyebridge::camera {

/// Draws the fiducials of a world on its walls, each with its white margin: one picture that holds
/// them all, one draw call.
class FiducialPainter {
 public:
  /// `gl` is lent for its life; its context must be current here and in every call.
  explicit FiducialPainter(const GlFunctions& gl);

  /// Replaces the fiducials by those of `model`, of `family` in the default layout. Loads the
  /// vision library. Throws ConfigError as place_fiducials() and fiducial_bits() do.
  void take(const world::WorldModel& model, FiducialFamily family);

  /// Draws those that `lens` may see and `walls` do not hide from it, after the walls. `light`
  /// scales all colours.
  void draw(const Lens& lens, const VisibleWalls& walls,
            const std::array<float, 16>& clip_from_world, float light);

 private:
  std::vector<Fiducial> fiducials_;
  PicturePainter painter_;
  std::vector<std::uint32_t> indices_;
};

}  // namespace eyebridge::camera
