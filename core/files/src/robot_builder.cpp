#include "robot_builder.hpp"

#include <array>
#include <set>

#include "eyebridge/base/units.hpp"

namespace eyebridge::files {
namespace {

constexpr std::size_t kMaxSensors = 1000;
constexpr std::array<std::string_view, 10> kErrors = {
    "psd", "drive", "wheels", "encoder", "compass", "camera", "ir", "bump", "lidar", "radio"};

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
  model_.range_sensors.push_back(psd);
  psd_ids_.push_back(id_token ? read_id(s, *id_token) : Id{0, s.line(), 1, s.where(0)});
}

void RobotBuilder::add_ir(const Statement& s, const Pose& pose,
                          std::optional<std::size_t> threshold_token) {
  check_count(s, ir_ids_.size());
  robot::ProximityModel ir;
  ir.name = std::string(s.text(1));
  ir.pose_in_robot = pose;
  if (threshold_token) ir.threshold = s.millimetres(*threshold_token, "the threshold", 0, 1e5);
  model_.proximity_sensors.push_back(ir);
  ir_ids_.push_back(read_id(s, 2));
}

void RobotBuilder::add_bump(const Statement& s) {
  s.expect_arguments(4, "bump NAME id start end");
  check_count(s, bump_ids_.size());
  robot::BumperModel bumper;
  bumper.name = std::string(s.text(1));
  bumper.start = s.degrees(3, "the start of the sector");
  bumper.end = s.degrees(4, "the end of the sector");
  model_.bumpers.push_back(bumper);
  bump_ids_.push_back(read_id(s, 2));
}

bool RobotBuilder::read_extension(const Statement& s) {
  const std::string keyword = lower(s.text(0));
  if (keyword == "psd_range") {
    s.expect_arguments(2, "psd_range min_mm max_mm");
    const double low = s.millimetres(1, "the shortest range", 0, 1e5);
    const double high = s.millimetres(2, "the longest range", 0, 1e5);
    if (high <= low) s.fail(2, "the longest range is not above the shortest");
    psd_range_ = {low, high};
  } else if (keyword == "accel") {
    s.expect_arguments(2, "accel linear_mm_s2 angular_deg_s2");
    model_.drive.linear_acceleration = s.millimetres(1, "the acceleration", 1, 1e6);
    model_.drive.angular_acceleration = deg_to_rad(s.number(2, "the angular acceleration", 1, 1e6));
  } else if (keyword == "kicker") {
    read_kicker(s);
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

void RobotBuilder::read_error(const Statement& s) {
  if (s.size() < 2) s.fail(1, "line ends: expected 'error' and one of " + one_of(kErrors));
  const std::string kind = lower(s.text(1));
  const auto expect = [&](std::size_t count, std::string_view form) {
    s.expect_arguments(count + 1, std::string("error ").append(form));
  };
  const auto fraction = [&](std::size_t i, std::string_view what) {
    return s.number(i, what, 0, 100) / 100;
  };
  const auto scale = [&](std::size_t i, std::string_view what) {
    return s.number(i, what, -50, 50) / 100;
  };
  if (kind == "psd" || kind == "lidar") {
    expect(2, kind + " sigma_mm percent");
    robot::GaussianError& error = kind == "psd" ? psd_error_ : lidar_error_;
    error.sigma = s.millimetres(2, "sigma", 0, 1e5);
    error.sigma_relative = fraction(3, "the percentage");
  } else if (kind == "drive") {
    expect(2, "drive linear_percent angular_percent");
    model_.drive_error.linear_sigma = fraction(2, "the linear percentage");
    model_.drive_error.angular_sigma = fraction(3, "the angular percentage");
  } else if (kind == "wheels") {
    expect(2, "wheels left_percent right_percent");
    model_.drive_error.left_scale = scale(2, "the left percentage");
    model_.drive_error.right_scale = scale(3, "the right percentage");
  } else if (kind == "encoder") {
    expect(1, "encoder quantised");
    if (lower(s.text(2)) != "quantised") {
      s.fail(2, in_quotes(s.text(2)) + " found: expected 'quantised'");
    }
    model_.drive_error.encoder_quantised = true;
  } else if (kind == "compass") {
    expect(1, "compass sigma_deg");
    model_.compass_error.sigma = deg_to_rad(s.number(2, "sigma", 0, 180));
  } else if (kind == "camera") {
    expect(2, "camera salt_and_pepper_percent sigma");
    camera_salt_ = fraction(2, "the percentage");
    camera_sigma_ = s.number(3, "sigma", 0, 255);
  } else if (kind == "radio") {
    expect(2, "radio loss_percent delay_ms");
    model_.radio_error.loss = fraction(2, "the percentage");
    model_.radio_error.delay = s.number(3, "the delay", 0, 3'600'000) / 1000;
  } else if (kind == "ir") {
    expect(1, "ir flip_percent");
    ir_flip_ = fraction(2, "the percentage");
  } else if (kind == "bump") {
    expect(1, "bump miss_percent");
    bump_miss_ = fraction(2, "the percentage");
  } else {
    const std::string_view near = nearest(kind, kErrors);
    s.fail(1, "unknown error model " + in_quotes(s.text(1)) + ": expected " +
                  (near.empty() ? one_of(kErrors) : in_quotes(near) + "?"));
  }
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
  number_sensors(model_.range_sensors, psd_ids_, "psd");
  number_sensors(model_.proximity_sensors, ir_ids_, "ir");
  number_sensors(model_.bumpers, bump_ids_, "bump");
  for (robot::RangeSensorModel& psd : model_.range_sensors) {
    psd.error = psd_error_;
    if (psd_range_) {
      psd.min_range = psd_range_->first;
      psd.max_range = psd_range_->second;
    }
  }
  for (robot::ProximityModel& ir : model_.proximity_sensors) ir.flip_probability = ir_flip_;
  for (robot::BumperModel& bumper : model_.bumpers) bumper.miss_probability = bump_miss_;
  if (model_.lidar) model_.lidar->error = lidar_error_;
  if (model_.camera) {
    model_.camera->salt_and_pepper = camera_salt_;
    model_.camera->sigma = camera_sigma_;
  }
  return std::move(model_);
}

}  // namespace eyebridge::files
