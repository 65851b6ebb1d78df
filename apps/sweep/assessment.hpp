#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "eyebridge/base/pose.hpp"
#include "sweep/plan.hpp"
#include "sweep/results.hpp"

namespace eyebridge::apps {

/// Where robot 1 is to be at the end: its centre in a disc on the floor.
struct Goal {
  Vec2 centre;          ///< In the world, metres.
  double radius = 0.0;  ///< Metres, > 0; its edge belongs to it.
};

/// What a run must come to besides having ended by itself.
struct Criteria {
  bool no_collisions = false;
  std::optional<Goal> goal;           ///< Of worlds without one of their own.
  std::map<std::string, Goal> goals;  ///< World, as coordinates name it -> its own.

  /// The goal in that world; null when it has none.
  [[nodiscard]] const Goal* goal_in(const std::string& world) const;
};

/// A run and what is to be said of it.
struct AssessedRun {
  ResultRow row;
  std::string group;    ///< Label: "maze-5.maz", or "maze-5.maz errors=realistic".
  std::string verdict;  ///< "success"; or how it ended, "goal missed", "collision", "no robot".
  std::string reason;   ///< Of anything but a success: one line for people.
  std::optional<double> goal_distance;  ///< From the goal's centre at the end, metres.

  [[nodiscard]] bool success() const { return verdict == "success"; }
};

/// Judges those of `rows` that are of `cells`, in the order of the cells.
///
/// A success is a run that ended by itself with exit code 0, before its time limit; at whose end
/// robot 1 was in the goal of its world, if that has one (P. Anderson and others, On Evaluation of
/// Embodied Navigation Agents, 2018: who passes by without stopping has not found it); and in which
/// no robot hit anything, if `criteria` wants that.
std::vector<AssessedRun> assess_runs(const std::vector<ResultRow>& rows,
                                     const std::vector<Cell>& cells, const Criteria& criteria);

/// From `low` to `high`.
struct Interval {
  double low = 0.0;
  double high = 0.0;
};

/// The 95 % confidence interval, within 0 ... 1, of a rate of which `successes` of `runs` (> 0)
/// were seen: E. B. Wilson, Probable Inference, J. Am. Stat. Assoc. 22 (1927), 209-212.
Interval wilson_interval(std::size_t successes, std::size_t runs);

/// The value below which `share` (0 ... 1) of `values` (one or more) lies, between two of them on
/// the line through both: type 7 of R. J. Hyndman and Y. Fan, Sample Quantiles in Statistical
/// Packages, Am. Stat. 50 (1996). 0.5 gives the median.
double quantile(std::vector<double> values, double share);

/// A number of each run that is shown.
struct Measure {
  const char* value;   ///< Its name in ResultRow::values.
  const char* title;   ///< For people, with its unit.
  const char* column;  ///< In tables for programs, and of its picture.
  bool of_successes;   ///< Of a run that failed it says nothing.
};

/// All of them, in the order in which they are shown.
const std::vector<Measure>& measures();

/// Runs that differ in nothing but the seed; or all.
struct Score {
  std::string group;
  std::size_t runs = 0;
  std::size_t successes = 0;
  std::map<std::string, std::size_t> failures;        ///< Verdict -> how many.
  std::map<std::string, std::vector<double>> values;  ///< Measure::value -> numbers, where told.
  bool all_alike = false;  ///< More than one run, and all of them the same to the bit.

  [[nodiscard]] double rate() const;
};

/// One for each group in order of first appearance; and "all", if there are several.
std::vector<Score> score(const std::vector<AssessedRun>& runs);

}  // namespace eyebridge::apps
