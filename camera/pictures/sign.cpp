#include "eyebridge/camera/sign.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "eyebridge/base/units.hpp"
#include "pictures/canvas.hpp"

namespace eyebridge::camera {
namespace {

// The sheet is 4 wide and 2.8 high, in units of its own; with the canvas's border it is 4 : 3.
constexpr Vec2 kSheet{4.0, 2.8};
constexpr Vec2 kMiddle{2.0, 1.8};
constexpr double kShaft = 0.28;
constexpr Rgb kPaper{255, 255, 255};
constexpr Rgb kSignInk{20, 20, 20};
constexpr Rgb kGo{0, 110, 60};
constexpr Rgb kHalt{190, 30, 30};

class Painter {
 public:
  explicit Painter(int longest_side) : canvas_({0, 0}, kSheet, longest_side, kPaper) {}

  /// A thick line through `points` about the middle, which ends in a tip.
  void arrow(const std::vector<Vec2>& points) {
    std::vector<Vec2> shaft;
    for (const Vec2 point : points) shaft.push_back(kMiddle + point);
    const Vec2 last = shaft.back() - shaft[shaft.size() - 2];
    const Vec2 along = (1.0 / norm(last)) * last;
    const Vec2 across{-along.y, along.x};
    canvas_.path(shaft, canvas_.to_pixels(kShaft), kGo);
    const Vec2 end = shaft.back();
    const Vec2 tip[] = {end + 0.5 * along, end + 0.38 * across, end - 0.38 * across};
    canvas_.polygon(tip, kGo);
  }

  /// A part of a circle about `centre`, both angles in degrees, `side` +1 or -1 from left to right.
  void arc(Vec2 centre, double radius, double from, double to, double side) {
    constexpr int kPieces = 24;
    std::vector<Vec2> points;
    for (int i = 0; i <= kPieces; ++i) {
      const Heading h = Heading::from_angle(deg_to_rad(from + (to - from) * i / kPieces));
      points.push_back({side * (centre.x + radius * h.cos), centre.y + radius * h.sin});
    }
    arrow(points);
  }

  void bar() {
    canvas_.fill_rectangle(kMiddle + Vec2{-0.6, -0.6}, kMiddle + Vec2{0.6, 0.6}, kHalt);
  }
  void word(Vec2 at, const std::string& text, double size, Rgb colour) {
    canvas_.text(at, text, canvas_.to_pixels(size), colour);
  }
  [[nodiscard]] Frame picture() const { return canvas_.picture(); }

 private:
  Canvas canvas_;
};

/// As big as it has room, at most `largest`: bold letters and digits are 0.56 of the size wide.
double size_of(const std::string& text, double largest) {
  constexpr double kRoom = 3.9;
  return std::min(largest, kRoom / (0.56 * std::max(1.0, static_cast<double>(text.size()))));
}

void draw_arrow(Painter& painter, Arrow arrow) {
  switch (arrow) {
    case Arrow::None:
      return painter.bar();
    case Arrow::Forward:
      return painter.arrow({{0.0, -0.8}, {0.0, 0.4}});
    case Arrow::Backward:
      return painter.arrow({{0.0, 0.8}, {0.0, -0.4}});
    case Arrow::TurnLeft:
      return painter.arc({0.0, -0.1}, 0.62, -40.0, 190.0, 1.0);
    case Arrow::TurnRight:
      return painter.arc({0.0, -0.1}, 0.62, -40.0, 190.0, -1.0);
    case Arrow::CurveLeft:
      return painter.arc({-0.8, -0.8}, 1.2, 0.0, 75.0, 1.0);
    case Arrow::CurveRight:
      return painter.arc({-0.8, -0.8}, 1.2, 0.0, 75.0, -1.0);
    case Arrow::BackLeft:
      return painter.arc({-0.8, 0.8}, 1.2, 0.0, -75.0, 1.0);
    case Arrow::BackRight:
      return painter.arc({-0.8, 0.8}, 1.2, 0.0, -75.0, -1.0);
    case Arrow::Lost:
      return painter.word(kMiddle, "?", 1.8, kHalt);
  }
}

}  // namespace

Arrow arrow_for(double along, double turn) {
  if (along == 0.0 && turn == 0.0) return Arrow::None;
  if (turn == 0.0) return along > 0.0 ? Arrow::Forward : Arrow::Backward;
  const bool counter_clockwise = turn > 0.0;
  if (along == 0.0) return counter_clockwise ? Arrow::TurnLeft : Arrow::TurnRight;
  if (along > 0.0) return counter_clockwise ? Arrow::CurveLeft : Arrow::CurveRight;
  // Backward, a heading that turns counter-clockwise takes the robot to its right.
  return counter_clockwise ? Arrow::BackRight : Arrow::BackLeft;
}

Frame draw_sign(const Sign& sign, int longest_side) {
  Painter painter(longest_side);
  draw_arrow(painter, sign.arrow);
  painter.word({0.5 * kSheet.x, 0.6}, sign.headline, size_of(sign.headline, 0.62), kSignInk);
  painter.word({0.5 * kSheet.x, 0.15}, sign.detail, size_of(sign.detail, 0.26), kSignInk);
  return painter.picture();
}

}  // namespace eyebridge::camera
