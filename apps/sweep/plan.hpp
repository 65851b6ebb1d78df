#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge::apps {

/// What an axis of a sweep varies.
enum class AxisKind { Program, Parameter, Environment, Setting };

/// A value and where it was written.
struct AxisValue {
  std::string text;
  SourceLocation where;
};

/// One thing that is tried with several values (or with one).
struct Axis {
  AxisKind kind = AxisKind::Setting;
  std::string name;
  std::vector<AxisValue> values;  ///< At least one.
};

/// What a sweep file and its command line say.
struct SweepPlan {
  std::vector<Axis> axes;            ///< No two of one kind and name.
  std::vector<AxisValue> arguments;  ///< Of the program; {name} is a parameter's value.
  std::string results = "sweep.db";
  double wall_limit = 600;  ///< A run that takes longer hangs; seconds of real time.
  int jobs = 0;             ///< Runs at a time; 0: one a core.

  /// The axis of that kind and name; null when there is none.
  [[nodiscard]] Axis* find(AxisKind kind, const std::string& name);
  /// Takes the place of an axis of the same kind and name, or is a new one.
  void put(Axis axis);
};

/// One run: a value of each axis.
struct Cell {
  std::string program;
  std::vector<std::string> arguments;
  std::map<std::string, std::string> settings;
  std::map<std::string, std::string> environment;
  std::map<std::string, std::string> parameters;

  /// Names and values of all axes in one order: "program", "$NAME" (environment), parameters,
  /// settings. This is how results name them, and what tells two cells apart.
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> coordinates() const;
  /// The coordinates and arguments as one text, lines escaped: equal for the same run alone.
  [[nodiscard]] std::string key() const;
};

/// The most runs of one sweep.
inline constexpr std::size_t kMostCells = 1'000'000;

/// All cells, the seed varying fastest. Throws ConfigError: no program, {name} that is no
/// parameter, a parameter that no argument uses, a name that is a setting's and a parameter's, too
/// many cells.
std::vector<Cell> cells_of(const SweepPlan& plan);

/// "1..20" or "7": all whole numbers of the range, both ends included. Throws ConfigError at
/// `where`.
std::vector<AxisValue> read_range(const std::string& text, const SourceLocation& where);

/// How many runs at a time: 0 … 1024. Throws ConfigError at `where`.
int read_jobs(const std::string& text, const SourceLocation& where);

/// Throws ConfigError for a setting that a sweep sets itself (`report`, `panel`), or whose files
/// would be written by all runs at once (`out`, `record`).
void check_can_vary(const std::string& setting, const SourceLocation& where);

}  // namespace eyebridge::apps
