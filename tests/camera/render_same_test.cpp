#include <cstdlib>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "eyebridge/camera/png.hpp"
#include "fake_view.hpp"
#include "render/gl_context.hpp"
#include "scenes.hpp"

namespace eyebridge::camera::testing {
namespace {

constexpr double kSamePicture = 45.0;  // dB

// By OSMesa of Debian 12. EYEBRIDGE_TEST_ACCEPT=1 writes them anew.
TEST(Render, EveryMakerDrawsThePicturesThatAreKept) {
  RecordingLog log;
  std::vector<std::unique_ptr<RenderEngine>> engines;
  for (const GlContextMaker& maker : gl_context_makers()) {
    engines.push_back(std::make_unique<RenderEngine>(maker.name, log));
  }
  const world::Scene scene = maze_scene(13, 7);
  for (int i = 0; i < 3; ++i) {  // taking turns on one thread must not mix the contexts up
    Shot shot = maze_shot(scene, 320, 240);
    shot.eye.heading = 0.7 * i;
    const std::string kept =
        EYEBRIDGE_SOURCE_DIR "/tests/camera/pictures/maze-" + std::to_string(i) + ".png";
    if (std::getenv("EYEBRIDGE_TEST_ACCEPT") != nullptr) {
      write_png(picture(*engines.front(), shot), kept);
    }
    for (const auto& engine : engines) {
      EXPECT_GE(psnr(picture(*engine, shot), read_png(kept)), kSamePicture)
          << engine->maker() << ", " << kept;
    }
  }
}

TEST(Render, TheFirstPictureOfAContextIsAsGoodAsTheSecond) {
  RecordingLog log;
  const Shot shot = maze_shot(maze_scene(13, 7), 320, 240);
  for (const GlContextMaker& maker : gl_context_makers()) {
    RenderEngine engine(maker.name, log);
    const Frame first = picture(engine, shot);
    EXPECT_EQ(first.bytes, picture(engine, shot).bytes) << maker.name;
  }
}

TEST(Render, TwoContextsGiveTheSameBytes) {
  RecordingLog log;
  const Shot shot = maze_shot(maze_scene(13, 7), 320, 240);
  RenderEngine here(first_maker(), log);
  Frame from_another_thread;
  std::thread([&] {
    RenderEngine there(first_maker(), log);
    from_another_thread = picture(there, shot);
  }).join();
  EXPECT_EQ(picture(here, shot).bytes, from_another_thread.bytes);
}

TEST(Render, ChangingSizeAndWorldAndBackChangesNothing) {
  RecordingLog log;
  RenderEngine engine(first_maker(), log);
  const Shot shot = maze_shot(maze_scene(13, 7), 320, 240);
  const Frame before = picture(engine, shot);
  const Frame other = picture(engine, maze_shot(maze_scene(5, 3), 640, 480));
  EXPECT_EQ(other.width, 640);
  EXPECT_EQ(other.height, 480);
  EXPECT_EQ(picture(engine, shot).bytes, before.bytes);
}

TEST(Render, DifferentPlacesGiveDifferentPictures) {
  RecordingLog log;
  RenderEngine engine(first_maker(), log);
  Shot shot = maze_shot(maze_scene(13, 7), 320, 240);
  const Frame here = picture(engine, shot);
  shot.eye.x += 0.05;
  EXPECT_LT(psnr(here, picture(engine, shot)), kSamePicture);
}

TEST(Render, OneThreadHasOneEnginePerMaker) {
  RecordingLog log;
  RenderEngine& first = RenderEngine::of_this_thread(first_maker(), log);
  EXPECT_EQ(&first, &RenderEngine::of_this_thread(first_maker(), log));
  RenderEngine* other = &first;
  std::thread([&] { other = &RenderEngine::of_this_thread(first_maker(), log); }).join();
  EXPECT_NE(&first, other);
}

}  // namespace
}  // namespace eyebridge::camera::testing
