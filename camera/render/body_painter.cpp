#include "render/body_painter.hpp"

#include <cstddef>

#include "render/gl_objects.hpp"

namespace eyebridge::camera {
namespace {

constexpr const char* kBodyVertexShader = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float mark;
layout(location = 3) in vec4 place;
layout(location = 4) in vec3 size;
layout(location = 5) in vec4 body_colour;
layout(location = 6) in vec4 mark_colour;
uniform mat4 clip_from_world;
uniform float light;
out vec3 colour;
vec2 turned(vec2 v) { return vec2(place.z * v.x - place.w * v.y, place.w * v.x + place.z * v.y); }
void main() {
  vec3 world = vec3(place.xy + turned(position.xy * size.xy), position.z * size.z);
  gl_Position = clip_from_world * vec4(world, 1.0);
  float shade = 0.72 + 0.28 * dot(vec3(turned(normal.xy), normal.z), vec3(0.30, 0.52, 0.80));
  colour = light * shade * mix(body_colour.rgb, mark_colour.rgb, mark);
})";

constexpr const char* kBodyFragmentShader = R"(#version 330 core
in vec3 colour;
out vec4 pixel;
void main() { pixel = vec4(colour, 1.0); })";

BodyMesh mesh_of(world::BodyShape shape) {
  switch (shape) {
    case world::BodyShape::Robot:
      return robot_mesh();
    case world::BodyShape::Ball:
      return ball_mesh();
    case world::BodyShape::Can:
    case world::BodyShape::Polygon:  // has one of its own
      break;
  }
  return can_mesh();
}

bool is_dark(Rgb c) { return 3 * c.r + 6 * c.g + c.b < 1280; }

}  // namespace

BodyPainter::BodyPainter(const GlFunctions& gl)
    : gl_(gl),
      program_(make_program(gl, kBodyVertexShader, kBodyFragmentShader)),
      clip_from_world_(gl.get_uniform_location(program_, "clip_from_world")),
      light_(gl.get_uniform_location(program_, "light")),
      polygon_corners_(make_buffer(gl)),
      polygon_indices_(make_buffer(gl)) {
  gl_.gen_vertex_arrays(1, &polygon_array_);
  gl_.bind_vertex_array(polygon_array_);
  describe(gl_, polygon_corners_, sizeof(Corner),
           {{0, 3, GL_FLOAT, offsetof(Corner, vertex.x)},
            {1, 3, GL_FLOAT, offsetof(Corner, vertex.nx)},
            {2, 1, GL_FLOAT, offsetof(Corner, vertex.mark)},
            {3, 4, GL_FLOAT, offsetof(Corner, body.x)},
            {4, 3, GL_FLOAT, offsetof(Corner, body.length)},
            {5, 4, GL_UNSIGNED_BYTE, offsetof(Corner, body.colour)},
            {6, 4, GL_UNSIGNED_BYTE, offsetof(Corner, body.mark)}});
  gl_.bind_buffer(GL_ELEMENT_ARRAY_BUFFER, polygon_indices_);
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    const BodyMesh mesh = mesh_of(static_cast<world::BodyShape>(i));
    Shape& shape = shapes_[i];
    gl_.gen_vertex_arrays(1, &shape.array);
    gl_.bind_vertex_array(shape.array);
    const GLuint vertices = make_buffer(gl_);
    fill_buffer(gl_, GL_ARRAY_BUFFER, vertices, mesh.vertices, GL_STATIC_DRAW);
    describe(gl_, vertices, sizeof(BodyVertex),
             {{0, 3, GL_FLOAT, offsetof(BodyVertex, x)},
              {1, 3, GL_FLOAT, offsetof(BodyVertex, nx)},
              {2, 1, GL_FLOAT, offsetof(BodyVertex, mark)}});
    fill_buffer(gl_, GL_ELEMENT_ARRAY_BUFFER, make_buffer(gl_), mesh.indices, GL_STATIC_DRAW);
    shape.index_count = static_cast<GLsizei>(mesh.indices.size());
    shape.instances = make_buffer(gl_);
    describe(gl_, shape.instances, sizeof(Instance),
             {{3, 4, GL_FLOAT, offsetof(Instance, x), 1},
              {4, 3, GL_FLOAT, offsetof(Instance, length), 1},
              {5, 4, GL_UNSIGNED_BYTE, offsetof(Instance, colour), 1},
              {6, 4, GL_UNSIGNED_BYTE, offsetof(Instance, mark), 1}});
  }
}

BodyPainter::Instance BodyPainter::instance_of(const world::BodyView& body) {
  const Heading heading = Heading::from_angle(body.pose.theta);
  const bool ball = body.shape == world::BodyShape::Ball;
  // A polygon's mesh has its size already.
  const auto across = static_cast<float>(body.corners ? 1.0 : body.radius);
  const std::uint8_t mark = is_dark(body.colour) ? 240 : 40;
  return {static_cast<float>(body.pose.x),
          static_cast<float>(body.pose.y),
          static_cast<float>(heading.cos),
          static_cast<float>(heading.sin),
          across,
          across,
          static_cast<float>(ball ? body.radius : body.height),
          {body.colour.r, body.colour.g, body.colour.b, 255},
          {mark, mark, mark, 255}};
}

void BodyPainter::add_polygon(const world::BodyView& body) {
  if (!body.corners) return;
  const BodyMesh mesh = polygon_mesh(*body.corners);
  const auto first = static_cast<std::uint32_t>(corners_.size());
  const Instance instance = instance_of(body);
  for (const BodyVertex& vertex : mesh.vertices) corners_.push_back({vertex, instance});
  for (const std::uint32_t index : mesh.indices) indices_.push_back(first + index);
}

void BodyPainter::draw_polygons() {
  if (indices_.empty()) return;
  gl_.bind_vertex_array(polygon_array_);
  fill_buffer(gl_, GL_ARRAY_BUFFER, polygon_corners_, corners_, GL_STREAM_DRAW);
  fill_buffer(gl_, GL_ELEMENT_ARRAY_BUFFER, polygon_indices_, indices_, GL_STREAM_DRAW);
  gl_.draw_elements_instanced(GL_TRIANGLES, static_cast<GLsizei>(indices_.size()), GL_UNSIGNED_INT,
                              nullptr, 1);
}

void BodyPainter::draw(std::span<const world::BodyView> bodies, std::uint32_t carrier,
                       const Lens& lens, const VisibleWalls& walls,
                       const std::array<float, 16>& clip_from_world, float light) {
  bool any = false;
  for (Shape& shape : shapes_) shape.visible.clear();
  corners_.clear();
  indices_.clear();
  for (const world::BodyView& body : bodies) {
    const Vec3 middle{body.pose.x, body.pose.y, 0.5 * body.height};
    if (body.id == carrier || !lens.may_see(middle, body.radius + 0.5 * body.height)) continue;
    if (walls.hide(body.pose.position(), body.radius, body.height)) continue;
    any = true;
    if (body.shape == world::BodyShape::Polygon) {
      add_polygon(body);
    } else {
      shapes_[static_cast<std::size_t>(body.shape)].visible.push_back(instance_of(body));
    }
  }
  if (!any) return;
  gl_.use_program(program_);
  gl_.uniform_1f(light_, light);
  gl_.uniform_matrix_4fv(clip_from_world_, 1, GL_FALSE, clip_from_world.data());
  draw_polygons();
  for (const Shape& shape : shapes_) {
    if (shape.visible.empty()) continue;
    fill_buffer(gl_, GL_ARRAY_BUFFER, shape.instances, shape.visible, GL_STREAM_DRAW);
    gl_.bind_vertex_array(shape.array);
    gl_.draw_elements_instanced(GL_TRIANGLES, shape.index_count, GL_UNSIGNED_INT, nullptr,
                                static_cast<GLsizei>(shape.visible.size()));
  }
}

}  // namespace eyebridge::camera
