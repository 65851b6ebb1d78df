#include "hand/direction_sign.hpp"

#include <QFontMetrics>
#include <QPainter>
#include <algorithm>

namespace eyebridge::gui {
namespace {

// Shares of the sign's height.
constexpr double kArrowShare = 0.5;
constexpr double kHeadlineShare = 0.24;
constexpr double kLineShare = 0.13;

}  // namespace

DirectionSign::DirectionSign(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Where to go"));
}

void DirectionSign::show_words(const HandWords& words) {
  if (words == words_) return;
  words_ = words;
  setAccessibleDescription(words.headline + ". " + words.detail + ". " + words.speed);
  update();
}

QRect DirectionSign::headline_place() const {
  const int top = static_cast<int>(kArrowShare * height());
  return {width() / 30, top, width() - width() / 15, static_cast<int>(kHeadlineShare * height())};
}

QFont DirectionSign::fitted(const QString& text, const QRect& place) const {
  QFont big = font();
  big.setBold(true);
  big.setPixelSize(std::max(8, place.height() * 3 / 4));
  const int wide = QFontMetrics(big).horizontalAdvance(text);
  if (wide > place.width()) {
    big.setPixelSize(std::max(8, big.pixelSize() * place.width() / wide));
  }
  return big;
}

int DirectionSign::letter_height() const {
  return fitted(words_.headline, headline_place()).pixelSize();
}

void DirectionSign::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  const QColor ink = palette().color(QPalette::Text);
  const double room = std::min<double>(width(), kArrowShare * height());
  painter.save();
  painter.translate(width() / 2.0, kArrowShare * height() / 2);
  painter.scale(0.45 * room, 0.45 * room);
  painter.setPen(QPen(ink, 0.22, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
  painter.setBrush(ink);
  paint_arrow(painter, words_.arrow);
  painter.restore();
  painter.setPen(ink);
  const auto write = [&](const QString& text, const QRect& place) {
    painter.setFont(fitted(text, place));
    painter.drawText(place, Qt::AlignCenter, text);
  };
  QRect line = headline_place();
  write(words_.headline, line);
  line.setTop(line.bottom());
  line.setHeight(static_cast<int>(kLineShare * height()));
  write(words_.detail, line);
  line.translate(0, line.height());
  write(words_.speed, line);
}

}  // namespace eyebridge::gui
