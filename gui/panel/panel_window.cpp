#include "panel/panel_window.hpp"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QVBoxLayout>

#include "keys.hpp"

namespace eyebridge::gui {
namespace {

constexpr int kLcdRefresh_ms = 33;  // as fast as programs that show pictures

QString colour_name(Rgb colour) { return QColor(colour.r, colour.g, colour.b).name(); }

void show_look(QPushButton& key, const robios::SoftKeyLook& look) {
  // An ampersand would name a shortcut.
  QString label = QString::fromStdString(look.label).replace('&', "&&");
  key.setText(label);
  key.setStyleSheet(label.isEmpty() ? QString()
                                    : QString("color: %1; background-color: %2;")
                                          .arg(colour_name(look.ink), colour_name(look.paper)));
}

}  // namespace

PanelWindow::PanelWindow(const robios::PanelStart& start)
    : screen_(*start.screen), presses_(*start.keys) {
  setWindowTitle(QString::fromStdString(start.title));
  auto* column = new QVBoxLayout(this);
  lcd_ = new LcdWidget(screen_, presses_, this);
  column->addWidget(lcd_, 1);
  auto* row = new QHBoxLayout;
  column->addLayout(row);
  for (int i = 0; i < robios::kSoftKeys; ++i) {
    auto* key = new QPushButton(this);
    key->setObjectName(QString("key%1").arg(i + 1));
    key->setToolTip(tr("KEY%1 (keyboard: %1 or F%1)").arg(i + 1));
    key->setFocusPolicy(Qt::NoFocus);  // Space and Return are the program's
    connect(key, &QPushButton::pressed, this, [this, i] { press(i); });
    row->addWidget(key);
    keys_.at(static_cast<std::size_t>(i)) = key;
  }
  end_ = new QLabel(this);
  end_->hide();
  column->addWidget(end_);
  presses_.set_window(true);
  connect(&timer_, &QTimer::timeout, this, [this] { refresh(); });
  timer_.start(kLcdRefresh_ms);
  refresh();
}

PanelWindow::~PanelWindow() { presses_.set_window(false); }

void PanelWindow::refresh() {
  if (!lcd_->refresh() && are_labelled_) return;
  are_labelled_ = true;
  const robios::ScreenShot shot = screen_.shot();
  for (std::size_t i = 0; i < keys_.size(); ++i) show_look(*keys_.at(i), shot.keys.at(i));
}

void PanelWindow::press(int index) { presses_.press(1 << index); }

void PanelWindow::tell_end(const QString& how) {
  refresh();
  end_->setText(how);
  end_->show();
  for (QPushButton* key : keys_) key->setEnabled(false);
}

void PanelWindow::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  if (!event->isAutoRepeat()) {
    for (int i = 0; i < robios::kSoftKeys; ++i) {
      if (key != Qt::Key_1 + i && key != Qt::Key_F1 + i) continue;
      press(i);
      return;
    }
  }
  QWidget::keyPressEvent(event);
}

}  // namespace eyebridge::gui
