#include "ground.hpp"

#include <system_error>

#include "eyebridge/files/readers.hpp"
#include "eyebridge/files/search.hpp"

namespace eyebridge::files {

void read_water(const Statement& s, std::optional<double>& water) {
  s.expect_arguments(1, "water MM");
  if (water) s.fail(0, "a second 'water': expected one");
  water = s.millimetres(1, "the depth of the water", 1, 1e6);
}

void load_ground(const std::filesystem::path& path, GroundKind kind, const SearchPlaces& places,
                 Scenario& scenario, Reading reading) {
  const std::string text = read_text_file(path);
  const std::string name = path.string();
  scenario.world = kind == GroundKind::World
                       ? read_world(text, name, scenario.warnings, &scenario.start_places, reading)
                       : read_maze(text, name, scenario.warnings, &scenario.start_places);
  auto& texture = scenario.world.floor_texture;
  if (!texture) return;
  std::vector<std::filesystem::path> folders = {path.parent_path(), "", scenario.directory};
  for (std::filesystem::path& place : places.folders()) folders.push_back(std::move(place));
  const auto found = look_for(*texture, folders, places);
  std::error_code error;
  if (found) texture = std::filesystem::absolute(*found, error).lexically_normal().string();
}

}  // namespace eyebridge::files
