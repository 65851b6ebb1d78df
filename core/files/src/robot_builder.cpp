#include "robot_builder.hpp"

#include <set>

#include "eyebridge/base/units.hpp"

namespace eyebridge::files {
namespace {

constexpr std::size_t kMaxSensors = 1000;

/// The number that programs use for a PSD of this name; 0 when the name is no standard one.
int standard_psd(std::string_view name) {
  if (name == "PSD_FRONT") return 1;
  if (name == "PSD_LEFT") return 2;
  if (name == "PSD_RIGHT") return 3;
  if (name == "PSD_BACK") return 4;
  return 0;
}

void check_count(const Statement& s, std::size_t count) {
  if (count >= kMaxSensors) s.fail(0, "more than 1000 " + std::string(s.text(0)) + " lines");
}

}  // namespace

RobotBuilder::Id RobotBuilder::read_id(const Statement& s, std::size_t token) const {
  Id id;
  id.written = s.integer(token, "the id", -100000, 100000);
  if (id.written == 0) s.fail(token, "id 0 found: expected 1 or more");
  id.line = s.line();
  id.column = s.token(token).column;
  id.where = s.where(token);
  return id;
}

void RobotBuilder::add_psd(const Statement& s, std::size_t name_token,
                           std::optional<std::size_t> id_token, const Pose& pose, double height) {
  check_count(s, psd_ids_.size());
  robot::RangeSensorModel psd;
  psd.name = std::string(s.text(name_token));
  psd.pose_in_robot = pose;
  psd.height = height;
  // All that may throw comes first: a line is read whole or not at all.
  const Id id = id_token ? read_id(s, *id_token) : Id{0, s.line(), 1, s.where(0)};
  model_.range_sensors.push_back(psd);
  psd_ids_.push_back(id);
}

void RobotBuilder::add_ir(const Statement& s, const Pose& pose,
                          std::optional<std::size_t> threshold_token) {
  check_count(s, ir_ids_.size());
  robot::ProximityModel ir;
  ir.name = std::string(s.text(1));
  ir.pose_in_robot = pose;
  if (threshold_token) ir.threshold = s.millimetres(*threshold_token, "the threshold", 0, 1e5);
  const Id id = read_id(s, 2);
  model_.proximity_sensors.push_back(ir);
  ir_ids_.push_back(id);
}

void RobotBuilder::add_bump(const Statement& s) {
  s.expect_arguments(4, "bump NAME id start end");
  check_count(s, bump_ids_.size());
  robot::BumperModel bumper;
  bumper.name = std::string(s.text(1));
  bumper.start = s.degrees(3, "the start of the sector");
  bumper.end = s.degrees(4, "the end of the sector");
  const Id id = read_id(s, 2);
  model_.bumpers.push_back(bumper);
  bump_ids_.push_back(id);
}

bool RobotBuilder::read_extension(const Statement& s) {
  const std::string keyword = lower(s.text(0));
  if (keyword == "psd_range") {
    s.expect_arguments(2, "psd_range min_mm max_mm");
    psd_range_ = read_range_limits(s, 1);
  } else if (keyword == "psd_kind") {
    check_count(s, psd_kinds_.size());
    psd_kinds_.push_back(read_psd_kind(s));
  } else if (keyword == "accel") {
    s.expect_arguments(2, "accel linear_mm_s2 angular_deg_s2");
    model_.drive.linear_acceleration = s.millimetres(1, "the acceleration", 1, 1e6);
    model_.drive.angular_acceleration = deg_to_rad(s.number(2, "the angular acceleration", 1, 1e6));
  } else if (keyword == "psd_table") {
    read_table(s);
  } else if (keyword == "kicker") {
    read_kicker(s);
  } else if (keyword == "servo") {
    read_servo(s);
  } else if (keyword == "friction") {
    s.expect_arguments(1, "friction MU");
    model_.contact_friction = s.number(1, "the coefficient of friction", 0, 100);
  } else if (keyword == "error") {
    read_error(s);
  } else {
    return false;
  }
  return true;
}

void RobotBuilder::read_kicker(const Statement& s) {
  s.expect_arguments({3, 4}, "kicker servo mm_per_second reach_mm [half_angle]");
  if (model_.kicker) s.fail(0, "a second kicker: expected one");
  robot::KickerModel kicker;
  kicker.servo =
      static_cast<unsigned>(s.integer(1, "the servo (1 and 2 are the camera's)", 3, 16) - 1);
  kicker.speed = s.millimetres(2, "the ball's speed", 1, 20000);
  kicker.reach = s.millimetres(3, "the reach", 0, 1000);
  if (s.size() == 5) kicker.half_angle = deg_to_rad(s.number(4, "the half angle", 1, 90));
  model_.kicker = kicker;
}

void RobotBuilder::read_servo(const Statement& s) {
  using Wheel = robot::ServoModel::Wheel;
  s.expect_arguments({2, 3}, "servo number NAME [left|right]");
  robot::ServoModel servo;
  servo.servo =
      static_cast<unsigned>(s.integer(1, "the servo (1 and 2 are the camera's)", 3, 16) - 1);
  servo.name = std::string(s.text(2));
  if (s.size() == 4) {
    const std::string wheel = lower(s.text(3));
    if (wheel != "left" && wheel != "right") {
      s.fail(3, in_quotes(s.text(3)) + " found: expected the wheel that it turns, left or right");
    }
    servo.wheel = wheel == "left" ? Wheel::Left : Wheel::Right;
  }
  for (const robot::ServoModel& other : model_.servos) {
    if (other.servo == servo.servo) s.fail(1, "a second servo of this number: expected one");
    if (servo.wheel != Wheel::None && other.wheel == servo.wheel) {
      s.fail(3, "a second servo for this wheel: expected one");
    }
  }
  model_.servos.push_back(servo);
  servo_where_.push_back(s.where(1));
}

/// Other lines may contradict a servo and stand below it, so that this is checked at the end.
void RobotBuilder::check_servos() const {
  for (std::size_t i = 0; i < model_.servos.size(); ++i) {
    const robot::ServoModel& servo = model_.servos[i];
    const std::string number = "servo " + std::to_string(servo.servo + 1);
    if (model_.kicker && model_.kicker->servo == servo.servo) {
      throw ConfigError(servo_where_[i], number + " kicks already: expected another one");
    }
    if (model_.drive.steers(servo.servo)) {
      throw ConfigError(servo_where_[i], number + " steers already: expected another one");
    }
    if (servo.wheel != robot::ServoModel::Wheel::None && !model_.drive.facts().has_two_wheels) {
      throw ConfigError(servo_where_[i],
                        number + " turns a wheel: expected a DIFFERENTIAL_DRIVE for that");
    }
  }
}

void RobotBuilder::read_error(const Statement& s) {
  std::vector<ErrorWord> words;
  for (std::size_t i = 1; i < s.size(); ++i) words.push_back({s.text(i), s.where(i)});
  if (words.empty()) s.fail(1, "line ends: expected a preset or an error model");
  errors_.push_back(read_error_rule(words, s.where(s.size())));
  if (errors_.back().robot)
    s.fail(1, in_quotes(s.text(1)) + " found: this file is about one robot");
}

void RobotBuilder::read_table(const Statement& s) {
  if (s.size() < 3) s.fail(s.size(), "line ends: expected 'psd_table MM MM ...', by raw value");
  std::vector<double> metres;
  for (std::size_t i = 1; i < s.size(); ++i) {
    metres.push_back(s.millimetres(i, "a range of the table", 0, 9999));
  }
  psd_table_ = robot::RangeTable(metres);
  if (psd_table_.empty()) s.fail(1, "no range below 9999 in the table: expected one");
}

template <class Sensor>
void RobotBuilder::number_sensors(std::vector<Sensor>& sensors, const std::vector<Id>& ids,
                                  std::string_view kind) {
  std::set<int> written;
  for (const Id& id : ids) {
    if (id.written != 0 && !written.insert(id.written).second) {
      throw ConfigError(id.where, std::string(kind) + " id " + std::to_string(id.written) +
                                      " is given twice: expected every id once");
    }
  }
  // Negative ids are those of a real board's hardware table; programs in simulation count from 1.
  // The four standard names get their numbers first, so that PSDGet(PSD_FRONT) finds its sensor.
  std::string renumbered;
  std::set<int> used;
  for (const int id : written) {
    if (id > 0) used.insert(id);
  }
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    sensors[i].id = ids[i].written;
    if (ids[i].written < 0) sensors[i].semantics = ids[i].written;
    if (ids[i].written > 0 || kind != "psd") continue;
    const int standard = standard_psd(sensors[i].name);
    if (standard != 0 && used.insert(standard).second) sensors[i].id = standard;
  }
  // Where a standard name exists, other PSDs start after the four standard numbers.
  int next = 1;
  if (kind == "psd") {
    for (const Sensor& sensor : sensors) {
      if (standard_psd(sensor.name) != 0) next = 5;
    }
  }
  const Id* first = nullptr;
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    if (ids[i].written > 0) continue;
    if (sensors[i].id <= 0) {
      while (used.contains(next)) ++next;
      sensors[i].id = next;
      used.insert(next);
    }
    if (first == nullptr) first = &ids[i];
    if (renumbered.size() < 400) {
      renumbered += (renumbered.empty() ? "" : ", ") + sensors[i].name.substr(0, 40) + " = " +
                    std::to_string(sensors[i].id);
    }
  }
  if (first != nullptr) {
    warnings_.add(first->line, first->column,
                  std::string(kind) + " ids are negative or missing; they become " + renumbered);
  }
}

robot::RobotModel RobotBuilder::finish() {
  check_servos();
  number_sensors(model_.range_sensors, psd_ids_, "psd");
  number_sensors(model_.proximity_sensors, ir_ids_, "ir");
  number_sensors(model_.bumpers, bump_ids_, "bump");
  for (robot::RangeSensorModel& psd : model_.range_sensors) {
    psd.table = psd_table_;
    if (psd_range_) {
      psd.min_range = psd_range_->first;
      psd.max_range = psd_range_->second;
    }
  }
  for (const PsdKind& kind : psd_kinds_) apply_psd_kind(kind, model_);
  for (const ErrorRule& rule : errors_) {
    if (!apply_rule(rule, model_) && rule.device) throw no_such_device(rule, model_);
  }
  return std::move(model_);
}

}  // namespace eyebridge::files
