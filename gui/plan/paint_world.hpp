#pragma once

#include <QColor>
#include <span>
#include <vector>

#include "eyebridge/hal/environment.hpp"
#include "plan/mirror.hpp"
#include "plan/viewport.hpp"

class QImage;
class QPainter;

namespace eyebridge::gui {

QColor colour_of(Rgb colour);

/// Floor, its texture unless null, markers and walls: what does not move.
void paint_ground(QPainter& painter, const Viewport& view, const world::WorldModel& model,
                  const QImage& texture);
void paint_marker(QPainter& painter, const Viewport& view, const world::Marker& marker);
void paint_wall(QPainter& painter, const Viewport& view, const world::Wall& wall);
/// A ball, can, box or polygon.
void paint_thing(QPainter& painter, const Viewport& view, const world::BodyView& body);
/// A robot with its number and a marker in front.
void paint_robot(QPainter& painter, const Viewport& view, const world::BodyView& body,
                 const QString& number, bool is_chosen, bool is_stalled);
/// Things and robots, these with their numbers and a marker in front. `chosen` has a
/// ring; a robot that is stalled has one in red. A submarine has a gauge of its depth beside it.
void paint_bodies(QPainter& painter, const Viewport& view, const hal::WorldLook& look,
                  std::optional<std::size_t> chosen);
void paint_rays(QPainter& painter, const Viewport& view, std::span<const SensorRay> rays,
                const QColor& colour);
/// What a LIDAR sees, as a dot where each ray ends: a hundred of them cost less than one's rays.
void paint_scan(QPainter& painter, const Viewport& view, std::span<const SensorRay> rays,
                const QColor& colour);
/// What the robot's camera sees on the floor, up to `reach` metres: filled where it is the chosen
/// one's.
void paint_camera_cone(QPainter& painter, const Viewport& view, const hal::RobotLook& robot,
                       double reach, bool is_chosen);
/// Red on the rim for each bumper that something touches, in the order of the model.
void paint_bumpers(QPainter& painter, const Viewport& view, const hal::RobotLook& robot,
                   const std::vector<bool>& touched);

}  // namespace eyebridge::gui
