#include "ground.hpp"

#include <system_error>

#include "eyebridge/files/readers.hpp"
#include "eyebridge/files/search.hpp"
#include "map_world.hpp"
#include "maze_formats.hpp"

namespace eyebridge::files {

void read_water(const Statement& s, std::optional<double>& water) {
  s.expect_arguments(1, "water MM");
  if (water) s.fail(0, "a second 'water': expected one");
  water = s.millimetres(1, "the depth of the water", 1, 1e6);
}

std::optional<GroundKind> ground_kind(const std::filesystem::path& path) {
  const std::string ending = lower(path.extension().string());
  if (ending == ".wld") return GroundKind::World;
  if (ending == ".yaml" || ending == ".yml") return GroundKind::Map;
  if (ending == ".maz" || maze_format(read_maze_file(path))) return GroundKind::Maze;
  return std::nullopt;
}

void load_ground(const std::filesystem::path& path, GroundKind kind, Scenario& scenario,
                 const LoadOptions& options) {
  const std::string name = path.string();
  switch (kind) {
    case GroundKind::World:
      scenario.world = read_world(read_text_file(path), name, scenario.warnings,
                                  &scenario.start_places, options.reading);
      break;
    case GroundKind::Maze:
      scenario.world = read_maze(read_maze_file(path), name, scenario.warnings,
                                 &scenario.start_places, options.cell);
      break;
    case GroundKind::Map:
      scenario.world = world_of(read_map_files(path, scenario.warnings), name, scenario.warnings);
      scenario.start_places.assign(scenario.world.starts.size(), {name, 0, 0});
      break;
  }
  auto& texture = scenario.world.floor_texture;
  if (!texture) return;
  std::vector<std::filesystem::path> folders = {path.parent_path(), "", scenario.directory};
  for (std::filesystem::path& place : options.places.folders()) folders.push_back(std::move(place));
  const auto found = look_for(*texture, folders, options.places);
  std::error_code error;
  if (found) texture = std::filesystem::absolute(*found, error).lexically_normal().string();
}

}  // namespace eyebridge::files
