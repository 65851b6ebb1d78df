#pragma once

#include <map>
#include <string>
#include <vector>

#include "sweep/results.hpp"

namespace eyebridge::apps {

/// Mean, deviation and bounds of some numbers.
struct Spread {
  std::size_t count = 0;
  double mean = 0.0;
  double deviation = 0.0;  ///< Of a sample: divided by count - 1; 0 for a single number.
  double least = 0.0;
  double most = 0.0;

  /// Welford's recurrence (Technometrics 4, 1962).
  void add(double value);

 private:
  double squares_ = 0.0;
};

/// Runs that differ in nothing but what is not grouped by.
struct Group {
  std::string label;  ///< "world=corridor.wld keep=0.2"; "all runs" without any difference.
  std::size_t runs = 0;
  std::map<std::string, std::size_t> ends;            ///< How runs ended -> how many.
  std::map<std::string, std::vector<double>> values;  ///< Of the runs that ended well.

  [[nodiscard]] Spread spread(const std::string& value) const;
};

/// Groups `rows` by the coordinates named in `by`; when that is empty, by all that differ, but for
/// the seed. In order of first appearance. Throws ConfigError for a name that no run has.
std::vector<Group> group_runs(const std::vector<ResultRow>& rows,
                              const std::vector<std::string>& by);

/// A table for people: of each group how its runs ended, and of each value mean, deviation, least
/// and most.
std::string summary_table(const std::vector<Group>& groups);

}  // namespace eyebridge::apps
