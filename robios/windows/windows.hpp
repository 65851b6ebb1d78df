#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "eyebridge/base/result.hpp"

namespace eyebridge {
namespace camera {
class LatestFrame;
}
namespace hal {
class DeviceNotes;
class Environment;
class HandGuide;
}  // namespace hal

namespace robios {

class Keys;
class MapBoard;
class Screen;

/// What a robot's panel shows, and where what a person does there goes. All lent.
struct PanelStart {
  std::string title;
  Screen* screen = nullptr;
  Keys* keys = nullptr;
  const camera::LatestFrame* frames = nullptr;  ///< That the program was given.
  const hal::DeviceNotes* notes = nullptr;      ///< What it read and wrote.
};

/// What guides the person who carries a robot's camera. All lent.
struct HandStart {
  std::string title;
  const hal::HandGuide* guide = nullptr;
  /// That the program was given: shown where the guide has no camera of its own.
  const camera::LatestFrame* frames = nullptr;
};

/// A map that a program has. All lent.
struct MapStart {
  std::string title;
  const MapBoard* board = nullptr;
};

/// Who lets robots into a world, and out of it, while its programs run: a run of several. Any
/// thread but those of programs.
class Crew {
 public:
  virtual ~Crew() = default;

  /// Adds a robot, in the words of `eyebridge add`: MODEL x y phi [PROGRAM [ARGUMENTS]],
  /// millimetres and degrees. Its index, from 0; or why it cannot come. Returns when the run has
  /// let it in, which one that is paused does not.
  virtual Result<std::size_t> add(const std::vector<std::string>& words) = 0;
  /// Takes robot `index` out of the run: its program ends as by Ctrl-C, with its results written,
  /// its panel closes, its body leaves the world; the others keep their numbers and go on.
  /// OutOfRange for one that is not there. Returns as add() does.
  virtual Result<void> remove(std::size_t index) = 0;
};

/// What windows need of the process that they are in.
struct WindowsStart {
  /// A person closed the last window while the program runs. Called from the windows' thread.
  std::function<void()> quit;
  std::string program;  ///< Its name, for titles.
};

/// The windows of this process; the plug-in gui/ implements them. They have a thread of their own,
/// and no program ever waits for them. Any thread.
class Windows {
 public:
  virtual ~Windows() = default;

  virtual void open_panel(const PanelStart& start) = 0;
  /// The robot of `screen` has been removed: its panel goes.
  virtual void close_panel(const Screen& screen) = 0;
  virtual void open_hand_view(const HandStart& start) = 0;
  /// Shows a world, lent like all; called once for each. `crew` is null where nobody can be added.
  virtual void open_environment(hal::Environment& environment, Crew* crew) = 0;
  /// Shows a map beside the world that was opened last.
  virtual void open_map(const MapStart& start) = 0;
  /// Opens a file to be edited: a world, maze or simulation (.wld, .maz, .sim), or a program.
  /// Without a name, a new world.
  virtual void edit(const std::string& path) = 0;
  /// The process is about to be ended by a signal: completes films, and keeps edits that are not
  /// saved. Returns when that is done, or a second has passed.
  virtual void complete_files() = 0;
  /// The program has ended, `how` in words: the windows say so and stay. Returns when a person has
  /// closed them all, at once in the windows' own thread; from then on nothing lent is used.
  virtual void finish(const std::string& how) = 0;
};

/// Both sides are of one version, or they do not talk.
inline constexpr int kWindowsVersion = 5;

/// What the plug-in exports as `eyebridge_open_windows`: null, and `why`, where windows cannot be.
/// They live as long as the process.
using OpenWindows = Windows*(int version, WindowsStart start, std::string& why);

}  // namespace robios
}  // namespace eyebridge
