#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sweep/summary.hpp"

namespace eyebridge::apps {

/// What is typical of a row: a bar from `low` to `high`, and a line across it at `mark`.
struct PlotBar {
  double low = 0.0;
  double mark = 0.0;
  double high = 0.0;
};

/// A row of a picture.
struct PlotRow {
  std::string label;  ///< At its left; shortened when it is too long.
  std::vector<double> dots;
  std::optional<PlotBar> bar;
};

/// Draws rows below each other as a PNG, along one axis that shows all dots, or from
/// `bounds->first` to `bounds->second`, with `title` above it; bars end where it does. Throws
/// ConfigError for more than 500 rows, and std::runtime_error when the file cannot be written.
void plot_rows(const std::vector<PlotRow>& rows, const std::string& title,
               const std::filesystem::path& file,
               std::optional<std::pair<double, double>> bounds = std::nullopt);

/// Draws `value` of each group as a PNG: every run a dot, the mean a line, the deviation a bar.
/// Throws ConfigError when no run has the value (it names those there are), and std::runtime_error
/// when the file cannot be written.
void plot(const std::vector<Group>& groups, const std::string& value,
          const std::filesystem::path& file);

}  // namespace eyebridge::apps
