#include "render/engine.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>

#include <libyuv.h>

#include "eyebridge/base/log.hpp"
#include "eyebridge/camera/convert.hpp"
#include "eyebridge/camera/picture.hpp"
#include "render/body_painter.hpp"
#include "render/fiducial_painter.hpp"
#include "render/gl_objects.hpp"
#include "render/mesh.hpp"
#include "render/picture_painter.hpp"
#include "render/world_painter.hpp"

namespace eyebridge::camera {
namespace {

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
  WorldPainter world;
  BodyPainter bodies;
  std::optional<PicturePainter> floor;       // made when a world has a picture on its floor
  std::optional<FiducialPainter> fiducials;  // made when a shot shows them

  std::shared_ptr<const world::WorldModel> model;  // drawn last
  std::string texture_directory;
  bool floor_has_picture = false;
  std::shared_ptr<const world::WorldModel> marked;        // whose fiducials those are, …
  FiducialFamily marked_with = FiducialFamily::Aruco5x5;  // … and of which family
  double extent = 0.0;  // of the walls and the floor from the origin, metres
  std::vector<std::uint8_t> rgba;

  Impl(std::string_view maker, LogSink& log)
      : context(make_gl_context(maker, log)), gl(*context), target(gl), world(gl), bodies(gl) {
    gl.enable(GL_DEPTH_TEST);
    gl.depth_func(GL_LESS);
    gl.pixel_store_i(GL_PACK_ALIGNMENT, 1);
  }

  void take_world(const Shot& shot, LogSink& log) {
    if (model == shot.scene.model && texture_directory == shot.texture_directory) return;
    model = shot.scene.model;
    texture_directory = shot.texture_directory;
    const Vec2 far = model->far_corner();
    extent = std::max(
        {std::abs(far.x), std::abs(far.y), std::abs(model->corner.x), std::abs(model->corner.y)});
    for (const world::Wall& wall : model->walls) {
      for (const Vec2 end : {wall.a, wall.b}) {
        extent = std::max({extent, std::abs(end.x), std::abs(end.y)});
      }
      extent = std::max(extent, wall.height);
    }
    const std::optional<Frame> picture = floor_picture(*model, texture_directory, log);
    floor_has_picture = picture.has_value();
    world.take(*model, /*tiles=*/!floor_has_picture);
    if (!floor_has_picture) return;
    if (!floor) floor.emplace(gl, PicturePainter::Edges::Smooth);
    floor->take(mip_levels(picture_texture(*picture)), floor_mesh(*model, Pattern::Plain));
  }

  void draw_fiducials(FiducialFamily family, const Lens& lens, const std::array<float, 16>& matrix,
                      float light) {
    if (!fiducials) fiducials.emplace(gl);
    if (marked != model || marked_with != family) {
      fiducials->take(*model, family);
      marked = model;
      marked_with = family;
    }
    fiducials->draw(lens, world.walls(), matrix, light);
  }

  /// What has been drawn.
  Frame read_picture_back(int width, int height) {
    const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    rgba.resize(std::max(rgba.size(), 4 * pixels));
    // As it lies in memory: Mesa leaves the fourth byte out a pixel at a time.
    gl.read_pixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    Frame frame = make_frame(width, height, PixelFormat::Rgb24);
    // libyuv names the bytes of a word from its highest: to it these are ABGR and "raw".
    libyuv::ABGRToRAW(rgba.data(), 4 * width, frame.bytes.data(), frame.stride, width, height);
    return frame;
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
  const auto light = static_cast<float>(shot.light);

  gl.clear_color(0.62F * light, 0.78F * light, 0.92F * light, 1.0F);
  gl.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  my.world.draw(lens, matrix, light);
  my.bodies.draw(shot.scene.bodies, shot.carrier, lens, my.world.walls(), matrix, light);
  if (shot.fiducials) my.draw_fiducials(*shot.fiducials, lens, matrix, light);
  // After all that hides most of it.
  if (my.floor_has_picture) my.floor->draw(triangles_of(0, 1), matrix, light, /*on_top=*/false);
  my.world.draw_markers();

  Frame frame = my.read_picture_back(shot.width, shot.height);
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
