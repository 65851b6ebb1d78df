#include "render/world_painter.hpp"

#include "render/gl_objects.hpp"
#include "render/mesh.hpp"

namespace eyebridge::camera {
namespace {

// Rows of the tables: as enum Pattern. What is the same for a whole quad goes flat to the pixels:
// llvmpipe then computes it once.
constexpr const char* kRoomVertexShader = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec2 in_pattern;
layout(location = 2) in vec4 tint;
uniform mat4 clip_from_world;
uniform float light;
out vec2 at;
flat out vec3 colour;
flat out vec2 joint;
flat out vec3 mix_up;
flat out vec4 tones;
const vec2 kJoint[3] = vec2[](vec2(0.0), vec2(0.031, 0.062), vec2(0.031));
const vec3 kMixUp[3] = vec3[](vec3(0.0), vec3(0.618, 0.381, 0.0), vec3(0.5, 0.5, 0.25));
const vec4 kTones[3] = vec4[](vec4(1.0, 0.0, 1.0, 0.0), vec4(0.902, 0.157, 0.667, 0.5),
                              vec4(0.714, 0.126, 0.525, 0.0));
void main() {
  gl_Position = clip_from_world * vec4(position, 1.0);
  at = in_pattern;
  colour = light * tint.rgb;
  int pattern = int(tint.a * 255.0 + 0.5);
  joint = kJoint[pattern];
  mix_up = kMixUp[pattern];
  tones = kTones[pattern];
})";

// A unit of `at` is a brick or a tile; `covered` is how much of it the pixel covers. tones: mean,
// spread from piece to piece, joint, shift from course to course.
constexpr const char* kRoomFragmentShader = R"(#version 330 core
in vec2 at;
flat in vec3 colour;
flat in vec2 joint;
flat in vec3 mix_up;
flat in vec4 tones;
out vec4 pixel;
void main() {
  vec2 covered = max(fwidth(at), vec2(1e-6));
  vec2 per = 1.0 / covered;
  float course = floor(at.y);
  vec2 shifted = vec2(at.x + tones.w * course, at.y);
  vec2 piece = vec2(floor(shifted.x), course);
  vec2 beyond_edge = abs(shifted - piece - 0.5) - 0.5;
  vec2 share = clamp((beyond_edge + 0.5 * joint) * per + 0.5, vec2(0.0), min(joint * per, vec2(1.0)));
  float spread = fract(dot(piece, mix_up.xy) + mix_up.z) - 0.5;
  float near = clamp(1.5 - max(covered.x, covered.y), 0.0, 1.0);
  float tone = mix(tones.x + tones.y * spread * near, tones.z, max(share.x, share.y));
  pixel = vec4(tone * colour, 1.0);
})";

}  // namespace

WorldPainter::WorldPainter(const GlFunctions& gl)
    : gl_(gl),
      program_(make_program(gl, kRoomVertexShader, kRoomFragmentShader)),
      clip_from_world_(gl.get_uniform_location(program_, "clip_from_world")),
      light_(gl.get_uniform_location(program_, "light")),
      quads_(gl),
      markers_(gl) {
  gl_.polygon_offset(-1.0F, -4.0F);
}

void WorldPainter::take(const world::WorldModel& model, bool tiles) {
  visible_ = VisibleWalls(model.walls);
  QuadMesh mesh = wall_mesh(model.walls);
  floor_.clear();
  if (tiles) {
    add_triangles(static_cast<std::uint32_t>(mesh.vertices.size() / 4), floor_);
    const QuadMesh floor = floor_mesh(model, Pattern::Tiles);
    mesh.vertices.insert(mesh.vertices.end(), floor.vertices.begin(), floor.vertices.end());
  }
  quads_.fill(mesh);
  const QuadMesh markers = marker_mesh(model.markers);
  has_markers_ = !markers.vertices.empty();
  markers_.fill(markers);
  markers_.choose(triangles_of(0, markers.vertices.size() / 4));
}

void WorldPainter::draw(const Lens& lens, const std::array<float, 16>& clip_from_world,
                        float light) {
  visible_.select(lens, indices_);
  // Behind the walls: most of it is hidden.
  indices_.insert(indices_.end(), floor_.begin(), floor_.end());
  quads_.choose(indices_);
  gl_.use_program(program_);
  gl_.uniform_matrix_4fv(clip_from_world_, 1, GL_FALSE, clip_from_world.data());
  gl_.uniform_1f(light_, light);
  quads_.draw();
}

void WorldPainter::draw_markers() const {
  if (!has_markers_) return;
  gl_.use_program(program_);
  // They lie in the plane of the floor and must win.
  gl_.enable(GL_POLYGON_OFFSET_FILL);
  markers_.draw();
  gl_.disable(GL_POLYGON_OFFSET_FILL);
}

}  // namespace eyebridge::camera
