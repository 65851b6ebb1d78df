#include "eyebridge/files/readers.hpp"
#include "text.hpp"

namespace eyebridge::files {

std::string write_world(const world::WorldModel& model) {
  const std::string name = "world to write";
  const auto refuse = [&](const std::string& why) { throw ConfigError({name, 0, 0}, why); };
  if (model.maze) refuse("it is a maze: expected a world without a grid (write_maze draws mazes)");
  if (!model.objects.empty() || !model.markers.empty()) {
    refuse("it has objects or markers: a .wld file cannot hold them, a .sim file can");
  }

  std::string out =
      "floor " + write_millimetres(model.width) + ' ' + write_millimetres(model.height) + '\n';
  if (model.floor_texture) {
    const std::string texture = write_word(*model.floor_texture);
    if (texture.empty()) refuse("its floor_texture cannot be quoted");
    out += "floor_texture " + texture + '\n';
  }
  if (model.water) out += "water " + write_millimetres(*model.water) + '\n';
  for (const world::StartPose& start : model.starts) {
    out += "position " + write_millimetres(start.pose.x) + ' ' + write_millimetres(start.pose.y) +
           ' ' + write_degrees(start.pose.theta) + '\n';
  }
  for (const world::Wall& wall : model.walls) {
    for (const double end : {wall.a.x, wall.a.y, wall.b.x, wall.b.y}) {
      out += write_millimetres(end) + ' ';
    }
    out.pop_back();
    const bool coloured = wall.colour != world::Wall::kDefaultColour;
    if (coloured || wall.thickness != world::Wall::kFileThickness ||
        wall.height != world::Wall::kDefaultHeight) {
      out += ' ' + write_millimetres(wall.thickness) + ' ' + write_millimetres(wall.height);
    }
    if (coloured) {
      for (const int channel : {wall.colour.r, wall.colour.g, wall.colour.b}) {
        out += ' ' + std::to_string(channel);
      }
    }
    out += '\n';
  }

  std::vector<Warning> warnings;
  if (read_world(out, name, warnings) != model) {
    refuse("a .wld file cannot say all of it (start letters, sizes or coordinates out of range)");
  }
  return out;
}

}  // namespace eyebridge::files
