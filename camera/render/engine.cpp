#include "render/engine.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>

#include "eyebridge/base/log.hpp"
#include "eyebridge/camera/convert.hpp"
#include "eyebridge/camera/picture.hpp"
#include "render/body_painter.hpp"
#include "render/gl_objects.hpp"
#include "render/mesh.hpp"
#include "render/visible_walls.hpp"

namespace eyebridge::camera {
namespace {

constexpr const char* kRoomVertexShader = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec2 texture_position;
layout(location = 2) in vec4 tint;
uniform mat4 clip_from_world;
out vec2 st;
out vec4 colour;
void main() {
  gl_Position = clip_from_world * vec4(position, 1.0);
  st = texture_position;
  colour = tint;
})";

constexpr const char* kRoomFragmentShader = R"(#version 330 core
in vec2 st;
in vec4 colour;
uniform sampler2D image;
out vec4 pixel;
void main() { pixel = texture(image, st) * colour; })";

/// A mesh of quads in OpenGL's memory.
struct GpuQuads {
  GLuint array = 0;
  GLuint vertices = 0;
  GLuint indices = 0;
  GLsizei count = 0;
};

GpuQuads make_quads(const GlFunctions& gl) {
  GpuQuads quads;
  gl.gen_vertex_arrays(1, &quads.array);
  gl.bind_vertex_array(quads.array);
  quads.vertices = make_buffer(gl);
  quads.indices = make_buffer(gl);
  gl.bind_buffer(GL_ELEMENT_ARRAY_BUFFER, quads.indices);
  describe(gl, quads.vertices, sizeof(WorldVertex),
           {{0, 3, GL_FLOAT, offsetof(WorldVertex, x)},
            {1, 2, GL_FLOAT, offsetof(WorldVertex, u)},
            {2, 4, GL_UNSIGNED_BYTE, offsetof(WorldVertex, colour)}});
  return quads;
}

void fill_indices(const GlFunctions& gl, GpuQuads& quads,
                  const std::vector<std::uint32_t>& indices) {
  gl.bind_vertex_array(quads.array);
  fill_buffer(gl, GL_ELEMENT_ARRAY_BUFFER, quads.indices, indices, GL_STREAM_DRAW);
  quads.count = static_cast<GLsizei>(indices.size());
}

void fill_quads(const GlFunctions& gl, GpuQuads& quads, const QuadMesh& mesh) {
  gl.bind_vertex_array(quads.array);
  fill_buffer(gl, GL_ARRAY_BUFFER, quads.vertices, mesh.vertices, GL_STATIC_DRAW);
  std::vector<std::uint32_t> indices;
  for (std::uint32_t first = 0; first < mesh.vertices.size(); first += 4) {
    for (const std::uint32_t i : {0U, 1U, 2U, 0U, 2U, 3U}) indices.push_back(first + i);
  }
  fill_indices(gl, quads, indices);
}

/// Reads the floor's picture; nothing, after a warning, when that cannot be done.
std::optional<Frame> floor_picture(const world::WorldModel& model, const std::string& directory,
                                   LogSink& log) {
  if (!model.floor_texture) return std::nullopt;
  try {
    return read_picture(std::filesystem::path(directory) / *model.floor_texture);
  } catch (const std::runtime_error& error) {
    log.write(Severity::Warning,
              std::string("floor texture: ") + error.what() + "; the floor is drawn plain");
    return std::nullopt;
  }
}

}  // namespace

struct RenderEngine::Impl {
  std::unique_ptr<GlContext> context;
  GlFunctions gl;
  RenderTarget target;
  GLuint program;
  GLint clip_from_world;
  GLuint bricks;
  GLuint tiles;
  GLuint plain;
  GLuint picture;
  GpuQuads walls;
  GpuQuads floor;
  GpuQuads markers;
  BodyPainter bodies;

  std::shared_ptr<const world::WorldModel> model;  // drawn last
  std::string texture_directory;
  VisibleWalls visible{{}};
  GLuint floor_texture = 0;
  double extent = 0.0;  // of the walls and the floor from the origin, metres
  std::vector<std::uint32_t> indices;

  Impl(std::string_view maker, LogSink& log)
      : context(make_gl_context(maker, log)),
        gl(*context),
        target(gl),
        program(make_program(gl, kRoomVertexShader, kRoomFragmentShader)),
        clip_from_world(gl.get_uniform_location(program, "clip_from_world")),
        bricks(make_texture(gl)),
        tiles(make_texture(gl)),
        plain(make_texture(gl)),
        picture(make_texture(gl)),
        walls(make_quads(gl)),
        floor(make_quads(gl)),
        markers(make_quads(gl)),
        bodies(gl) {
    fill_texture(gl, bricks, mip_levels(brick_texture()));
    fill_texture(gl, tiles, mip_levels(tile_texture()));
    fill_texture(gl, plain, {TextureLevel{1, 1, {255, 255, 255, 255}}});
    gl.enable(GL_DEPTH_TEST);
    gl.depth_func(GL_LESS);
    gl.clear_color(0.62F, 0.78F, 0.92F, 1.0F);
    gl.pixel_store_i(GL_PACK_ALIGNMENT, 1);
    gl.polygon_offset(-1.0F, -4.0F);
  }

  void take_world(const Shot& shot, LogSink& log) {
    if (model == shot.scene.model && texture_directory == shot.texture_directory) return;
    model = shot.scene.model;
    texture_directory = shot.texture_directory;
    visible = VisibleWalls(model->walls);
    extent = std::max(model->width, model->height);
    for (const world::Wall& wall : model->walls) {
      for (const Vec2 end : {wall.a, wall.b}) {
        extent = std::max({extent, std::abs(end.x), std::abs(end.y)});
      }
      extent = std::max(extent, wall.height);
    }
    fill_quads(gl, walls, wall_mesh(model->walls));
    fill_quads(gl, markers, marker_mesh(model->markers));
    const std::optional<Frame> floor_image = floor_picture(*model, texture_directory, log);
    if (floor_image) fill_texture(gl, picture, mip_levels(picture_texture(*floor_image)));
    floor_texture = floor_image ? picture : tiles;
    fill_quads(gl, floor, floor_mesh(*model, floor_image.has_value()));
  }

  void draw(const GpuQuads& quads, GLuint texture) const {
    if (quads.count == 0) return;
    gl.bind_vertex_array(quads.array);
    gl.bind_texture(GL_TEXTURE_2D, texture);
    gl.draw_elements(GL_TRIANGLES, quads.count, GL_UNSIGNED_INT, nullptr);
  }
};

RenderEngine::RenderEngine(std::string_view maker, LogSink& log)
    : impl_(std::make_unique<Impl>(maker, log)) {}

RenderEngine::~RenderEngine() = default;

std::string_view RenderEngine::maker() const { return impl_->context->name(); }

Frame RenderEngine::render(const Shot& shot, LogSink& log) {
  Impl& my = *impl_;
  const GlFunctions& gl = my.gl;
  my.context->make_current();
  my.take_world(shot, log);
  my.target.resize(shot.width, shot.height);

  const double far =
      4.0 * (my.extent + std::abs(shot.eye.x) + std::abs(shot.eye.y) + std::abs(shot.eye.z) + 1.0);
  const Lens lens(shot.eye, shot.width, shot.height, far);
  const auto matrix = lens.clip_from_world();
  my.visible.select(lens, my.indices);
  fill_indices(gl, my.walls, my.indices);

  gl.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.use_program(my.program);
  gl.uniform_matrix_4fv(my.clip_from_world, 1, GL_FALSE, matrix.data());
  my.draw(my.walls, my.bricks);
  my.bodies.draw(shot.scene.bodies, shot.carrier, lens, matrix);
  // The floor last: most of it is hidden. Markers lie in its plane and must win.
  gl.use_program(my.program);
  my.draw(my.floor, my.floor_texture);
  gl.enable(GL_POLYGON_OFFSET_FILL);
  my.draw(my.markers, my.plain);
  gl.disable(GL_POLYGON_OFFSET_FILL);

  Frame frame = make_frame(shot.width, shot.height, PixelFormat::Rgb24);
  gl.read_pixels(0, 0, shot.width, shot.height, GL_RGB, GL_UNSIGNED_BYTE, frame.bytes.data());
  if (const GLenum error = gl.get_error(); error != GL_NO_ERROR) {
    throw std::runtime_error("OpenGL error " + std::to_string(error) + " while drawing");
  }
  return frame;
}

RenderEngine& RenderEngine::of_this_thread(std::string_view maker, LogSink& log) {
  thread_local std::map<std::string, std::unique_ptr<RenderEngine>, std::less<>> engines;
  const auto found = engines.find(maker);
  if (found != engines.end()) return *found->second;
  return *engines.emplace(maker, std::make_unique<RenderEngine>(maker, log)).first->second;
}

}  // namespace eyebridge::camera
