#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/files/scenario.hpp"
#include "eyebridge/robot/error_presets.hpp"

namespace eyebridge::files {

// What people write about errors, the same in `.robi`, `eyesim.p`, `.sim` (after the keyword
// `error`) and in the setting `errors` (between its ';'): docs/errors.md.
//
//   [robot:N] PRESET                          realistic
//   [robot:N] KIND[:ID] VALUE … NAME=VALUE …  psd:2 4 1 dropout=5%

struct ErrorKind;
struct ErrorParameter;

/// One of them, read.
struct ErrorRule {
  std::optional<int> robot;                  ///< Its number in the scenario, from 1; none: all.
  std::optional<robot::ErrorModels> preset;  ///< Then nothing below counts.
  const ErrorKind* kind = nullptr;
  std::optional<int> device;                                     ///< None: all of the kind.
  std::vector<std::pair<const ErrorParameter*, double>> values;  ///< As its `set` takes it.
  SourceLocation where;
};

/// A word of a rule; borrows its text.
struct ErrorWord {
  std::string_view text;
  SourceLocation where;
};

/// Reads one rule of at least one word; `end` is where its line ends. Throws ConfigError at the
/// word that is wrong.
ErrorRule read_error_rule(std::span<const ErrorWord> words, const SourceLocation& end);

/// Reads rules with ';' between them, as the setting `errors` and programs write them. `where` is
/// where `text` begins; without a line, its columns count from the text's begin. Throws
/// ConfigError.
std::vector<ErrorRule> read_error_rules(std::string_view text, const SourceLocation& where);

/// Does what `rule` says to the devices of `model`, whichever robot the rule is for. False when
/// there is no such device. Throws ConfigError where readings are to be rounded by a table that the
/// sensor does not have.
bool apply_rule(const ErrorRule& rule, robot::RobotModel& model);

/// The error for a rule about a device that `model` does not have.
ConfigError no_such_device(const ErrorRule& rule, const robot::RobotModel& model);

/// Applies `rules` in their order to the robots of `scenario`; one that a rule names gets a model
/// of its own. Throws ConfigError for a robot that is not there, and for a device, named by its
/// number, that none of the robots has.
void apply_rules(std::span<const ErrorRule> rules, Scenario& scenario);

/// `model` with its errors changed by `rules`, written as for read_error_rules(), and then scaled
/// by `share`, 0 … 1. Throws ConfigError, its file named "errors": for rules that name a robot,
/// too.
robot::RobotModel with_errors(robot::RobotModel model, std::string_view rules, double share);

}  // namespace eyebridge::files
