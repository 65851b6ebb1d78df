#include "render/picture_painter.hpp"

#include "render/gl_objects.hpp"

namespace eyebridge::camera {
namespace {

constexpr const char* kPictureVertexShader = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec2 in_picture;
layout(location = 2) in vec4 tint;
uniform mat4 clip_from_world;
uniform float light;
out vec2 at;
flat out vec3 colour;
void main() {
  gl_Position = clip_from_world * vec4(position, 1.0);
  at = in_picture;
  colour = light * tint.rgb;
})";

constexpr const char* kSmooth = R"(#version 330 core
in vec2 at;
flat in vec3 colour;
uniform sampler2D picture;
out vec4 pixel;
void main() { pixel = vec4(colour * texture(picture, at).rgb, 1.0); })";

// Pulls the place that is looked up away from the border of two texels, save for a strip as wide as
// a pixel of the frame: bilinear filtering then averages over just that pixel.
constexpr const char* kSharp = R"(#version 330 core
in vec2 at;
flat in vec3 colour;
uniform sampler2D picture;
out vec4 pixel;
void main() {
  vec2 size = vec2(textureSize(picture, 0));
  vec2 texel = at * size;
  vec2 covered = clamp(fwidth(texel), vec2(1e-6), vec2(1.0));
  vec2 border = floor(texel + 0.5);
  vec2 pulled = border + clamp((texel - border) / covered, vec2(-0.5), vec2(0.5));
  pixel = vec4(colour * textureGrad(picture, pulled / size, dFdx(at), dFdy(at)).rgb, 1.0);
})";

}  // namespace

PicturePainter::PicturePainter(const GlFunctions& gl, Edges edges)
    : gl_(gl),
      program_(make_program(gl, kPictureVertexShader, edges == Edges::Sharp ? kSharp : kSmooth)),
      clip_from_world_(gl.get_uniform_location(program_, "clip_from_world")),
      light_(gl.get_uniform_location(program_, "light")),
      texture_(make_texture(gl)),
      quads_(gl) {}

void PicturePainter::take(const std::vector<TextureLevel>& picture, const QuadMesh& mesh) {
  fill_texture(gl_, texture_, picture);
  quads_.fill(mesh);
}

void PicturePainter::draw(const std::vector<std::uint32_t>& indices,
                          const std::array<float, 16>& clip_from_world, float light, bool on_top) {
  if (indices.empty()) return;
  quads_.choose(indices);
  gl_.use_program(program_);
  gl_.uniform_matrix_4fv(clip_from_world_, 1, GL_FALSE, clip_from_world.data());
  gl_.uniform_1f(light_, light);
  gl_.bind_texture(GL_TEXTURE_2D, texture_);
  if (on_top) gl_.enable(GL_POLYGON_OFFSET_FILL);
  quads_.draw();
  if (on_top) gl_.disable(GL_POLYGON_OFFSET_FILL);
}

}  // namespace eyebridge::camera
