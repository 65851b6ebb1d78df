#include "panel/speaker.hpp"

#include <QFileInfo>
#include <QPainter>

#include "eyebridge/hal/sound_file.hpp"

namespace eyebridge::gui {
namespace {

// In virtual time a second may pass in a millisecond: nobody would see the light.
constexpr int kLeastLit_ms = 400;

}  // namespace

Speaker::Speaker(const hal::DeviceNotes& notes, QWidget* parent)
    : QWidget(parent), notes_(notes), times_(notes) {
  setAccessibleName(tr("Loudspeaker"));
  setToolTip(tr("The robot's loudspeaker: lights while it plays"));
  refresh();
}

void Speaker::take(const hal::SoundNote& sound) {
  heard_ = sound.count;
  begin_ = times_.time_of(sound.stamp);
  since_.start();
  if (sound.file.empty()) {
    text_ = tr("%1 Hz, %2 s").arg(sound.frequency, 0, 'f', 0).arg(sound.length, 0, 'f', 2);
    end_ = begin_ + from_seconds(sound.length);
    is_read_ = true;
  } else {
    text_ = QFileInfo(QString::fromStdString(sound.file)).fileName();
    is_read_ = false;
    read_length(sound);
  }
  setAccessibleDescription(text_);
}

void Speaker::read_length(const hal::SoundNote& sound) {
  // Not here: it may be long, and on a slow disk.
  if (!reader_) reader_ = std::make_unique<Worker>();
  newest_ = sound.count;
  reader_->give([this, file = sound.file, count = sound.count] {
    if (count != newest_) return;
    const Result<double> played = hal::sound_length(file);
    const auto length = played ? std::optional(*played) : std::nullopt;
    QMetaObject::invokeMethod(
        this, [this, count, length] { show_length(count, length); }, Qt::QueuedConnection);
  });
}

void Speaker::show_length(std::uint64_t sound, std::optional<double> length) {
  if (sound != heard_) return;  // another one came meanwhile
  is_read_ = true;
  // A player may know formats that we do not.
  if (length) text_ = tr("%1, %2 s").arg(text_).arg(*length, 0, 'f', 2);
  end_ = begin_ + from_seconds(length.value_or(0.0));
  setAccessibleDescription(text_);
  update();
}

void Speaker::refresh() {
  times_.look();
  const hal::SoundNote sound = notes_.sound();
  const bool is_new = sound.count != heard_;
  if (is_new) take(sound);
  const bool lit = heard_ != 0 && (since_.elapsed() < kLeastLit_ms ||
                                   (is_lit_ && (!is_read_ || notes_.now() < end_)));
  if (!is_new && lit == is_lit_) return;
  is_lit_ = lit;
  update();
}

void Speaker::put_out() {
  is_lit_ = false;
  update();
}

QSize Speaker::sizeHint() const {
  const int line = fontMetrics().height();
  return {line + 8 + fontMetrics().horizontalAdvance("20000 Hz, 60.00 s"), line + 6};
}

void Speaker::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double edge = fontMetrics().height();
  const double top = (height() - edge) / 2;
  const QColor off = palette().color(QPalette::Disabled, QPalette::WindowText);
  const QColor on = palette().color(QPalette::Highlight);
  painter.setPen(Qt::NoPen);
  painter.setBrush(is_lit_ ? on : off);
  painter.drawPolygon(QPolygonF({{2, top + edge * 0.35},
                                 {2 + edge * 0.2, top + edge * 0.35},
                                 {2 + edge * 0.5, top + edge * 0.1},
                                 {2 + edge * 0.5, top + edge * 0.9},
                                 {2 + edge * 0.2, top + edge * 0.65},
                                 {2, top + edge * 0.65}}));
  if (is_lit_) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(on, 1.5));
    for (const double radius : {0.2, 0.4}) {
      const QPointF centre(2 + edge * 0.55, top + edge * 0.5);
      const QRectF arc(centre - QPointF(radius, radius) * edge, QSizeF(2, 2) * radius * edge);
      painter.drawArc(arc, -45 * 16, 90 * 16);
    }
  }
  painter.setPen(is_lit_ ? palette().color(QPalette::WindowText) : off);
  painter.drawText(rect().adjusted(static_cast<int>(edge) + 8, 0, 0, 0),
                   Qt::AlignVCenter | Qt::AlignLeft, text_);
}

}  // namespace eyebridge::gui
