#include "hand/uncertainty.hpp"

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "eyebridge/base/units.hpp"

namespace eyebridge::gui {
namespace {

// Of two dimensions: the quantile 0.95 of chi squared with two degrees of freedom is 5.991.
constexpr double kDeviations = 2.4477;
constexpr double kDeviationsOfOne = 2.0;
constexpr double kLeastPixels = 3.0;
constexpr double kWedgePixels = 28.0;

double deviation(double variance) {
  return variance > 0.0 && std::isfinite(variance) ? std::sqrt(variance) : 0.0;
}

}  // namespace

UncertaintyEllipse ellipse_of(const PoseCovariance& covariance) {
  const double xx = covariance[0];
  const double xy = covariance[1];
  const double yy = covariance[4];
  if (!std::isfinite(xx + xy + yy) || xx < 0.0 || yy < 0.0) return {};
  // Eigenvalues of a symmetric 2 x 2 matrix.
  const double mean = (xx + yy) / 2;
  const double half = std::hypot((xx - yy) / 2, xy);
  return {kDeviations * deviation(mean + half), kDeviations * deviation(mean - half),
          0.5 * std::atan2(2 * xy, xx - yy)};
}

void paint_uncertainty(QPainter& painter, const Viewport& view, const Pose& pose,
                       const PoseCovariance& covariance) {
  const UncertaintyEllipse ellipse = ellipse_of(covariance);
  const auto pixels = [&](double metres) {
    return std::max(kLeastPixels, metres * view.pixels_per_metre());
  };
  const QColor colour(200, 0, 160);
  QColor inside = colour;
  inside.setAlpha(50);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(view.to_pixel(pose.position()));
  painter.setPen(QPen(colour, 1.5));
  painter.setBrush(inside);
  painter.save();
  painter.rotate(-rad_to_deg(ellipse.heading));  // the view's y points down
  painter.drawEllipse(QPointF(0, 0), pixels(ellipse.major), pixels(ellipse.minor));
  painter.restore();
  const double spread = std::min(180.0, rad_to_deg(kDeviationsOfOne * deviation(covariance[8])));
  const double reach = pixels(ellipse.major) + kWedgePixels;
  constexpr double kSixteenths = 16.0;  // of a degree: what Qt counts angles in
  painter.drawPie(QRectF(-reach, -reach, 2 * reach, 2 * reach),
                  static_cast<int>(kSixteenths * (rad_to_deg(pose.theta) - spread)),
                  static_cast<int>(kSixteenths * 2 * spread));
  painter.restore();
}

QString pose_text(const Pose& pose, const PoseCovariance& covariance) {
  const auto spread = [&](std::size_t i) {
    return kDeviationsOfOne * deviation(covariance.at(4 * i));
  };
  return QCoreApplication::translate("eyebridge::gui::HandWindow",
                                     "x %1 ± %2 mm, y %3 ± %4 mm, %5 ± %6°")
      .arg(m_to_mm(pose.x), 0, 'f', 0)
      .arg(m_to_mm(spread(0)), 0, 'f', 0)
      .arg(m_to_mm(pose.y), 0, 'f', 0)
      .arg(m_to_mm(spread(1)), 0, 'f', 0)
      .arg(rad_to_deg(pose.theta), 0, 'f', 1)
      .arg(rad_to_deg(spread(2)), 0, 'f', 1);
}

}  // namespace eyebridge::gui
