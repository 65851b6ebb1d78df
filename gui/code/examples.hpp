#pragma once

#include <QString>
#include <vector>

namespace eyebridge::gui {

/// A robot program that comes with EyeBridge.
struct Example {
  QString name;  ///< Relative to the folder of examples.
  QString path;
};

/// The robot programs in a folder and those below it, by name: sources that include eyebot.h or
/// eyebot++.h and have a main(), and Python files that import eye. None when there is no folder.
std::vector<Example> find_examples(const QString& folder);

}  // namespace eyebridge::gui
