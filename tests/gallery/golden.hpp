#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace eyebridge::gallery {

using Lines = std::vector<std::string>;

/// The lines of `text`, without their ends.
Lines lines_of(std::string_view text);

/// What a run left behind, as text that a person can judge: the content of golden/NAME.txt.
struct Golden {
  std::string review;  ///< What the person found; "" while nobody has looked.
  std::vector<std::pair<std::string, Lines>> sections;  ///< Name and lines, in their order.
};

/// "# review: …", then for each section "[name]" and its lines, each after "| ".
std::string to_text(const Golden& golden);

/// Reads what to_text() writes. Throws std::runtime_error naming the line.
Golden parse_golden(std::string_view text);

/// How far a run may be from its golden.
struct Tolerance {
  double number = 0.0;  ///< Of numbers, except in stdout, stderr, "lcd picture" and the exit code.
  double cells = 0.0;  ///< Share of the cells of "lcd picture" that may differ, not its first line.
};

/// One line for each thing that differs; empty when the run is as it should be.
Lines differences(const Golden& expected, const Golden& actual, const Tolerance& tolerance);

}  // namespace eyebridge::gallery
