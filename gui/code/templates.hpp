#pragma once

#include <QString>
#include <vector>

#include "code/language.hpp"

namespace eyebridge::gui {

/// A program to begin with.
struct Template {
  Language language;
  const char* name;  ///< Of the file, until it is saved.
  const char* text;
};

/// One for each language. They build and run as they are, in any world.
const std::vector<Template>& templates();

}  // namespace eyebridge::gui
