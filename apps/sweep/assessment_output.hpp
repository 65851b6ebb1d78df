#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sweep/assessment.hpp"

namespace eyebridge::apps {

/// A table for people: of each group the rate of success with its interval and why others failed,
/// then median, least and most of each measure.
std::string assessment_table(const std::vector<Score>& scores);

/// One line a run, after a line of names: what was varied, the verdict, what came of it. Numbers
/// that the program itself said ("result NAME VALUE") come last. As RFC 4180, with "\n".
std::string runs_csv(const std::vector<AssessedRun>& runs);

/// One line a group, after a line of names. As runs_csv().
std::string summary_csv(const std::vector<Score>& scores);

/// Draws success.png (rate and interval) and one picture for each measure that any run has, named
/// by its column (every run a dot, the median a line, a bar from the first to the third quartile),
/// into `folder`; removes those of measures that no run has. Throws as plot_rows().
void plot_assessment(const std::vector<Score>& scores, const std::filesystem::path& folder);

}  // namespace eyebridge::apps
