#include "sim/error_settings.hpp"

#include <algorithm>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include "eyebridge/base/units.hpp"
#include "eyebridge/files/error_rules.hpp"
#include "eyebridge/files/hdt.hpp"
#include "eyebridge/files/readers.hpp"

namespace eyebridge::hal {
namespace {

robot::RangeTable table_of(const files::HdtTable& table) {
  std::vector<double> metres;
  std::ranges::transform(table.values, std::back_inserter(metres), mm_to_m);
  return robot::RangeTable(metres);
}

void give_tables(const Config& config, std::span<robot::RobotModel> models,
                 std::vector<Warning>& warnings) {
  if (!config.is_set("hdt")) return;
  const std::string path = config.path("hdt").string();
  const files::Hdt hdt = files::read_hdt(files::read_text_file(path), path, warnings);
  for (robot::RobotModel& model : models) {
    for (robot::RangeSensorModel& sensor : model.range_sensors) {
      const auto psd = std::ranges::find(hdt.psds, sensor.id, &files::HdtPsd::id);
      if (psd == hdt.psds.end()) continue;
      if (const files::HdtTable* table = hdt.table_of(*psd)) sensor.table = table_of(*table);
    }
  }
}

std::vector<files::ErrorRule> rules_of(const Config& config) {
  const ConfigValue& errors = config.value("errors");
  return files::read_error_rules(errors.text, errors.where);
}

void scale(const Config& config, std::span<robot::RobotModel> models) {
  const double percent = config.number("error_scale");
  if (percent == 100.0) return;
  for (robot::RobotModel& model : models) robot::scale_errors(model, percent / 100);
}

}  // namespace

void apply_error_settings(const Config& config, files::Scenario& scenario) {
  give_tables(config, scenario.models, scenario.warnings);
  files::apply_rules(rules_of(config), scenario);
  scale(config, scenario.models);
}

void apply_error_settings(const Config& config, robot::RobotModel& model) {
  std::vector<Warning> known;  // from when the world was opened
  give_tables(config, {&model, 1}, known);
  for (const files::ErrorRule& rule : rules_of(config)) {
    if (!rule.robot) files::apply_rule(rule, model);
  }
  scale(config, {&model, 1});
}

}  // namespace eyebridge::hal
