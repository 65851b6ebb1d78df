#pragma once

#include <QImage>
#include <string>

#include <gtest/gtest.h>

namespace eyebridge::gui::testing {

/// Whether `seen` is the picture that a person has looked at, `tests/gui/pictures/NAME.png` (or
/// `qt-6.8/NAME.png`, where this version of Qt has its own): of the same size, and at most one
/// pixel of 200 differs by more than 48 of 255 in a colour (fonts are drawn a little differently by
/// each version of FreeType). Where it is not, what was seen goes to `build/gui/NAME.png`. With
/// EYEBRIDGE_TEST_ACCEPT set it is written instead, and is to be looked at.
::testing::AssertionResult looks_as(const QImage& seen, const std::string& name);

}  // namespace eyebridge::gui::testing
