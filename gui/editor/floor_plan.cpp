#include "editor/floor_plan.hpp"

#include <QCoreApplication>
#include <QPainter>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge::gui {
namespace {

class FloorPlanText {
  Q_DECLARE_TR_FUNCTIONS(FloorPlan)
};

constexpr const char* kName = "floor plan";

files::GreyPicture greys_of(const QImage& picture) {
  QImage paper(picture.size(), QImage::Format_RGB32);
  paper.fill(Qt::white);
  QPainter(&paper).drawImage(0, 0, picture);
  const QImage greys = paper.convertToFormat(QImage::Format_Grayscale8);
  files::GreyPicture out{greys.width(), greys.height(), {}};
  for (int y = 0; y < greys.height(); ++y) {
    const uchar* const row = greys.constScanLine(y);
    out.greys.insert(out.greys.end(), row, row + greys.width());
  }
  return out;
}

}  // namespace

files::FloorPlan read_floor_plan(const QImage& picture, const files::FloorPlanOptions& options) {
  if (picture.isNull()) {
    throw ConfigError({kName, 0, 0},
                      FloorPlanText::tr("no picture: expected PNG, JPEG or BMP").toStdString());
  }
  return files::read_floor_plan(greys_of(picture), options, kName);
}

}  // namespace eyebridge::gui
