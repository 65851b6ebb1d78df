#include "render/fiducial_painter.hpp"

#include <algorithm>
#include <cstddef>

#include "render/mesh.hpp"
#include "render/textures.hpp"

namespace eyebridge::camera {
namespace {

constexpr int kColumns = 32;
/// Levels of a picture whose sides are multiples of this have whole texels for the first few.
constexpr int kWhole = 32;

/// Of ink and paper, which are neither quite black nor quite white.
constexpr std::uint8_t kDarkCell = 20;
constexpr std::uint8_t kLightCell = 245;

struct Texel {
  int x;
  int y;
};

/// Texels along an edge of a fiducial with its margin: one for each cell. All are of one family.
int tile_size(const std::vector<Fiducial>& fiducials) {
  return fiducials.empty() ? 1 : cells_of(fiducials.front().family) + 2;
}

/// The top left corner of fiducial number `i` with its margin.
Texel tile_of(std::size_t i, int size) {
  const int number = static_cast<int>(i);
  return {size * (number % kColumns), size * (number / kColumns)};
}

TextureLevel picture_of(const std::vector<Fiducial>& fiducials) {
  const int rows = (static_cast<int>(fiducials.size()) + kColumns - 1) / kColumns;
  const int size = tile_size(fiducials);
  TextureLevel level{
      size * kColumns, std::max(1, (size * rows + kWhole - 1) / kWhole) * kWhole, {}};
  const auto width = static_cast<std::size_t>(level.width);
  level.rgba.assign(4 * width * static_cast<std::size_t>(level.height), kLightCell);
  for (std::size_t i = 0; i < fiducials.size(); ++i) {
    const FiducialBits bits = fiducial_bits(fiducials[i].family, fiducials[i].id);
    const auto cells = static_cast<std::size_t>(size - 2);
    const Texel tile = tile_of(i, size);
    for (std::size_t cell = 0; cell < bits.size(); ++cell) {
      const std::size_t x = static_cast<std::size_t>(tile.x) + 1 + cell % cells;
      const std::size_t y = static_cast<std::size_t>(tile.y) + 1 + cell / cells;
      if (bits[cell] == 0) std::fill_n(&level.rgba[4 * (y * width + x)], 3, kDarkCell);
    }
  }
  return level;
}

struct Edge {
  Vec2 left;  ///< As one sees it who faces the wall.
  Vec2 right;
};

/// The edge of `fiducial` with its margin, from above.
Edge edge_of(const Fiducial& fiducial) {
  const Vec2 normal = Heading::from_angle(fiducial.facing).forward();
  const Vec2 half = 0.5 * with_margin(fiducial) * Vec2{-normal.y, normal.x};
  return {fiducial.centre - half, fiducial.centre + half};
}

QuadMesh mesh_of(const std::vector<Fiducial>& fiducials, const TextureLevel& picture) {
  QuadMesh mesh;
  const int size = tile_size(fiducials);
  for (std::size_t i = 0; i < fiducials.size(); ++i) {
    const Fiducial& fiducial = fiducials[i];
    const Edge edge = edge_of(fiducial);
    const double half = 0.5 * with_margin(fiducial);
    const Texel tile = tile_of(i, size);
    const double left = static_cast<double>(tile.x) / picture.width;
    const double right = static_cast<double>(tile.x + size) / picture.width;
    const double top = static_cast<double>(tile.y) / picture.height;
    const double bottom = static_cast<double>(tile.y + size) / picture.height;
    add_quad(mesh,
             {{{edge.left, fiducial.z - half, left, bottom},
               {edge.right, fiducial.z - half, right, bottom},
               {edge.right, fiducial.z + half, right, top},
               {edge.left, fiducial.z + half, left, top}}},
             {255, 255, 255}, Pattern::Plain,
             light_on(Heading::from_angle(fiducial.facing).forward()));
  }
  return mesh;
}

}  // namespace

FiducialPainter::FiducialPainter(const GlFunctions& gl)
    : painter_(gl, PicturePainter::Edges::Sharp) {}

void FiducialPainter::take(const world::WorldModel& model, FiducialFamily family) {
  std::vector<Fiducial> fiducials = place_fiducials(model, {.family = family});
  const TextureLevel picture = picture_of(fiducials);
  painter_.take(mip_levels(picture), mesh_of(fiducials, picture));
  fiducials_ = std::move(fiducials);
}

void FiducialPainter::draw(const Lens& lens, const VisibleWalls& walls,
                           const std::array<float, 16>& clip_from_world, float light) {
  indices_.clear();
  const Vec2 eye{lens.eye().x, lens.eye().y};
  for (std::size_t i = 0; i < fiducials_.size(); ++i) {
    const Fiducial& fiducial = fiducials_[i];
    const Vec3 centre{fiducial.centre.x, fiducial.centre.y, fiducial.z};
    if (!lens.may_see(centre, with_margin(fiducial))) continue;
    const Edge edge = edge_of(fiducial);
    // From behind its wall only the wall is seen.
    if (cross(edge.right - edge.left, eye - edge.left) >= 0.0) continue;
    if (walls.hide(edge.left, edge.right, fiducial.z + with_margin(fiducial))) continue;
    add_triangles(static_cast<std::uint32_t>(i), indices_);
  }
  painter_.draw(indices_, clip_from_world, light, /*on_top=*/true);
}

}  // namespace eyebridge::camera
