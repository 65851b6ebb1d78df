#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "drive_lines.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/files/readers.hpp"
#include "eyebridge/robot/lidar_presets.hpp"
#include "robot_builder.hpp"
#include "text.hpp"

namespace eyebridge::files {
namespace {

constexpr int kMostRangeMatrices = 8;
constexpr double kMaxSize = 10000;  // millimetres: no robot or mounting is larger
constexpr std::array<std::string_view, 29> kRobiKeywords = {
    "name",     "diameter",  "speed",     "turn",  "model",    "axis",    "axel",     "psd",
    "camera",   "wheel",     "drive",     "mass",  "collider", "fisheye", "lidar",    "ir",
    "bump",     "psd_range", "psd_table", "accel", "error",    "kicker",  "psd_kind", "axles",
    "steering", "friction",  "servo",     "dive",  "tof"};

class RobiReader {
 public:
  RobiReader(std::string_view text, const std::string& file, std::vector<Warning>& warnings,
             Reading reading)
      : statements_(text, file),
        file_(file),
        warnings_(file, warnings),
        reading_(reading),
        builder_(warnings_),
        drive_(warnings_) {}

  robot::RobotModel read() {
    read_lines(statements_, warnings_, reading_, [&](const Statement& s) { read_statement(s); });
    if (!known_) {
      throw ConfigError({file_, std::max(1, statements_.line()), 1},
                        "no keyword of a robot description in the file: expected 'drive', 'name', "
                        "'psd', ...");
    }
    if (comments_ > 0) {
      warnings_.add(first_comment_.line, first_comment_.column,
                    std::to_string(comments_) +
                        " lines that begin with no keyword are left out, this is the first: '#' "
                        "begins a comment");
    }
    drive_.finish(model());
    finish_body();
    if (fisheye_) {
      if (!model().camera) {
        throw ConfigError(fisheye_where_, "fisheye without camera: expected a 'camera' line");
      }
      model().camera->horizontal_field_of_view = *fisheye_;
    }
    return builder_.finish();
  }

 private:
  robot::RobotModel& model() { return builder_.model(); }

  void read_statement(const Statement& s) {
    const std::string keyword = lower(s.text(0));
    if (std::find(kRobiKeywords.begin(), kRobiKeywords.end(), keyword) == kRobiKeywords.end()) {
      unknown(s, keyword);
      return;
    }
    // The manual of the new dialect demands `drive` first; no old file has it there.
    if (!known_) new_dialect_ = keyword == "drive";
    known_ = true;
    if (builder_.read_extension(s)) return;
    if (drive_.read(s, new_dialect_)) return;
    if (keyword == "name") {
      if (s.size() < 2) s.fail(1, "line ends: expected the robot's name");
      model().name = s.rest(1);
    } else if (keyword == "diameter") {
      s.expect_arguments(1, "diameter MM");
      diameter_ = s.millimetres(1, "the diameter", 1, kMaxSize);
    } else if (keyword == "psd") {
      read_psd(s);
    } else if (keyword == "ir") {
      s.expect_arguments({6, 7}, "ir NAME id x y z angle [threshold]");
      static_cast<void>(offset(s, 5, "z"));
      builder_.add_ir(s, {offset(s, 3, "x"), offset(s, 4, "y"), s.degrees(6, "the angle")},
                      s.size() == 8 ? std::optional<std::size_t>(7) : std::nullopt);
    } else if (keyword == "bump") {
      builder_.add_bump(s);
    } else if (keyword == "camera") {
      read_camera(s);
    } else if (keyword == "fisheye") {
      s.expect_arguments(1, "fisheye DEG");
      fisheye_where_ = s.where(0);
      fisheye_ = deg_to_rad(s.number(1, "the angle of view", 60, 150));
    } else if (keyword == "lidar") {
      read_lidar(s);
    } else if (keyword == "tof") {
      read_range_matrix(s);
    } else if (keyword == "collider") {
      read_collider(s);
    } else if (keyword == "mass") {
      s.expect_arguments({1, 4}, "mass kg x y z");
      static_cast<void>(s.number(1, "the mass", 0, 1e6));
    } else if (keyword == "axis") {
      s.expect_arguments({1, 2}, "axis vertical horizontal");
      for (std::size_t i = 1; i < s.size(); ++i) static_cast<void>(offset(s, i, "the offset"));
    }  // model: the picture is not used
  }

  void unknown(const Statement& s, const std::string& keyword) {
    if (const std::string_view near = nearest(keyword, kRobiKeywords); !near.empty()) {
      s.fail(0, "unknown keyword " + in_quotes(s.text(0)) + ": expected " + in_quotes(near) + "?");
    }
    if (!new_dialect_) {  // the old dialect calls such lines comments
      if (comments_++ == 0) first_comment_ = s.where(0);
      return;
    }
    warnings_.add(s.line(), s.token(0).column,
                  "unknown keyword " + in_quotes(s.text(0)) + " is ignored");
  }

  static double offset(const Statement& s, std::size_t i, std::string_view what) {
    return s.millimetres(i, what, -kMaxSize, kMaxSize);
  }

  void read_psd(const Statement& s) {
    s.expect_arguments({5, 6, 8}, "psd NAME [id] x y z angle' or 'psd id NAME x y z rx ry rz");
    if (s.size() == 6) {
      builder_.add_psd(s, 1, std::nullopt,
                       {offset(s, 2, "x"), offset(s, 3, "y"), s.degrees(5, "the angle")},
                       offset(s, 4, "z"));
      return;
    }
    const bool id_first = s.is_number(1);
    const std::size_t name = id_first ? 2 : 1;
    const std::size_t id = id_first ? 1 : 2;
    if (s.size() == 7) {
      builder_.add_psd(s, name, id,
                       {offset(s, 3, "x"), offset(s, 4, "y"), s.degrees(6, "the angle")},
                       offset(s, 5, "z"));
      return;
    }
    // The form with three rotations uses the axes of the 3D model: x right, y up, z forward, and
    // its middle rotation, about y, is the bearing (0, 90, -90, 180: front, left, right, back).
    static_cast<void>(s.degrees(6, "rx"));
    static_cast<void>(s.degrees(8, "rz"));
    builder_.add_psd(s, name, id, {offset(s, 5, "z"), -offset(s, 3, "x"), s.degrees(7, "ry")},
                     offset(s, 4, "y"));
  }

  /// Middle and throw of "SERVO1(-90,+90)", degrees; nothing when token `i` is not of that form.
  static std::optional<std::array<double, 2>> servo_range(const Statement& s, std::size_t i) {
    const std::string word = lower(s.text(i));
    const std::size_t open = word.find('(');
    const std::size_t comma = word.find(',');
    if (!word.starts_with("servo") || open == std::string::npos || comma == std::string::npos ||
        comma < open || !word.ends_with(')')) {
      return std::nullopt;
    }
    const auto limit = [&](std::size_t from, std::size_t to) -> std::optional<double> {
      if (from < to && word[from] == '+') ++from;
      int value = 0;
      const auto [stop, error] = std::from_chars(word.data() + from, word.data() + to, value);
      if (error != std::errc{} || stop != word.data() + to || std::abs(value) > 180) return {};
      return value;
    };
    const auto low = limit(open + 1, comma);
    const auto high = limit(comma + 1, word.size() - 1);
    if (!low || !high || *low >= *high) {
      s.fail(i, in_quotes(s.text(i)) + " found: expected SERVOn(lowest,highest) in degrees");
    }
    return std::array<double, 2>{(*low + *high) / 2, (*high - *low) / 2};
  }

  void read_camera(const Statement& s) {
    s.expect_arguments({5, 7}, "camera x y z pan tilt max_pan max_tilt");
    robot::CameraModel camera;
    camera.x = offset(s, 1, "x");
    camera.y = offset(s, 2, "y");
    camera.z = offset(s, 3, "z");
    const auto aim = [&](std::size_t i, std::string_view what, double& middle, double& most) {
      if (const auto range = servo_range(s, i)) {
        middle = deg_to_rad((*range)[0]);
        most = deg_to_rad((*range)[1]);
        return;
      }
      middle = s.degrees(i, what);
    };
    aim(4, "the pan angle", camera.pan, camera.max_pan);
    aim(5, "the tilt angle", camera.tilt, camera.max_tilt);
    if (s.size() == 8) {
      const double first = s.number(6, "max_pan", 0, 10000);
      const double second = s.number(7, "max_tilt", 0, 10000);
      // Old files end with the size of the picture; the program chooses that nowadays.
      if (new_dialect_ && first <= 180 && second <= 180) {
        camera.max_pan = deg_to_rad(first);
        camera.max_tilt = deg_to_rad(second);
      } else if (new_dialect_) {
        warnings_.add(s.line(), s.token(6).column,
                      "max_pan and max_tilt above 180 degrees are taken for a picture's size and "
                      "ignored; the throw is 90 degrees");
      }
    }
    model().camera = camera;
  }

  void read_lidar(const Statement& s) {
    if (s.size() > 1 && !s.is_number(1)) {
      read_named_lidar(s);
      return;
    }
    s.expect_arguments({2, 3}, "lidar points tilt [range]");
    robot::LidarModel lidar;
    lidar.points = s.integer(1, "the number of points", 1, 36000);
    lidar.tilt = deg_to_rad(s.number(2, "the tilt", -90, 90));
    if (s.size() == 4) lidar.max_range = s.millimetres(3, "the range", 1, 1e6);
    model().lidar = lidar;
  }

  /// "lidar LMS200 [tilt]"
  void read_named_lidar(const Statement& s) {
    for (const std::string_view name : robot::kLidarPresets) {
      if (lower(name) != lower(s.text(1))) continue;
      s.expect_arguments({1, 2}, "lidar " + std::string(name) + " [tilt]");
      model().lidar = robot::lidar_preset(name);
      if (s.size() == 3) model().lidar->tilt = deg_to_rad(s.number(2, "the tilt", -90, 90));
      return;
    }
    s.fail(1, in_quotes(s.text(1)) + " found: expected the number of points, or " +
                  one_of(robot::kLidarPresets));
  }

  /// "tof id NAME x y z angle [tilt [range]]"
  void read_range_matrix(const Statement& s) {
    s.expect_arguments({6, 7, 8}, "tof id NAME x y z angle [tilt [range]]");
    robot::RangeMatrixModel matrix;
    matrix.id = s.integer(1, "the number of the matrix", 1, kMostRangeMatrices);
    matrix.name = std::string(s.text(2));
    matrix.pose_in_robot = {offset(s, 3, "x"), offset(s, 4, "y"), s.degrees(6, "the angle")};
    matrix.height = s.millimetres(5, "z", 0, kMaxSize);
    if (s.size() > 7) matrix.tilt = deg_to_rad(s.number(7, "the tilt", -60, 60));
    if (s.size() > 8) matrix.max_range = s.millimetres(8, "the range", 1, 9998);
    for (const robot::RangeMatrixModel& other : model().range_matrices) {
      if (other.id == matrix.id) s.fail(1, "a second tof of this number: expected one");
    }
    model().range_matrices.push_back(matrix);
  }

  void read_collider(const Statement& s) {
    static constexpr std::array<std::string_view, 3> kShapes = {"box", "sphere", "capsule"};
    const std::string shape = s.size() > 1 ? lower(s.text(1)) : "";
    double reach = 0;
    const auto centre = [&](std::size_t x, std::size_t z) {
      return Vec2{std::abs(offset(s, x, "x of the centre")),
                  std::abs(offset(s, z, "z of the centre"))};
    };
    const auto size = [&](std::size_t i) { return s.millimetres(i, "the size", 0, kMaxSize); };
    if (shape == "box") {
      s.expect_arguments(7, "collider box sx sy sz cx cy cz");
      const Vec2 half{size(2) / 2, size(4) / 2};
      height_ = std::max(height_, size(3) / 2 + offset(s, 6, "y of the centre"));
      reach = norm(centre(5, 7) + half);
    } else if (shape == "sphere") {
      s.expect_arguments(5, "collider sphere r cx cy cz");
      height_ = std::max(height_, size(2) + offset(s, 4, "y of the centre"));
      reach = size(2) + norm(centre(3, 5));
    } else if (shape == "capsule") {
      s.expect_arguments(6, "collider capsule r h cx cy cz");
      height_ = std::max(height_, size(3) / 2 + offset(s, 5, "y of the centre"));
      reach = size(2) + norm(centre(4, 6));
    } else {
      s.fail(1, (s.size() > 1 ? in_quotes(shape) + " found" : std::string("line ends")) +
                    ": expected " + one_of(kShapes));
    }
    reach_ = std::max(reach_, reach);
  }

  /// Without a diameter the body is the disc about the robot's centre that covers every collider
  /// (S4: 189 mm, its old file says 186); without colliders twice the wheel base.
  void finish_body() {
    if (height_ > 0) model().height = height_;
    if (diameter_) {
      model().diameter = *diameter_;
    } else if (reach_ > 0) {
      model().diameter = 2 * reach_;
    } else if (drive_.has_wheels() && !model().drive.facts().dives) {
      model().diameter = 2 * model().drive.wheel_base;
    } else {
      warnings_.add(1, 1, "neither diameter, collider nor wheel is given: the diameter is 186 mm");
    }
  }

  StatementReader statements_;
  const std::string& file_;
  Warnings warnings_;
  Reading reading_;
  RobotBuilder builder_;
  DriveLines drive_;
  bool known_ = false;
  bool new_dialect_ = false;
  int comments_ = 0;  ///< Lines of the old dialect that begin with no keyword.
  SourceLocation first_comment_;
  std::optional<double> diameter_;
  std::optional<double> fisheye_;
  SourceLocation fisheye_where_;
  double reach_ = 0;
  double height_ = 0;
};

}  // namespace

robot::RobotModel read_robi(std::string_view text, const std::string& file,
                            std::vector<Warning>& warnings, Reading reading) {
  return RobiReader(text, file, warnings, reading).read();
}

}  // namespace eyebridge::files
