#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/mapping/occupancy_grid.hpp"

namespace eyebridge::files {

// Grids of a floor as files: ROS's maps (a .yaml beside a .pgm picture, as map_server of ROS and of
// Nav2 reads and writes them) and CSV. As everywhere in this room, bad input is a ConfigError with
// file, line and column.

/// How a picture's greys become probabilities, p being (255 - grey) / 255, or grey / 255 if
/// negated.
enum class MapMode {
  Trinary,  ///< p above occupied_thresh: occupied, below free_thresh: free, else unknown.
  Scale,    ///< As Trinary, but in between p is scaled to 0 … 1.
  Raw,      ///< The grey is per cent occupied, 0 … 100; all others are unknown.
};

/// The `.yaml` of a map.
struct MapDescription {
  std::string image;  ///< As written: relative to the .yaml.
  SourceLocation image_where{};
  double resolution = 0.05;  ///< Metres a pixel.
  Vec2 origin{};             ///< Lower left corner of the lower left pixel, metres.
  double yaw = 0.0;          ///< The picture is turned about it by so much, radians.
  bool negate = false;
  double occupied_thresh = 0.65;
  double free_thresh = 0.196;
  MapMode mode = MapMode::Trinary;
};

/// A picture of greys, 0 black … 255 white; from the upper left pixel, row by row.
struct GreyPicture {
  int columns = 0;
  int rows = 0;
  std::vector<std::uint8_t> greys;

  friend bool operator==(const GreyPicture&, const GreyPicture&) = default;
};

/// Reads the text of a `.yaml`: `image`, `resolution` and `origin` must be there, `negate`,
/// `occupied_thresh`, `free_thresh` and `mode` may be, other keys are ignored with a warning.
/// Throws ConfigError.
MapDescription read_map_description(std::string_view text, const std::string& file,
                                    std::vector<Warning>& warnings);
/// Reads a PNM, PNG or BMP picture, of at most mapping::kMostMapCells pixels: colours as the mean
/// of red, green and blue, 16 bits as the upper 8. Throws ConfigError.
GreyPicture read_map_picture(std::string_view bytes, const std::string& file);
/// The grid that a map stands for; thresholds become those of its settings. It lies along the axes:
/// of a map that is turned, a cell is as the pixel under its centre.
mapping::OccupancyGrid map_of(const MapDescription& description, const GreyPicture& picture);
/// Whether a map's pixel of this grey is occupied: a wall.
bool is_occupied(const MapDescription& description, std::uint8_t grey);

/// Whether it is free: known to have no wall.
bool is_free(const MapDescription& description, std::uint8_t grey);

/// The two files of a map.
struct MapFiles {
  MapDescription description;
  GreyPicture picture;
};
/// Reads the .yaml at `path`, and the picture that it names. Throws ConfigError.
MapFiles read_map_files(const std::filesystem::path& path, std::vector<Warning>& warnings);
/// Reads the map at `path`, a .yaml, with its picture. Throws ConfigError.
mapping::OccupancyGrid load_map(const std::filesystem::path& path, std::vector<Warning>& warnings);

/// The texts of the two files of a map.
struct MapTexts {
  std::string yaml;
  std::string pgm;
};
/// Writes `grid` as a map whose picture will be called `image`. In Trinary mode its states survive,
/// in the others its probabilities to one half per cent. Throws ConfigError for a name that cannot
/// be written on a line, and for a grid that could not be read back: one of more than
/// mapping::kMostMapCells, for example.
MapTexts write_map(const mapping::OccupancyGrid& grid, const std::string& image,
                   MapMode mode = MapMode::Trinary);
/// Writes the map to `path`, a .yaml, and a .pgm of the same name beside it. Throws ConfigError
/// when it cannot.
void save_map(const mapping::OccupancyGrid& grid, const std::filesystem::path& path,
              MapMode mode = MapMode::Trinary);

/// CSV: a line `resolution,0.05`, a line `origin,-1,-2`, then a line for each row of cells, the
/// upper one first: probabilities with four decimals, separated by commas. Throws ConfigError.
mapping::OccupancyGrid read_map_csv(std::string_view text, const std::string& file);
/// The same backwards. Throws ConfigError for a grid that could not be read back.
std::string write_map_csv(const mapping::OccupancyGrid& grid);
/// Writes that to `path`. Throws ConfigError when it cannot.
void save_map_csv(const mapping::OccupancyGrid& grid, const std::filesystem::path& path);

}  // namespace eyebridge::files
