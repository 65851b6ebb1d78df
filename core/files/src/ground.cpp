#include "ground.hpp"

#include <system_error>

#include "eyebridge/files/readers.hpp"
#include "eyebridge/files/search.hpp"

namespace eyebridge::files {

void load_ground(const std::filesystem::path& path, GroundKind kind, const SearchPlaces& places,
                 Scenario& scenario) {
  const std::string text = read_text_file(path);
  const auto read = kind == GroundKind::World ? read_world : read_maze;
  scenario.world = read(text, path.string(), scenario.warnings, &scenario.start_places);
  auto& texture = scenario.world.floor_texture;
  if (!texture) return;
  std::vector<std::filesystem::path> folders = {path.parent_path(), "", scenario.directory};
  for (std::filesystem::path& place : places.folders()) folders.push_back(std::move(place));
  const auto found = look_for(*texture, folders, places);
  std::error_code error;
  if (found) texture = std::filesystem::absolute(*found, error).lexically_normal().string();
}

}  // namespace eyebridge::files
