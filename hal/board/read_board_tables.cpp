// From an HDT file to what the devices need.
#include <fstream>
#include <sstream>

#include "board/board_tables.hpp"
#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/files/hdt.hpp"

namespace eyebridge::hal {

namespace {

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file || !text) throw ConfigError({path}, "cannot be read; expected an HDT file");
  return text.str();
}

}  // namespace

BoardTables read_board_tables(const std::string& path, std::vector<Warning>& warnings) {
  const files::Hdt hdt = files::read_hdt(text_of(path), path, warnings);
  BoardTables tables;
  for (const files::HdtMotor& motor : hdt.motors) {
    BoardMotorTable& out = tables.motors.emplace_back();
    out.id = motor.id;
    if (const files::HdtTable* table = hdt.table_of(motor)) {
      for (const int percent : table->values) out.duty.push_back(percent / 100.0);
    }
  }
  for (const files::HdtServo& servo : hdt.servos) {
    BoardServoTable& out = tables.servos.emplace_back();
    out.id = servo.id;
    if (const files::HdtTable* table = hdt.table_of(servo)) out.position = table->values;
    const files::ServoLimits limits = files::servo_limits(servo);
    out.lower_10us = limits.lower;
    out.upper_10us = limits.upper;
  }
  for (const files::HdtPsd& psd : hdt.psds) {
    BoardPsdTable& out = tables.psds.emplace_back();
    out.id = psd.id;
    if (const files::HdtTable* table = hdt.table_of(psd)) {
      for (const int mm : table->values) out.metres.push_back(mm_to_m(mm));
    }
  }
  for (const files::HdtEncoder& encoder : hdt.encoders) {
    tables.encoders.push_back(encoder.id);
    if (encoder.id == 1) tables.drive.left_ticks_per_metre = encoder.ticks_per_metre;
    if (encoder.id == 2) tables.drive.right_ticks_per_metre = encoder.ticks_per_metre;
  }
  if (hdt.drive) {
    if (hdt.drive->kind != robot::DriveKind::Differential) {
      throw ConfigError(hdt.drive->where,
                        "found another drive than a differential one, expected "
                        "two wheels");
    }
    tables.drive.wheel_base = hdt.drive->wheel_base;
    tables.drive.left_reversed = hdt.drive->left_clockwise;
    tables.drive.right_reversed = hdt.drive->right_clockwise;
    if (hdt.drive->max_speed > 0) tables.drive.max_linear = hdt.drive->max_speed;
  }
  return tables;
}

}  // namespace eyebridge::hal
