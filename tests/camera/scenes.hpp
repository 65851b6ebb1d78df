#pragma once

#include "eyebridge/camera/view.hpp"
#include "render/engine.hpp"
#include "render/gl_context.hpp"

namespace eyebridge::camera::testing {

inline constexpr Rgb kRed{255, 0, 0};
inline constexpr Rgb kGreen{0, 255, 0};

/// The maker of OpenGL contexts that this build prefers.
inline std::string_view first_maker() { return gl_context_makers().front().name; }

/// A floor of 4 m x 4 m without walls.
world::WorldModel empty_room();

/// A maze of `side` x `side` cells of 0.3 m whose walls are chosen by `seed`, boundary closed, with
/// robots, a ball, a can and a marker in it.
world::Scene maze_scene(int side, std::uint64_t seed);

/// A shot of `scene` from the middle of a cell near the maze's corner.
Shot maze_shot(const world::Scene& scene, int width, int height);

/// The picture that `engine` draws of `shot`.
Frame picture(RenderEngine& engine, const Shot& shot);

/// Peak signal-to-noise ratio of two pictures of the same size and format, dB; 200 when equal.
double psnr(const Frame& a, const Frame& b);

}  // namespace eyebridge::camera::testing
