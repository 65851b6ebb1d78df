#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/camera/png.hpp"
#include "fake_view.hpp"
#include "picture_files.hpp"
#include "scenes.hpp"

namespace eyebridge::camera::testing {
namespace {

using ::testing::DoubleNear;
using ::testing::HasSubstr;
using ::testing::Pointwise;

/// A floor seen from straight above its middle, north up.
Shot floor_shot(const std::string& texture, const std::string& directory) {
  world::WorldModel model = empty_room();
  if (!texture.empty()) model.floor_texture = texture;
  Shot shot;
  shot.scene.model = std::make_shared<const world::WorldModel>(std::move(model));
  shot.eye = {2.0, 2.0, 1.0, 1.5707963267948966, -1.5707963267948966, 2.2};
  shot.texture_directory = directory;
  shot.width = 160;
  shot.height = 160;
  return shot;
}

TEST(FloorTexture, IsStretchedOnceOverTheFloorNorthUp) {
  const Folder folder;
  Frame quarters = make_frame(64, 64, PixelFormat::Rgb24);
  for (std::size_t y = 0; y < 64; ++y) {
    for (std::size_t x = 0; x < 64; ++x) {
      std::uint8_t* p = &quarters.bytes[3 * (64 * y + x)];
      p[0] = x < 32 ? 255 : 0;  // west
      p[1] = y < 32 ? 255 : 0;  // north: the picture's upper half
    }
  }
  write_png(quarters, folder / "floor.png");
  RecordingLog log;
  RenderEngine engine(first_maker(), log);
  const Frame seen = engine.render(floor_shot("floor.png", folder.str()), log);
  EXPECT_TRUE(log.warnings.empty());
  const auto at = [&](int x, int y) {
    const auto row = seen.row(y);
    const auto i = static_cast<std::size_t>(3 * x);
    return std::vector<int>{row[i], row[i + 1]};
  };
  EXPECT_EQ(at(40, 40), (std::vector<int>{255, 255}));
  EXPECT_EQ(at(120, 40), (std::vector<int>{0, 255}));
  EXPECT_EQ(at(40, 120), (std::vector<int>{255, 0}));
  EXPECT_EQ(at(120, 120), (std::vector<int>{0, 0}));
}

TEST(FloorTexture, OneThatCannotBeReadGivesThePlainFloorAndOneWarning) {
  const Folder folder;
  RecordingLog log;
  RenderEngine engine(first_maker(), log);
  const Shot shot = floor_shot("missing.png", folder.str());
  const Frame seen = engine.render(shot, log);
  engine.render(shot, log);
  ASSERT_EQ(log.warnings.size(), 1U);
  EXPECT_THAT(log.warnings[0], HasSubstr("missing.png"));
  EXPECT_EQ(seen.bytes, engine.render(floor_shot("", folder.str()), log).bytes);
}

/// The colours of its middle row, a quarter and three quarters across: red and blue of each.
std::vector<int> left_and_right(const char* texture, const Folder& folder) {
  RecordingLog log;
  RenderEngine engine(first_maker(), log);
  const Frame seen = engine.render(floor_shot(texture, folder.str()), log);
  EXPECT_TRUE(log.warnings.empty());
  const auto row = seen.row(80);
  return {row[3 * 40], row[3 * 40 + 2], row[3 * 120], row[3 * 120 + 2]};
}

TEST(FloorTexture, MayBeAJpegOrABmp) {
  const Folder folder;
  folder.write("floor.jpg", jpeg_of(halves(64, 64), TJSAMP_444, 0));
  EXPECT_THAT(left_and_right("floor.jpg", folder),
              Pointwise(DoubleNear(6), {200.0, 0.0, 0.0, 200.0}));

  Bytes bmp{'B', 'M', 0, 0, 0, 0, 0, 0, 0, 0, 26, 0, 0, 0, 12, 0, 0, 0, 2, 0, 1, 0, 1, 0, 24, 0};
  bmp.insert(bmp.end(), {0, 0, 200, 200, 0, 0, 0, 0});
  folder.write("floor.bmp", bmp);
  EXPECT_THAT(left_and_right("floor.bmp", folder),
              Pointwise(DoubleNear(6), {200.0, 0.0, 0.0, 200.0}));
}

}  // namespace
}  // namespace eyebridge::camera::testing
