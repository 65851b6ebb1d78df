#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "eyebridge/files/error_rules.hpp"
#include "eyebridge/robot/robot_model.hpp"
#include "psd_kinds.hpp"
#include "text.hpp"

namespace eyebridge::files {

/// Puts a RobotModel together from the lines that `.robi` and `eyesim.p` have in common.
///
/// Errors, tables and ranges may stand before the sensors they speak of: finish() applies them.
class RobotBuilder {
 public:
  explicit RobotBuilder(Warnings& warnings) : warnings_(warnings) {}

  robot::RobotModel& model() { return model_; }

  /// A sensor as its line gives it; `id` is token number `id_token` where there is one.
  void add_psd(const Statement& s, std::size_t name_token, std::optional<std::size_t> id_token,
               const Pose& pose, double height);
  void add_ir(const Statement& s, const Pose& pose, std::optional<std::size_t> threshold_token);
  /// "bump NAME id start end"
  void add_bump(const Statement& s);
  /// Our extensions: true when the line was one of "psd_range", "psd_table", "psd_kind", "accel",
  /// "kicker", "servo", "friction" and "error".
  bool read_extension(const Statement& s);

  /// Numbers the sensors, applies errors and ranges. Throws ConfigError for an id met twice.
  robot::RobotModel finish();

 private:
  struct Id {
    int written = 0;  ///< 0: none.
    int line = 0;
    int column = 0;
    SourceLocation where;
  };

  Id read_id(const Statement& s, std::size_t token) const;
  void read_error(const Statement& s);
  void read_table(const Statement& s);
  void read_kicker(const Statement& s);
  void read_servo(const Statement& s);
  void check_servos() const;
  template <class Sensor>
  void number_sensors(std::vector<Sensor>& sensors, const std::vector<Id>& ids,
                      std::string_view kind);

  Warnings& warnings_;
  robot::RobotModel model_;
  std::vector<Id> psd_ids_;
  std::vector<Id> ir_ids_;
  std::vector<Id> bump_ids_;
  std::optional<std::pair<double, double>> psd_range_;
  robot::RangeTable psd_table_;
  std::vector<PsdKind> psd_kinds_;
  std::vector<SourceLocation> servo_where_;  ///< Of the model's servos.
  std::vector<ErrorRule> errors_;
};

}  // namespace eyebridge::files
