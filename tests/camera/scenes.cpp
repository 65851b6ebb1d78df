#include "scenes.hpp"

#include <cmath>

#include "eyebridge/base/random.hpp"
#include "fake_view.hpp"

namespace eyebridge::camera::testing {

world::WorldModel empty_room() {
  world::WorldModel model;
  model.width = 4.0;
  model.height = 4.0;
  return model;
}

world::Scene maze_scene(int side, std::uint64_t seed) {
  world::MazeGrid maze;
  maze.columns = maze.rows = side;
  maze.cell = 0.3;
  Random random(seed);
  for (int row = 0; row <= side; ++row) {
    for (int column = 0; column < side; ++column) {
      maze.south.push_back(row == 0 || row == side || random.chance(0.5) ? 1 : 0);
    }
  }
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column <= side; ++column) {
      maze.west.push_back(column == 0 || column == side || random.chance(0.5) ? 1 : 0);
    }
  }
  world::WorldModel model;
  model.width = model.height = side * maze.cell;
  model.walls = world::walls_of(maze);
  model.markers.push_back({{0.75, 0.45}, {255, 0, 255}});
  model.maze = maze;

  world::Scene scene;
  scene.model = std::make_shared<const world::WorldModel>(std::move(model));
  for (std::uint32_t i = 0; i < 10; ++i) {
    const Rgb colour{static_cast<std::uint8_t>(25 * i), 90, 200};
    scene.bodies.push_back(
        {i,
         world::BodyShape::Robot,
         {random.uniform() * side * 0.3, random.uniform() * side * 0.3, random.uniform() * 6.0},
         0.05,
         0.08,
         colour});
  }
  scene.bodies.push_back({10, world::BodyShape::Ball, {0.6, 0.45, 0}, 0.021, 0.042, {255, 140, 0}});
  scene.bodies.push_back({11, world::BodyShape::Can, {0.9, 0.5, 0}, 0.033, 0.12, {200, 30, 30}});
  return scene;
}

Shot maze_shot(const world::Scene& scene, int width, int height) {
  Shot shot;
  shot.scene = scene;
  shot.carrier = 0;
  shot.eye.x = 0.15;
  shot.eye.y = 0.45;
  shot.eye.z = 0.12;
  shot.width = width;
  shot.height = height;
  return shot;
}

Frame picture(RenderEngine& engine, const Shot& shot) {
  RecordingLog log;
  return engine.render(shot, log);
}

double psnr(const Frame& a, const Frame& b) {
  double squares = 0.0;
  for (std::size_t i = 0; i < a.bytes.size(); ++i) {
    const double difference = static_cast<double>(a.bytes[i]) - b.bytes[i];
    squares += difference * difference;
  }
  if (squares == 0.0) return 200.0;
  return 10.0 * std::log10(255.0 * 255.0 * static_cast<double>(a.bytes.size()) / squares);
}

}  // namespace eyebridge::camera::testing
