#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "editor/plan.hpp"

namespace eyebridge::gui {

/// A plan as files have it.
struct PlanFiles {
  Plan plan;
  std::filesystem::path path;    ///< .wld, .maz or .sim; empty: none yet.
  std::filesystem::path ground;  ///< Of its walls: `path`, or what that .sim names; may be empty.
  std::string header;            ///< Comments at the top of `path` …
  std::string ground_header;     ///< … and of `ground`, which are kept.
  int other_comments = 0;        ///< Lines with a comment that saving does not keep.
  std::vector<Warning> warnings;
};

/// Reads a .wld, .maz or .sim with the ground that it names. Robots need not stand free. Throws
/// ConfigError.
PlanFiles open_plan(const std::filesystem::path& path);

/// A file to be written.
struct FileText {
  std::filesystem::path path;
  std::string text;
};
struct Saving {
  std::vector<FileText> texts;
  PlanFiles files;  ///< As it will be then.
};

/// What is to be written to save `plan`, which came from `source`, as `target`, whose ending says
/// the kind: .wld, .maz or .sim. A ground that has not changed is left alone; one that has goes to
/// its own file where that lies beside the .sim, else to a file of the .sim's name. Names of files
/// that would not be found from a new folder become absolute. Throws ConfigError, which says what
/// the kind of file cannot hold.
Saving plan_saving(const Plan& plan, const PlanFiles& source, const std::filesystem::path& target);

/// All of them, or none: each is as it was, then. Throws ConfigError that says why not.
void write_all_files(const std::vector<FileText>& texts);

/// The picture of the floor, looked for as a run does; empty when there is none.
std::filesystem::path texture_file(const Plan& plan, const PlanFiles& files);

}  // namespace eyebridge::gui
