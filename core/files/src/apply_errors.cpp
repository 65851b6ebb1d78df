// What rules about errors do to robots.
#include <algorithm>
#include <map>
#include <type_traits>

#include "error_parameters.hpp"
#include "eyebridge/files/error_rules.hpp"
#include "text.hpp"

namespace eyebridge::files {
namespace {

/// Calls `visit(error, id)` for the devices that `rule`, which is no preset, is about.
template <class Model, class Visit>
void for_each_meant(const ErrorRule& rule, Model& model, Visit&& visit) {
  robot::for_each_error(model, [&](auto& error, int id) {
    using Error = std::remove_cvref_t<decltype(error)>;
    const bool meant = !rule.device || *rule.device == id;
    if (rule.kind->part == robot::kErrorPart<Error> && meant) visit(error, id);
  });
}

/// Only what the rule itself asks for: a preset rounds where there is a table.
void check_tables(const ErrorRule& rule, const robot::RobotModel& model) {
  robot::ErrorModels wanted;
  for (const auto& [parameter, value] : rule.values) parameter->set(wanted, value);
  if (!wanted.range.quantised) return;
  for (const robot::RangeSensorModel& sensor : model.range_sensors) {
    if (!sensor.table.empty() || (rule.device && *rule.device != sensor.id)) continue;
    throw ConfigError(rule.where, "psd " + std::to_string(sensor.id) + " of robot " +
                                      in_quotes(model.name) +
                                      " has no table to round to: expected a psd_table line in its "
                                      "file, or its table in the HDT file of --hdt");
  }
}

}  // namespace

bool apply_rule(const ErrorRule& rule, robot::RobotModel& model) {
  if (rule.preset) {
    robot::set_errors(model, *rule.preset);
    return true;
  }
  check_tables(rule, model);
  bool found = false;
  for_each_meant(rule, model, [&](auto& error, int) {
    using Error = std::remove_cvref_t<decltype(error)>;
    robot::ErrorModels models;
    robot::part_of<Error>(models) = error;
    for (const auto& [parameter, value] : rule.values) parameter->set(models, value);
    error = robot::part_of<Error>(models);
    found = true;
  });
  return found;
}

ConfigError no_such_device(const ErrorRule& rule, const robot::RobotModel& model) {
  ErrorRule any = rule;
  any.device.reset();
  std::string known;
  for_each_meant(any, model, [&](const auto&, int id) {
    known += (known.empty() ? "" : ", ") + std::to_string(id);
  });
  const std::string kind(rule.kind->name);
  return {rule.where,
          "robot " + in_quotes(model.name) + " has no " + kind + " " +
              std::to_string(rule.device.value_or(0)) + ": expected " +
              (known.empty() ? "another kind, it has none of this" : "one of " + known)};
}

void apply_rules(std::span<const ErrorRule> rules, Scenario& scenario) {
  if (rules.empty()) return;
  std::map<int, std::size_t> own;  // models of robots that rules name
  for (const ErrorRule& rule : rules) {
    if (!rule.robot || own.contains(*rule.robot)) continue;
    const auto index = static_cast<std::size_t>(*rule.robot) - 1;
    const std::size_t present = scenario.robots.size();
    const std::size_t count = present + scenario.newcomers.size();
    if (index >= count) {
      throw ConfigError(rule.where, "found robot " + std::to_string(*rule.robot) +
                                        ": expected 1 to " + std::to_string(count));
    }
    std::size_t& model = index < present ? scenario.robots[index].model
                                         : scenario.newcomers[index - present].robot.model;
    scenario.models.push_back(robot::RobotModel(scenario.models.at(model)));
    own[*rule.robot] = model = scenario.models.size() - 1;
  }
  for (const ErrorRule& rule : rules) {
    bool found = false;
    if (rule.robot) {
      found = apply_rule(rule, scenario.models[own.at(*rule.robot)]);
    } else {
      // Models that no robot has, too: another robot may be made of one yet.
      for (robot::RobotModel& model : scenario.models) found = apply_rule(rule, model) || found;
    }
    if (found || !rule.device) continue;
    const std::size_t asked = rule.robot ? own.at(*rule.robot) : scenario.robots.at(0).model;
    throw no_such_device(rule, scenario.models.at(asked));
  }
}

robot::RobotModel with_errors(robot::RobotModel model, std::string_view rules, double share) {
  for (const ErrorRule& rule : read_error_rules(rules, {"errors"})) {
    if (rule.robot) throw ConfigError(rule.where, "found robot:N: this is about one robot already");
    if (!apply_rule(rule, model) && rule.device) throw no_such_device(rule, model);
  }
  robot::scale_errors(model, share);
  return model;
}

}  // namespace eyebridge::files
