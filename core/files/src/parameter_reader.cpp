#include <algorithm>
#include <array>

#include "eyebridge/base/units.hpp"
#include "eyebridge/files/readers.hpp"
#include "robot_builder.hpp"
#include "text.hpp"

namespace eyebridge::files {
namespace {

constexpr std::array<std::string_view, 19> kParameterKeywords = {
    "name",  "diameter", "speed",    "turn",     "world",     "maze",      "pause",
    "debug", "psd",      "ir",       "bump",     "psd_range", "psd_table", "accel",
    "error", "kicker",   "psd_kind", "friction", "servo"};

bool on_or_off(const Statement& s) {
  s.expect_arguments(1, std::string(s.text(0)) + " on|off");
  const std::string value = lower(s.text(1));
  if (value != "on" && value != "off") {
    s.fail(1, in_quotes(s.text(1)) + " found: expected 'on' or 'off'");
  }
  return value == "on";
}

/// "NAME ID angle dist orient": the place in polar form; the sensor looks along angle + orient.
Pose polar(const Statement& s) {
  const double angle = s.degrees(3, "the angle of its place");
  const double distance = s.millimetres(4, "its distance from the centre", 0, 1e4);
  const double orient = s.degrees(5, "its direction");
  const Vec2 place = distance * Heading::from_angle(angle).forward();
  return {place.x, place.y, wrap_angle(angle + orient)};
}

void read_statement(const Statement& s, ParameterFile& out, RobotBuilder& builder) {
  const std::string keyword = lower(s.text(0));
  robot::RobotModel& robot = builder.model();
  if (builder.read_extension(s)) return;
  if (keyword == "name") {
    if (s.size() < 2) s.fail(1, "line ends: expected the robot's name");
    robot.name = s.rest(1);
  } else if (keyword == "diameter") {
    s.expect_arguments(1, "diameter MM");
    robot.diameter = s.millimetres(1, "the diameter", 1, 1e4);
  } else if (keyword == "speed") {
    s.expect_arguments(1, "speed CM_PER_SECOND");
    robot.drive.max_linear = cm_to_m(s.number(1, "the speed", 0.1, 1e5));
  } else if (keyword == "turn") {
    s.expect_arguments(1, "turn DEG_PER_SECOND");
    robot.drive.max_angular = deg_to_rad(s.number(1, "the turning speed", 1, 1e6));
  } else if (keyword == "world" || keyword == "maze") {
    s.expect_arguments(1, keyword + " FILE");
    if (out.world || out.maze) s.fail(0, "a second world or maze: expected one");
    (keyword == "world" ? out.world : out.maze) = std::string(s.text(1));
    out.world_where = s.where(1);
  } else if (keyword == "pause") {
    out.pause = on_or_off(s);
  } else if (keyword == "debug") {
    out.debug = on_or_off(s);
  } else if (keyword == "psd") {
    s.expect_arguments(5, "psd NAME id angle distance direction");
    builder.add_psd(s, 1, 2, polar(s), robot::RangeSensorModel{}.height);
  } else if (keyword == "ir") {
    s.expect_arguments({5, 6}, "ir NAME id angle distance direction [threshold]");
    builder.add_ir(s, polar(s), s.size() == 7 ? std::optional<std::size_t>(6) : std::nullopt);
  } else if (keyword == "bump") {
    builder.add_bump(s);
  } else {
    const std::string_view near = nearest(keyword, kParameterKeywords);
    s.fail(0, "unknown keyword " + in_quotes(s.text(0)) + ": expected " +
                  (near.empty() ? one_of(kParameterKeywords) : in_quotes(near) + "?"));
  }
}

}  // namespace

ParameterFile read_parameter_file(std::string_view text, const std::string& file,
                                  std::vector<Warning>& out_warnings) {
  StatementReader statements(text, file);
  Warnings warnings(file, out_warnings);
  RobotBuilder builder(warnings);
  ParameterFile out;
  Statement s;
  bool empty = true;
  while (statements.next(s)) {
    empty = false;
    read_statement(s, out, builder);
  }
  if (empty) {
    throw ConfigError(
        {file, std::max(1, statements.line()), 1},
        "no keyword of a parameter file in it: expected " + one_of(kParameterKeywords));
  }
  out.robot = builder.finish();
  return out;
}

}  // namespace eyebridge::files
