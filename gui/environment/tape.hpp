#pragma once

#include <QString>

#include "plan/viewport.hpp"

class QPainter;

namespace eyebridge::gui {

/// A measuring tape on the floor.
struct Tape {
  Vec2 from;
  Vec2 to;
};

/// "1234 mm, 45.0°": its length, and the direction of its end, counter-clockwise from +x.
QString tape_text(const Tape& tape);
/// Where something shall stand and look: a cross and an arrow.
void paint_place(QPainter& painter, const Viewport& view, const Pose& place);
void paint_tape(QPainter& painter, const Viewport& view, const Tape& tape);

}  // namespace eyebridge::gui
