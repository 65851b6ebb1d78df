#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <unistd.h>

#include "config/run_plan.hpp"
#include "config/toml_text.hpp"
#include "config/values.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/camera/calibration.hpp"
#include "eyebridge/camera/picture.hpp"
#include "eyebridge/camera/recording/frame_table.hpp"
#include "eyebridge/files/error_rules.hpp"
#include "eyebridge/files/hdt.hpp"
#include "eyebridge/files/load.hpp"
#include "eyebridge/files/readers.hpp"
#include "eyebridge/hal/url.hpp"
#include "fault/fault_script.hpp"
#include "hand/hand_text.hpp"
#include "key_script.hpp"
#include "pnm.hpp"
#include "replay/ebrec.hpp"
#include "terminal/input_decoder.hpp"
#include "text_encoding.hpp"

// What the fuzz targets and the test over their corpus do with one input. Anything but a model or
// a ConfigError (of an image: an Error, of a picture: a runtime_error) ends the process: that is a
// finding.
namespace eyebridge::fuzz {

/// Ends the process: what was read did not survive being written.
[[noreturn]] inline void found() { std::abort(); }

inline void world_read(std::string_view text, files::Reading reading) {
  std::vector<Warning> warnings;
  try {
    const auto model = files::read_world(text, "fuzz.wld", warnings, nullptr, reading);
    std::string written;
    try {
      written = files::write_world(model);
    } catch (const ConfigError&) {
      found();
    }
    if (files::read_world(written, "again.wld", warnings) != model) found();
  } catch (const ConfigError&) {  // the input is no world
  }
}

inline void world(std::string_view text) {
  const std::string description = files::description_in(text);
  if (in_quotes(description, 1000) != "'" + description + "'") found();
  world_read(text, files::Reading::Strict);
  world_read(text, files::Reading::Tolerant);
}

/// What a format can say of the maze survives, and always its walls.
inline void maze_as(files::MazeFormat format, const world::WorldModel& model) {
  files::WrittenWorld written;
  try {
    written = files::write_maze_as(format, model);
  } catch (const ConfigError&) {
    return;  // two things in one cell, rows too long for a line
  }
  std::vector<Warning> warnings;
  try {
    const auto again = files::read_maze(written.text, "again", warnings);
    if (written.losses.empty() && again != model) found();
    if (again.maze->south != model.maze->south || again.maze->west != model.maze->west) found();
  } catch (const ConfigError&) {
    found();  // we wrote it
  }
}

inline void maze(std::string_view bytes) {
  std::vector<Warning> warnings;
  std::optional<world::WorldModel> model;
  try {
    model = files::read_maze(bytes, "fuzz.maz", warnings);
  } catch (const ConfigError&) {
    return;  // the input is no maze
  }
  if (files::maze_format(bytes).value_or(files::MazeFormat::Drawing) ==
      files::MazeFormat::Drawing) {
    try {
      if (files::read_maze(files::write_maze(*model), "again.maz", warnings) != *model) found();
    } catch (const ConfigError&) {
      found();
    }
  }
  for (const auto format :
       {files::MazeFormat::Drawing, files::MazeFormat::Posts, files::MazeFormat::List}) {
    maze_as(format, *model);
  }
}

/// Text of other systems becomes text, or an error.
inline void encoding(std::string_view bytes) {
  try {
    const std::string text = files::as_utf8(std::string(bytes), "fuzz");
    if (text.find('\r') != std::string::npos) found();
  } catch (const ConfigError&) {
  }
}

inline void robi(std::string_view text) {
  std::vector<Warning> warnings;
  try {
    static_cast<void>(files::read_robi(text, "fuzz.robi", warnings, files::Reading::Tolerant));
    static_cast<void>(files::read_robi(text, "fuzz.robi", warnings));
  } catch (const ConfigError&) {  // the input is no robot
  }
}

inline void sim_read(std::string_view text, files::Reading reading) {
  std::vector<Warning> warnings;
  try {
    const auto sim = files::read_sim(text, "fuzz.sim", warnings, reading);
    std::string written;
    try {
      written = files::write_sim(sim);
    } catch (const ConfigError&) {
      found();
    }
    if (!files::same_meaning(files::read_sim(written, "again.sim", warnings), sim)) found();
  } catch (const ConfigError&) {  // the input is no simulation
  }
}

inline void sim(std::string_view text) {
  sim_read(text, files::Reading::Strict);
  sim_read(text, files::Reading::Tolerant);
}

inline void parameter(std::string_view text) {
  std::vector<Warning> warnings;
  try {
    static_cast<void>(files::read_parameter_file(text, "fuzz.p", warnings));
  } catch (const ConfigError&) {  // the input is no parameter file
  }
}

inline void object(std::string_view text) {
  for (const files::Reading reading : {files::Reading::Strict, files::Reading::Tolerant}) {
    std::vector<Warning> warnings;
    try {
      const auto object = files::read_object(text, "fuzz.esObj", "fuzz", warnings, reading);
      if (!(object.radius > 0 && object.height > 0)) found();
    } catch (const ConfigError&) {  // the input is no object
    }
  }
}

/// Whether `table` has `fewest` to `most` values of 0 to `top`.
inline bool is_within(const files::HdtTable& table, std::size_t fewest, std::size_t most, int top) {
  const auto fits = [top](int value) { return value >= 0 && value <= top; };
  return table.values.size() >= fewest && table.values.size() <= most &&
         std::ranges::all_of(table.values, fits);
}

/// Each table is as its device needs it; what the board is told is within what it takes.
inline void hdt(std::string_view text) {
  std::vector<Warning> warnings;
  try {
    const files::Hdt hdt = files::read_hdt(text, "fuzz.txt", warnings);
    for (const files::HdtMotor& motor : hdt.motors) {
      const files::HdtTable* table = hdt.table_of(motor);
      if (table != nullptr && !is_within(*table, 101, 101, 100)) found();
    }
    for (const files::HdtServo& servo : hdt.servos) {
      const files::HdtTable* table = hdt.table_of(servo);
      if (table != nullptr && !is_within(*table, 256, 256, 255)) found();
      const files::ServoLimits limits = files::servo_limits(servo);
      if (limits.lower < 0 || limits.upper > 255 || limits.lower > limits.upper) found();
    }
    for (const files::HdtPsd& psd : hdt.psds) {
      if (!is_within(*hdt.table_of(psd), 2, 65536, 65535)) found();
    }
    for (const files::HdtEncoder& encoder : hdt.encoders) {
      if (encoder.ticks_per_metre < 1) found();
    }
    if (hdt.drive && !(hdt.drive->wheel_base > 0)) found();
  } catch (const ConfigError&) {  // the input is no HDT
  }
}

/// The bytes as a file, which is all that the reader takes.
inline void recording(std::string_view bytes) {
  static const std::string path = "/tmp/eyebridge-fuzz-" + std::to_string(getpid()) + ".ebrec";
  std::ofstream(path, std::ios::binary) << bytes;
  try {
    hal::read_recording(path);
  } catch (const ConfigError&) {  // the input is no recording
  }
  try {
    constexpr std::size_t kMost = 4;
    camera::FrameReader reader(path);
    for (std::size_t i = 0; i < std::min(kMost, reader.frames().size()); ++i) {
      const camera::Size size = reader.frames()[i].size;
      const Result<camera::Frame> frame = reader.read(i);
      if (frame && camera::Size{frame->width, frame->height} != size) found();
    }
  } catch (const ConfigError&) {
  }
  for (const char* end : {"", "-wal", "-shm"}) std::remove((path + end).c_str());
}

/// What is accepted gives a robot errors that can be, and none when nothing of them is simulated.
inline void errors(std::string_view text) {
  try {
    files::Scenario scenario = files::default_scenario();
    robot::RobotModel& model = scenario.models.front();
    model.lidar = robot::LidarModel{};
    model.range_matrices.emplace_back();
    for (auto& sensor : model.range_sensors) sensor.table = robot::RangeTable({0.1, 0.2, 0.4});
    files::apply_rules(files::read_error_rules(text, {}), scenario);
    for (robot::RobotModel& robot : scenario.models) {
      const auto share = [](double value) { return value >= 0.0 && value <= 1.0; };
      for (const auto& sensor : robot.range_sensors) {
        if (!share(sensor.error.dropout) || !(sensor.error.sigma >= 0.0)) found();
      }
      for (const auto& matrix : robot.range_matrices) {
        if (!share(matrix.error.dropout) || !(matrix.error.sigma >= 0.0)) found();
      }
      const robot::RadioError& radio = robot.radio_error;
      if (!share(radio.loss) || !share(radio.corrupt) || !(radio.delay >= 0.0)) found();
      if (!share(robot.drive_error.slip) || !share(robot.camera->error.coloured)) found();
      robot::scale_errors(robot, 0.0);
      if (!robot::is_perfect(robot)) found();
    }
  } catch (const ConfigError&) {  // the input is no list of rules
  }
}

/// What is accepted has a time, a device and an amount that can be.
inline void faults(std::string_view text) {
  try {
    for (const hal::FaultRule& rule : hal::parse_fault_script(text, {})) {
      const bool sane = rule.from >= Time{0} && rule.from < rule.to && rule.value >= 0.0 &&
                        rule.id >= 0 && rule.id < 100 && !rule.device.empty();
      if (!sane) found();
    }
  } catch (const ConfigError&) {  // the input is no script
  }
}

/// What is accepted has lengths and an angle that can be.
inline void hand(std::string_view text) {
  try {
    const hal::HandSetting setting = hal::parse_hand(text, {});
    const camera::FiducialLayout& layout = setting.layout;
    const bool sane = layout.size > 0.0 && layout.spacing > 0.0 && layout.height >= 0.0 &&
                      layout.size + layout.spacing + layout.height <= 300.0;
    const double angle = setting.field_of_view.value_or(1.0);
    if (!sane || !(angle > 0.0 && angle < 3.0)) found();
  } catch (const ConfigError&) {  // the input is no setting
  }
}

/// The presses of a script are in order and each is one key, a code of the remote control or a
/// touch.
inline void keys(std::string_view text) {
  try {
    Time last{0};
    for (const robios::ScriptedKey& key : robios::parse_key_script(text)) {
      if (key.at < last || key.key < 0 || key.key > 8 || key.remote < 0 || key.remote > 255 ||
          (key.key != 0 && key.remote != 0)) {
        found();
      }
      last = key.at;
    }
  } catch (const ConfigError&) {  // the input is no script
  }
}

/// What a terminal sends: a key is one of four or a click within the numbers, a byte gives one
/// event at most.
inline void terminal_input(std::string_view bytes) {
  robios::InputDecoder decoder;
  for (const char byte : bytes) {
    const auto event = decoder.push(static_cast<std::uint8_t>(byte));
    if (!event) continue;
    const bool is_key = event->key == 1 || event->key == 2 || event->key == 4 || event->key == 8;
    const bool is_click = event->key == 0 && event->column >= 0 && event->row >= 0 &&
                          event->column < 100'000 && event->row < 100'000;
    if (!is_key && !is_click) found();
    if (event->remote != 0 && (event->column != 0 || event->row != 0 || event->remote > 'Y'))
      found();
    if (is_key && (byte < '1' || byte > '4')) found();
  }
}

/// An image holds what its size says, is not much bigger than its file, and survives a round trip.
inline void pnm(std::string_view text) {
  PnmPicture image;
  try {
    image = read_pnm(text, "fuzz.pnm");
  } catch (const ConfigError&) {
    return;  // the input is no picture
  }
  const std::size_t pixels =
      static_cast<std::size_t>(image.columns) * static_cast<std::size_t>(image.rows);
  const std::vector<std::uint8_t> written = robios::write_pnm(image);
  const std::string again(written.begin(), written.end());
  if (image.bytes.size() != pixels * pnm_channels(image.kind) ||
      image.bytes.size() > 8 * text.size() || read_pnm(again, "again.pnm") != image) {
    found();
  }
}

/// A picture has at most the pixels allowed and is as large as it says.
inline void picture(std::string_view text) {
  constexpr std::uint64_t kMostPixels = 1U << 20U;
  try {
    const camera::Frame frame = camera::decode_picture(
        {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, kMostPixels);
    const auto pixels =
        static_cast<std::uint64_t>(frame.width) * static_cast<unsigned>(frame.height);
    if (pixels < 1 || pixels > kMostPixels || frame.bytes.size() != 3 * pixels) found();
  } catch (const std::runtime_error&) {  // the input is no picture
  }
}

/// A calibration survives being written and read.
inline void calibration(std::string_view text) {
  try {
    const camera::Calibration lens = camera::parse_calibration(text, "fuzz.toml");
    if (camera::parse_calibration(camera::to_toml(lens), "again.toml") != lens) found();
  } catch (const ConfigError&) {  // the input is no calibration
  }
}

/// The text as an eyebridge.toml, as a duration and as the URL of a backend.
inline void config(std::string_view text) {
  const SourceLocation where{"fuzz"};
  try {
    hal::read_toml(text, "fuzz.toml");
  } catch (const ConfigError&) {  // the input is no configuration
  }
  try {
    if (parse_duration(text, where) < 0.0) found();
  } catch (const ConfigError&) {  // the input is no duration
  }
  try {
    if (hal::parse_backend_url(text, where).scheme.empty()) found();
  } catch (const ConfigError&) {  // the input is no URL
  }
}

/// The text as the plan that a process hands to a program: what is read is written the same.
inline void run_plan(std::string_view text) {
  hal::RunPlan plan;
  try {
    plan = hal::read_run_plan(text);
  } catch (const ConfigError&) {
    return;  // the input is no plan
  }
  const std::string written = hal::run_plan_text(plan);
  const hal::RunPlan again = hal::read_run_plan(written);
  if (again.sources != plan.sources || hal::run_plan_text(again) != written) found();
}

}  // namespace eyebridge::fuzz
