#include "ground.hpp"

#include <system_error>

#include "eyebridge/files/foreign_worlds.hpp"
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

namespace {

/// Files that the one at `path` names: from its folder, or under their last name beside it, where
/// a file is that was taken out of a project.
NamedFiles files_beside(const std::filesystem::path& path, std::vector<Warning>& warnings) {
  const auto found = [folder = path.parent_path(), &warnings](const std::string& name,
                                                              const SourceLocation& where) {
    std::filesystem::path file = folder / name;
    std::error_code error;
    if (std::filesystem::exists(file, error)) return file;
    std::filesystem::path beside = folder / std::filesystem::path(name).filename();
    if (!std::filesystem::is_regular_file(beside, error)) {
      throw ConfigError(where, "no such file: " + in_quotes(file.string(), 200));
    }
    warnings.push_back({where, "no " + in_quotes(file.string(), 200) + ": read " +
                                   in_quotes(beside.string(), 200)});
    return beside;
  };
  return {[found](const std::string& name, const SourceLocation& where) {
            return read_text_file(found(name, where));
          },
          [found](const std::string& name, const SourceLocation& where) {
            const std::filesystem::path file = found(name, where);
            return read_map_picture(read_bytes(file, "a picture"), file.string());
          }};
}

}  // namespace

std::optional<GroundKind> ground_kind(const std::filesystem::path& path) {
  const std::string ending = lower(path.extension().string());
  if (ending == ".wld") return GroundKind::World;
  if (ending == ".svg") return GroundKind::Svg;
  if (ending == ".world") return GroundKind::Stage;
  if (ending == ".yaml" || ending == ".yml") {
    return is_irsim(read_text_file(path)) ? GroundKind::IrSim : GroundKind::Map;
  }
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
    case GroundKind::Svg:
      scenario.world =
          read_svg(read_text_file(path), name, scenario.warnings, &scenario.start_places);
      break;
    case GroundKind::Stage:
      scenario.world = read_stage(read_text_file(path), name, files_beside(path, scenario.warnings),
                                  scenario.warnings, &scenario.start_places);
      break;
    case GroundKind::IrSim:
      scenario.world = read_irsim(read_text_file(path), name, files_beside(path, scenario.warnings),
                                  scenario.warnings, &scenario.start_places);
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
