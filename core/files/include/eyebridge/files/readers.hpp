#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "eyebridge/files/error_rules.hpp"
#include "eyebridge/files/scenario.hpp"

namespace eyebridge::files {

// Text in, model out. Every reader takes the text and the name to use in messages, touches no file,
// and throws ConfigError with file, line and column, what was found and what was expected. Oddities
// that still have one clear meaning go to `warnings`; with Reading::Tolerant what a line breaks
// does, too. Formats: reference/robios7.md section 5 and
// reference/robios-classic.md section 7 (facts), worlds/README.md (our extensions).

/// EyeSim / Saphira world (`.wld`): sizes, walls, push/pop, position, floor_texture, and our
/// own water.
///
/// Without a size the floor reaches to the farthest walls (a warning); nothing is ever shifted, so
/// walls that all lie at negative coordinates are an error then. `start_places`, unless null, gets
/// the place in the file of each of the model's starts.
world::WorldModel read_world(std::string_view text, const std::string& file,
                             std::vector<Warning>& warnings,
                             std::vector<SourceLocation>* start_places = nullptr,
                             Reading reading = Reading::Strict);

/// How a maze is kept.
enum class MazeFormat {
  Drawing,  ///< EyeSim's `.maz`, drawn with `|` and `_`;
  Posts,    ///< drawn with posts, `o` or `+`, and walls `---` and `|` between them;
  List,     ///< a line `x y north east south west` for each cell, `.num`;
  Binary,   ///< a byte for each cell of 16 x 16 or 32 x 32.
};

/// The format that `bytes` have; nothing where they are no maze at all.
std::optional<MazeFormat> maze_format(std::string_view bytes);

/// A maze in any of these formats; its content says which. `cell` is the edge length of a cell,
/// metres, whatever the file says of it.
///
/// Drawing: what stands off the grid is ignored with a warning; `O`, `X` and `G` are a ball, a
/// crate and a goal with a wall below, as with the letters of starts. A drawing with three columns
/// a cell
/// ("|__|") instead of two is recognised and read as such, with one warning. A cell is 360 mm
/// unless the last line says another size.
///
/// The others are those of contests: a cell is 180 mm, the robot starts at `S`, or in the lower
/// left cell, facing a side that is open; goals are the cells with a `G`, or those in the middle.
///
/// An outer boundary that is open, and a maze without walls, are warnings with a place.
/// `start_places` as in read_world().
world::WorldModel read_maze(std::string_view bytes, const std::string& file,
                            std::vector<Warning>& warnings,
                            std::vector<SourceLocation>* start_places = nullptr,
                            std::optional<double> cell = std::nullopt);

/// Robot description (`.robi`), both dialects: the new one has `drive` as its first keyword, and
/// its `wheel` gives half the wheel base.
///
/// Without `diameter` the body is the disc about the robot's centre that covers all colliders,
/// without those twice the wheel base. Without `speed` and `turn` the wheels' top speed counts.
/// PSDs with a negative or no id get one: 1 to 4 for PSD_FRONT, _LEFT, _RIGHT, _BACK, then 5 on.
robot::RobotModel read_robi(std::string_view text, const std::string& file,
                            std::vector<Warning>& warnings, Reading reading = Reading::Strict);

/// EyeSim's description of an object (`.esObj`). A single sphere is a ball, a single box about the
/// object's centre a box; all else a disc that covers the colliders from above. `name` is what it
/// is called when the file gives no name.
world::ObjectSpec read_object(std::string_view text, const std::string& file,
                              const std::string& name, std::vector<Warning>& warnings,
                              Reading reading = Reading::Strict);

/// EyeSim 1–4 parameter file (`eyesim.p`), without the world it names.
struct ParameterFile {
  robot::RobotModel robot;
  std::optional<std::string> world;  ///< File names as written.
  std::optional<std::string> maze;
  SourceLocation world_where;  ///< Of the name of the world or maze.
  bool pause = false;
  bool debug = false;
};
ParameterFile read_parameter_file(std::string_view text, const std::string& file,
                                  std::vector<Warning>& warnings);

/// What lines after that of an object say of it. What is not set stays as the object has it.
struct ObjectTraits {
  bool any = false;                     ///< Whether there was such a line;
  SourceLocation where;                 ///< the first one.
  std::optional<double> mass{};         ///< Kilograms.
  std::optional<double> friction{};     ///< Coefficient.
  std::optional<double> restitution{};  ///< 0 ... 1.
  bool fixed = false;
  bool loose = false;  ///< Not fixed, whatever was said before.
  bool still = false;  ///< Does not move by itself, whatever was said before.
  std::optional<world::Path> path{};
  SourceLocation path_where;
  std::optional<world::Reaction> reaction{};
  std::optional<double> yields_within{};  ///< Metres.

  /// Whether a robot may have them, too.
  [[nodiscard]] bool fit_a_robot() const {
    return !mass && !restitution && !fixed && !loose && !still && !path && !reaction &&
           !yields_within;
  }
};

/// One robot line of a `.sim`, before its model and its start letter are looked up.
struct SimRobot {
  std::string model;          ///< Name as written.
  std::optional<char> start;  ///< Letter of the maze …
  std::optional<Pose> pose;   ///< … or a pose; with a letter only `pose->theta` counts.
  std::string program;
  std::vector<std::string> arguments;
  SourceLocation where;
  ObjectTraits traits;  ///< A robot may have a friction; an object that a file describes all.
  std::optional<double> enters{};  ///< Seconds after the start; only robots may.
  SourceLocation enters_where{};
};
/// Simulation description (`.sim`), without the files it names.
struct SimFile {
  std::optional<std::string> world;  ///< .wld or .maz, as written.
  SourceLocation world_where;
  std::optional<double> water{};  ///< Its depth, metres; none: as the world says.
  std::vector<std::pair<std::string, SourceLocation>> robot_files;
  std::vector<std::pair<std::string, SourceLocation>> object_files;
  std::vector<SimRobot> robots;
  std::vector<world::ObjectSpec> objects;
  std::vector<SourceLocation>
      path_places;  ///< Of each of `objects`; of those without a path: none.
  std::vector<world::Marker> markers;
  std::vector<ErrorRule> errors;
  bool show_sensors = false;
  bool show_trail = false;
};
SimFile read_sim(std::string_view text, const std::string& file, std::vector<Warning>& warnings,
                 Reading reading = Reading::Strict);

/// What the file with this text says about itself: the first line of the comment that it begins
/// with, as UTF-8 without control characters; "" where it begins with none (mazes: a drawing has no
/// comments).
std::string description_in(std::string_view text);

/// The whole file at `path`, at most `kMaxFileSize` bytes. Throws ConfigError when it is missing,
/// unreadable, too big or not text. What other systems write is as if written here: UTF-16 and
/// Latin-1 become UTF-8, the ends of lines "\n", no-break blanks blanks.
inline constexpr std::size_t kMaxFileSize = 64U << 20U;
std::string read_text_file(const std::filesystem::path& path);
/// The same of a maze, whose bytes may be no text.
std::string read_maze_file(const std::filesystem::path& path);
/// The same, whatever bytes they are. `what` it should be is for messages: "a DBC file".
std::string read_bytes(const std::filesystem::path& path, const std::string& what);

/// What a file with a floor and walls is.
enum class GroundKind { World, Maze, Map, Svg, Stage, IrSim };
/// What the file at `path` is by its ending, or where that says nothing by its content; nothing:
/// neither. Throws ConfigError when it cannot be read.
std::optional<GroundKind> ground_kind(const std::filesystem::path& path);

/// Writes `model` so that read_world() gives an equal model back.
std::string write_world(const world::WorldModel& model);
/// Writes `model` so that read_maze() gives an equal model back. Throws ConfigError when the model
/// is no maze or has objects a maze cannot draw.
std::string write_maze(const world::WorldModel& model);
/// A world as text, and what of it the format cannot say, in words.
struct WrittenWorld {
  std::string text;
  std::vector<std::string> losses;
};
/// Writes `model` in a format of text; what read_maze() then gives differs by the losses alone.
/// Throws ConfigError when the model is no maze, and for one that the format cannot draw at all.
WrittenWorld write_maze_as(MazeFormat format, const world::WorldModel& model);
/// Whether two lines of robots say the same, wherever in their files.
bool same_meaning(const SimRobot& a, const SimRobot& b);
/// Whether two simulations say the same, wherever in their files they say it.
bool same_meaning(const SimFile& a, const SimFile& b);
/// Writes `sim` so that read_sim() gives one of the same meaning back. Places in files, comments
/// and the order of unlike lines are not kept. Throws ConfigError for what no line can say: objects
/// of other sizes than their kind has, words with both kinds of quotes.
std::string write_sim(const SimFile& sim);

/// One object as a `.sim` file says it: its line, and those of its traits. `name` is what errors
/// call the text. Throws ConfigError for anything else in it.
world::ObjectSpec read_object_text(std::string_view text, const std::string& name);
/// `object`, of which the lines in `text` say more: only such as may follow that of an object in a
/// `.sim` file. Throws ConfigError; `name` is what errors call the text.
world::ObjectSpec read_object_change(world::ObjectSpec object, std::string_view text,
                                     const std::string& name);
/// Writes `object` so that read_object_text() gives an equal one back. Throws as write_sim() does.
std::string write_object_text(const world::ObjectSpec& object);

}  // namespace eyebridge::files
