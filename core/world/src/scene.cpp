#include "eyebridge/world/scene.hpp"

#include <utility>

#include "convex.hpp"

namespace eyebridge::world {

BodyShape shape_of(ObjectKind kind) {
  if (kind == ObjectKind::Ball) return BodyShape::Ball;
  return kind == ObjectKind::Can ? BodyShape::Can : BodyShape::Polygon;
}

BodyView view_of(const ObjectSpec& object, std::uint32_t id) {
  BodyView view{
      id, shape_of(object.kind), object.pose, object.outer_radius(), object.height, object.colour};
  if (std::vector<Vec2> corners = corners_of(object); !corners.empty()) {
    view.corners = std::make_shared<const std::vector<Vec2>>(std::move(corners));
  }
  return view;
}

double rim_distance(const BodyView& body, Vec2 p) {
  const Vec2 place = body.pose.position();
  if (!body.corners) return norm(p - place) - body.radius;
  const Vec2 forward = Heading::from_angle(body.pose.theta).forward();
  return distance_to(Convex(Outline(*body.corners), place, forward), p);
}

}  // namespace eyebridge::world
