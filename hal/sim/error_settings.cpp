#include "sim/error_settings.hpp"

#include <algorithm>
#include <iterator>
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

void give_tables(const std::string& path, files::Scenario& scenario) {
  const files::Hdt hdt = files::read_hdt(files::read_text_file(path), path, scenario.warnings);
  for (robot::RobotModel& model : scenario.models) {
    for (robot::RangeSensorModel& sensor : model.range_sensors) {
      const auto psd = std::ranges::find(hdt.psds, sensor.id, &files::HdtPsd::id);
      if (psd == hdt.psds.end()) continue;
      if (const files::HdtTable* table = hdt.table_of(*psd)) sensor.table = table_of(*table);
    }
  }
}

}  // namespace

void apply_error_settings(const Config& config, files::Scenario& scenario) {
  if (config.is_set("hdt")) give_tables(config.path("hdt").string(), scenario);
  const ConfigValue& errors = config.value("errors");
  files::apply_rules(files::read_error_rules(errors.text, errors.where), scenario);
  const double percent = config.number("error_scale");
  if (percent == 100.0) return;
  for (robot::RobotModel& model : scenario.models) robot::scale_errors(model, percent / 100);
}

}  // namespace eyebridge::hal
