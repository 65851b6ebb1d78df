#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "error_parameters.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/files/readers.hpp"
#include "motion_lines.hpp"
#include "object_kinds.hpp"
#include "object_lines.hpp"
#include "text.hpp"

namespace eyebridge::files {
namespace {

[[noreturn]] void refuse_sim(const std::string& why) {
  throw ConfigError({"simulation to write", 0, 0}, why);
}

std::string word(const std::string& text) {
  std::string out = write_word(text);
  if (out.empty()) refuse_sim(in_quotes(text) + " cannot be quoted: expected one kind of quotes");
  return out;
}

std::string place(Vec2 p) { return write_millimetres(p.x) + ' ' + write_millimetres(p.y); }
std::string pose_words(const Pose& pose) {
  return place(pose.position()) + ' ' + write_degrees(pose.theta);
}
std::string channels(Rgb c) {
  return std::to_string(c.r) + ' ' + std::to_string(c.g) + ' ' + std::to_string(c.b);
}

/// `angle` in degrees alone: after a start letter a word with "rad" would be a program. Angles of
/// more than a turn are rounded as they are read, so one of those may be the one that was written.
std::string plain_degrees(double angle) {
  constexpr double kTurn = 360.0;
  constexpr int kMostTurns = 100;  // as the reader takes
  constexpr int kUlps = 4;
  const auto reads_back = [&](double degrees) {
    return std::abs(degrees) <= kMostTurns * kTurn && wrap_angle(deg_to_rad(degrees)) == angle;
  };
  const double bare = rad_to_deg(angle);
  for (int i = 0; i <= 2 * kMostTurns; ++i) {
    const int turns = i % 2 == 0 ? i / 2 : -(i + 1) / 2;
    const double degrees = bare + turns * kTurn;
    if (reads_back(std::nearbyint(degrees))) return decimal(std::nearbyint(degrees));
    double above = degrees;
    double below = degrees;
    for (int k = 0; k <= kUlps; ++k) {
      if (reads_back(above)) return decimal(above);
      if (reads_back(below)) return decimal(below);
      above = std::nextafter(above, HUGE_VAL);
      below = std::nextafter(below, -HUGE_VAL);
    }
  }
  return decimal(bare);
}

std::string path_line(const world::Path& path) {
  std::string out = "path " + write_millimetres(path.speed) + (path.loop ? " loop" : " back");
  for (const Vec2 point : path.points) out += ' ' + place(point);
  return out + '\n';
}

/// The lines after that of an object, where they differ from `usual`.
std::string matter_lines(const world::Matter& matter, double usual_mass) {
  std::string out;
  if (matter.mass != usual_mass) out += "mass " + decimal(matter.mass) + '\n';
  if (matter.friction) out += "friction " + decimal(*matter.friction) + '\n';
  if (matter.restitution) out += "restitution " + decimal(*matter.restitution) + '\n';
  if (matter.fixed) out += "fixed\n";
  return out;
}

std::string object_lines(const world::ObjectSpec& object) {
  std::string out;
  double mass = world::Matter{}.mass;
  if (object.kind == world::ObjectKind::Box) {
    out = "box " + pose_words(object.pose) + ' ' + place(object.size);
    const bool coloured = object.colour != kBoxColour;
    if (coloured || object.height != kBoxHeight) out += ' ' + write_millimetres(object.height);
    if (coloured) out += ' ' + channels(object.colour);
    mass = kBoxMass;
  } else if (object.kind == world::ObjectKind::Polygon) {
    out = "polygon " + pose_words(object.pose);
    for (const Vec2 corner : object.corners) out += ' ' + place(corner);
    if (object.height != kBoxHeight) out += " height " + write_millimetres(object.height);
    if (object.colour != kBoxColour) out += " colour " + channels(object.colour);
    mass = kBoxMass;
  } else if (const auto builtin = builtin_object(object.name)) {
    out = object.name + ' ' + pose_words(object.pose);
    mass = builtin->matter.mass;
  } else {  // the old form, whose picture names it
    out = "object " + pose_words(object.pose) + " 0 " + word(object.name + ".ms3d");
  }
  out += '\n' + matter_lines(object.matter, mass);
  if (object.path) out += path_line(*object.path);
  return out + motion_lines(object.path, object.reaction, object.yields_within);
}

std::string trait_lines(const ObjectTraits& traits) {
  std::string out;
  if (traits.mass) out += "mass " + decimal(*traits.mass) + '\n';
  if (traits.friction) out += "friction " + decimal(*traits.friction) + '\n';
  if (traits.restitution) out += "restitution " + decimal(*traits.restitution) + '\n';
  if (traits.fixed) out += "fixed\n";
  if (traits.loose) out += "loose\n";
  if (traits.still) out += "still\n";
  if (traits.path) out += path_line(*traits.path);
  out += motion_lines(traits.path, traits.reaction, traits.yields_within.value_or(0.0));
  if (traits.yields_within == 0.0) out += "yields 0\n";  // whatever its file says
  return out;
}

/// `value` as a number that the reader, which divides it, reads back unchanged.
std::string parameter_text(const ErrorParameter& parameter, double value) {
  double written = value * parameter.divisor;
  double above = written;
  double below = written;
  constexpr int kTries = 4;
  for (int i = 0; i < kTries; ++i) {
    for (const double candidate : {above, below}) {
      const bool is_allowed = candidate >= parameter.low && candidate <= parameter.high;
      if (is_allowed && candidate / parameter.divisor == value) return decimal(candidate);
    }
    above = std::nextafter(above, HUGE_VAL);
    below = std::nextafter(below, -HUGE_VAL);
  }
  return decimal(written);
}

std::string error_line(const ErrorRule& rule) {
  std::string out = "error";
  if (rule.robot) out += " robot:" + std::to_string(*rule.robot);
  if (rule.preset) {
    const auto name = std::ranges::find_if(robot::kErrorPresets, [&](std::string_view known) {
      return robot::error_preset(known) == rule.preset;
    });
    if (name == robot::kErrorPresets.end()) refuse_sim("its errors are no preset");
    return out + ' ' + std::string(*name) + '\n';
  }
  if (rule.kind == nullptr) refuse_sim("a rule about errors is empty");
  out += ' ' + std::string(rule.kind->name);
  if (rule.device) out += ':' + std::to_string(*rule.device);
  for (const auto& [parameter, value] : rule.values) {
    out += ' ' + std::string(parameter->name);
    if (parameter->unit != "flag") out += '=' + parameter_text(*parameter, value);
  }
  return out + '\n';
}

class SimWriter {
 public:
  explicit SimWriter(const SimFile& sim) : sim_(sim) {}

  std::string text() {
    if (sim_.world) out_ += "world " + word(*sim_.world) + '\n';
    if (sim_.water) out_ += "water " + write_millimetres(*sim_.water) + '\n';
    for (const auto& [file, where] : sim_.object_files) out_ += "object " + word(file) + '\n';
    for (const world::ObjectSpec& object : sim_.objects) out_ += object_lines(object);
    // Robot files come as late as they may: the old form names one and places a robot of it.
    const bool any_old = std::ranges::any_of(sim_.robots, wants_old_form);
    write_files(any_old ? 0 : sim_.robot_files.size());
    for (const SimRobot& robot : sim_.robots) write_robot(robot);
    write_files(sim_.robot_files.size());
    for (const world::Marker& marker : sim_.markers) {
      out_ += "marker " + place(marker.position) + ' ' + channels(marker.colour) + '\n';
    }
    for (const ErrorRule& rule : sim_.errors) out_ += error_line(rule);
    if (sim_.show_sensors || sim_.show_trail || out_.empty()) {
      out_ += std::string("settings") + (sim_.show_sensors ? " VIS" : "") +
              (sim_.show_trail ? " TRACE" : "") + '\n';
    }
    // A name may begin with a byte order mark, which is one at the begin of a file only.
    constexpr std::string_view kMark = "\xEF\xBB\xBF";
    if (out_.starts_with(kMark)) out_.insert(0, 1, '\n');
    return std::move(out_);
  }

 private:
  /// "NAME x y phi [program]" or "NAME S [phi] [program]".
  static std::vector<std::string> usual_words(const SimRobot& robot) {
    std::vector<std::string> words{word(robot.model)};
    if (robot.start) {
      words.emplace_back(1, *robot.start);
      if (robot.pose) words.push_back(plain_degrees(robot.pose->theta));
    } else {
      words.push_back(pose_words(*robot.pose));
    }
    if (!robot.program.empty() || !robot.arguments.empty()) words.push_back(word(robot.program));
    for (const std::string& argument : robot.arguments) words.push_back(word(argument));
    return words;
  }

  /// A robot without a place, or whose model is called like a keyword or an object.
  static bool wants_old_form(const SimRobot& robot) {
    if (!robot.start && !robot.pose) return true;
    if (robot.start) return false;
    std::vector<Warning> warnings;
    try {
      const SimFile read = read_sim('\n' + word(robot.model) + " 0 0 0 p", "name", warnings);
      return read.robots.size() != 1 || read.robots.front().model != robot.model;
    } catch (const ConfigError&) {
      // A file may describe a "box" or "polygon", which take no program.
      const std::string name = lower(robot.model);
      const bool may_be = name == "box" || name == "polygon";
      return !may_be || !robot.program.empty() || !robot.arguments.empty();
    }
  }

  void write_files(std::size_t end) {
    for (; next_file_ < end; ++next_file_) {
      out_ += "robot " + word(sim_.robot_files[next_file_].first) + '\n';
    }
  }

  void write_robot(const SimRobot& robot) {
    if (wants_old_form(robot)) {
      std::size_t file = next_file_;
      while (file < sim_.robot_files.size() && sim_.robot_files[file].first != robot.model) ++file;
      if (file == sim_.robot_files.size()) {
        refuse_sim("robot " + in_quotes(robot.model) +
                   " has no place of its own: expected x y phi, or its file among the robot files");
      }
      write_files(file);
      ++next_file_;
      out_ += "robi " + word(robot.model) + ' ' + word(robot.program);
      if (robot.pose) out_ += ' ' + pose_words(*robot.pose);
    } else {
      std::string line;
      for (const std::string& w : usual_words(robot)) line += (line.empty() ? "" : " ") + w;
      out_ += line;
    }
    out_ += '\n' + trait_lines(robot.traits);
    if (robot.enters) out_ += "enters " + decimal(*robot.enters) + '\n';
  }

  const SimFile& sim_;
  std::string out_;
  std::size_t next_file_ = 0;
};

bool same_traits(const ObjectTraits& a, const ObjectTraits& b) {
  return a.mass == b.mass && a.friction == b.friction && a.restitution == b.restitution &&
         a.fixed == b.fixed && a.loose == b.loose && a.still == b.still && a.path == b.path &&
         a.reaction == b.reaction && a.yields_within == b.yields_within;
}

bool same_rule(const ErrorRule& a, const ErrorRule& b) {
  return a.robot == b.robot && a.preset == b.preset && a.kind == b.kind && a.device == b.device &&
         a.values == b.values;
}

}  // namespace

bool same_meaning(const SimRobot& a, const SimRobot& b) {
  return a.model == b.model && a.start == b.start && a.pose == b.pose && a.program == b.program &&
         a.arguments == b.arguments && same_traits(a.traits, b.traits) && a.enters == b.enters;
}

bool same_meaning(const SimFile& a, const SimFile& b) {
  const auto same_file = [](const auto& one, const auto& other) {
    return one.first == other.first;
  };
  const auto same_line = [](const SimRobot& one, const SimRobot& other) {
    return same_meaning(one, other);
  };
  return a.world == b.world && a.water == b.water &&
         std::ranges::equal(a.robot_files, b.robot_files, same_file) &&
         std::ranges::equal(a.object_files, b.object_files, same_file) &&
         std::ranges::equal(a.robots, b.robots, same_line) && a.objects == b.objects &&
         a.markers == b.markers && std::ranges::equal(a.errors, b.errors, same_rule) &&
         a.show_sensors == b.show_sensors && a.show_trail == b.show_trail;
}

std::string write_sim(const SimFile& sim) {
  std::string out = SimWriter(sim).text();
  std::vector<Warning> warnings;
  if (!same_meaning(read_sim(out, "simulation to write", warnings), sim)) {
    refuse_sim("a .sim file cannot say all of it (sizes of objects or numbers out of range)");
  }
  return out;
}

}  // namespace eyebridge::files
