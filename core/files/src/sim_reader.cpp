#include <algorithm>
#include <array>
#include <cstdint>

#include "eyebridge/base/units.hpp"
#include "eyebridge/files/readers.hpp"
#include "ground.hpp"
#include "object_kinds.hpp"
#include "object_lines.hpp"
#include "text.hpp"

namespace eyebridge::files {
namespace {

constexpr std::size_t kMaxThings = 100000;
constexpr std::array<std::string_view, 27> kSimKeywords = {
    "world",  "maze",   "robi",    "robot", "obj",          "object",      "settings",
    "marker", "box",    "mass",    "fixed", "friction",     "restitution", "path",
    "error",  "enters", "speeds",  "waits", "acceleration", "yields",      "follow",
    "flee",   "wander", "polygon", "loose", "still",        "water"};
constexpr std::string_view kRobotForm = "NAME x y phi [program]' or 'NAME S [phi] [program]";

bool is_start_letter(std::string_view word) {
  return word.size() == 1 && std::string_view("SUDLRsudlr").find(word[0]) != std::string_view::npos;
}

/// "can" of "%sim%/worlds/objects/can/can.ms3d".
std::string base_name(std::string_view path) {
  const std::size_t slash = path.find_last_of("/\\");
  if (slash != std::string_view::npos) path.remove_prefix(slash + 1);
  return lower(path.substr(0, path.find_last_of('.')));
}

class SimReader {
 public:
  SimReader(std::string_view text, const std::string& file, std::vector<Warning>& warnings,
            Reading reading)
      : statements_(text, file), file_(file), warnings_(file, warnings), reading_(reading) {}

  SimFile read() {
    bool any = false;
    read_lines(statements_, warnings_, reading_, [&](const Statement& s) {
      if (out_.robots.size() + out_.objects.size() + out_.markers.size() + out_.robot_files.size() +
              out_.object_files.size() + out_.errors.size() >
          kMaxThings) {
        s.fail(0,
               "more than " + std::to_string(kMaxThings) + " robots, objects, markers and errors");
      }
      read_statement(s);
      any = true;
    });
    if (!any) {
      throw ConfigError({file_, std::max(1, statements_.line()), 1},
                        "nothing in the file: expected 'world FILE' and robots");
    }
    return std::move(out_);
  }

 private:
  void read_statement(const Statement& s) {
    const std::string keyword = lower(s.text(0));
    if (keyword == "world" || keyword == "maze") {
      s.expect_arguments(1, keyword + " FILE");
      if (out_.world) s.fail(0, "a second world: expected one 'world' or 'maze' line");
      out_.world = path(s, 1);
      out_.world_where = s.where(1);
    } else if (keyword == "robi" || keyword == "robot") {
      read_robot_file(s);
    } else if (keyword == "obj" || keyword == "object") {
      read_object_file(s);
    } else if (keyword == "settings") {
      read_settings(s);
    } else if (keyword == "water") {
      read_water(s, out_.water);
    } else if (keyword == "marker") {
      read_marker(s);
    } else if (keyword == "error") {
      read_error(s);
    } else if (is_object_trait(keyword)) {
      read_trait(s);
    } else if (keyword == "enters") {
      read_entry(s);
    } else if (auto object = builtin_object(keyword)) {
      s.expect_arguments(3, std::string(s.text(0)) + " x y phi");
      object->pose = pose(s, 1);
      add(*object);
    } else if (keyword == "box" &&
               s.size() != 4) {  // with x y phi alone: one that a file describes
      s.expect_arguments({5, 6, 9}, "box x y phi length width [height [red green blue]]");
      add(read_box(s, pose(s, 1)));
    } else if (keyword == "polygon" && s.size() != 4) {
      add(read_polygon(s, pose(s, 1)));
    } else {
      read_robot(s, keyword);
    }
  }

  void add(const world::ObjectSpec& object) {
    out_.objects.push_back(object);
    out_.path_places.emplace_back();
    last_ = Last::Object;
  }
  void add(const SimRobot& robot) {
    out_.robots.push_back(robot);
    last_ = Last::Robot;
  }

  /// Whether a line that places something by its name places an object shows when its file is read.
  void read_trait(const Statement& s) {
    if (last_ == Last::Nothing) {
      s.fail(0, in_quotes(s.text(0)) + " before any object: expected the line of an object first");
    }
    if (last_ == Last::Robot) return read_object_trait(s, out_.robots.back().traits);
    const ObjectTraits traits = read_more(s, out_.objects.back());
    if (lower(s.text(0)) == "path") out_.path_places.back() = traits.path_where;
  }

  /// "enters SECONDS", after the line of a robot: it comes later than the others.
  void read_entry(const Statement& s) {
    if (last_ != Last::Robot) {
      s.fail(0, in_quotes(s.text(0)) + " after no robot: expected the line of a robot before it");
    }
    s.expect_arguments(1, "enters SECONDS");
    SimRobot& robot = out_.robots.back();
    if (robot.enters) s.fail(0, "a second 'enters' for this robot: expected one");
    robot.enters = s.number(1, "the time in seconds", 0.001, 1e6);
    robot.enters_where = s.where(0);
  }

  static std::string path(const Statement& s, std::size_t i) {
    if (s.text(i).empty()) s.fail(i, "empty name: expected a file");
    return std::string(s.text(i));
  }

  static Pose pose(const Statement& s, std::size_t i) {
    return {s.millimetres(i, "x"), s.millimetres(i + 1, "y"), wrap_angle(s.degrees(i + 2, "phi"))};
  }

  static void take_program(const Statement& s, std::size_t i, SimRobot& robot) {
    if (i >= s.size()) return;
    robot.program = std::string(s.text(i));
    for (++i; i < s.size(); ++i) robot.arguments.emplace_back(s.text(i));
  }

  /// "robi FILE", or the old "robi FILE PROGRAM [x y phi]", which also places a robot of it.
  void read_robot_file(const Statement& s) {
    if (s.size() < 2) s.fail(1, "line ends: expected a .robi file");
    out_.robot_files.emplace_back(path(s, 1), s.where(1));
    if (s.size() == 2) return;
    SimRobot robot;
    robot.model = std::string(s.text(1));
    robot.where = s.where(0);
    robot.program = std::string(s.text(2));
    if (s.size() > 3) {
      s.expect_arguments(5, "robi FILE PROGRAM x y phi");
      robot.pose = pose(s, 3);
    }
    add(robot);
  }

  /// "object FILE", or the old "object x y phi friction PICTURE", which places one.
  void read_object_file(const Statement& s) {
    if (s.size() == 6 && s.is_number(1)) {
      const std::string name = base_name(s.text(5));
      auto object = builtin_object(name);
      if (!object) {
        object = builtin_object("can");
        object->name = name;
        warnings_.add(s.line(), s.token(5).column,
                      "picture " + in_quotes(s.text(5)) + " is not read: a can stands there");
      }
      object->pose = pose(s, 1);
      static_cast<void>(s.number(4, "the friction", -1000, 1000));
      add(*object);
      return;
    }
    s.expect_arguments(1, std::string(s.text(0)) + " FILE");
    out_.object_files.emplace_back(path(s, 1), s.where(1));
  }

  void read_settings(const Statement& s) {
    for (std::size_t i = 1; i < s.size(); ++i) {
      const std::string word = lower(s.text(i));
      if (word == "vis") {
        out_.show_sensors = true;
      } else if (word == "trace") {
        out_.show_trail = true;
      } else {
        warnings_.add(
            s.line(), s.token(i).column,
            "unknown setting " + in_quotes(s.text(i)) + " is ignored: expected VIS or TRACE");
      }
    }
  }

  void read_marker(const Statement& s) {
    s.expect_arguments({2, 5, 6}, "marker x y [red green blue [alpha]]");
    world::Marker marker;
    marker.position = {s.millimetres(1, "x"), s.millimetres(2, "y")};
    const auto channel = [&](std::size_t i) {
      return static_cast<std::uint8_t>(s.integer(i, "a colour", 0, 255));
    };
    if (s.size() >= 6) marker.colour = {channel(3), channel(4), channel(5)};
    if (s.size() == 7) static_cast<void>(channel(6));
    out_.markers.push_back(marker);
  }

  void read_error(const Statement& s) {
    std::vector<ErrorWord> words;
    for (std::size_t i = 1; i < s.size(); ++i) words.push_back({s.text(i), s.where(i)});
    if (words.empty()) s.fail(1, "line ends: expected a preset or an error model");
    out_.errors.push_back(read_error_rule(words, s.where(s.size())));
  }

  void read_robot(const Statement& s, const std::string& keyword) {
    const std::string_view near = nearest(keyword, kSimKeywords);
    if (s.size() >= 2 && is_start_letter(s.text(1))) {
      place_at_letter(s);
      return;
    }
    const bool is_cut_off = s.size() < 4 && !near.empty();  // "enter 5": rather a keyword
    if (s.size() < 2 || !s.is_number(1) || is_cut_off) {
      s.fail(0, "unknown keyword " + in_quotes(s.text(0)) + ": expected " +
                    (near.empty() ? one_of(kSimKeywords) + ", or '" + std::string(kRobotForm) + "'"
                                  : in_quotes(near) + "?"));
    }
    SimRobot robot;
    robot.model = std::string(s.text(0));
    robot.where = s.where(0);
    robot.pose = pose(s, 1);
    take_program(s, 4, robot);
    add(robot);
  }

  void place_at_letter(const Statement& s) {
    SimRobot robot;
    robot.model = std::string(s.text(0));
    robot.where = s.where(0);
    robot.start = s.text(1)[0];
    std::size_t next = 2;
    if (s.is_number(2)) {
      robot.pose = Pose{0, 0, wrap_angle(s.degrees(2, "phi"))};
      next = 3;
    }
    take_program(s, next, robot);
    add(robot);
  }

  /// What the last line placed that placed something.
  enum class Last { Nothing, Object, Robot };

  StatementReader statements_;
  const std::string& file_;
  Warnings warnings_;
  Reading reading_;
  SimFile out_;
  Last last_ = Last::Nothing;
};

}  // namespace

SimFile read_sim(std::string_view text, const std::string& file, std::vector<Warning>& warnings,
                 Reading reading) {
  return SimReader(text, file, warnings, reading).read();
}

}  // namespace eyebridge::files
