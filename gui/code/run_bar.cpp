#include "code/run_bar.hpp"

#include <QAction>
#include <QDir>
#include <QEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QIcon>
#include <QPainter>
#include <QPolygonF>
#include <QSettings>
#include <utility>

namespace eyebridge::gui {
namespace {

const QString kWorldKey = "code/world";
const QString kFastKey = "code/fast";
const QString kWindowsKey = "code/windows";
const QStringList kWorldFiles{"*.maz", "*.wld", "*.sim", "*.p", "*.robi"};

}  // namespace

RunBar::RunBar(const CodeSettings& settings, QWidget* parent)
    : QToolBar(parent),
      folder_(settings.worlds),
      worlds_(new QComboBox(this)),
      fast_(new QCheckBox(tr("Virtual time"), this)),
      windows_(new QCheckBox(tr("Windows"), this)) {
  setObjectName("run_bar");
  setWindowTitle(tr("Run bar"));
  worlds_->setAccessibleName(tr("World"));
  worlds_->setToolTip(tr("The world that the program drives in"));
  worlds_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  worlds_->addItem(tr("Empty room"), QString());
  const QDir worlds(folder_);
  const QStringList usual = kWorldFiles.mid(0, 3);
  if (!folder_.isEmpty()) {
    for (const QFileInfo& file : worlds.entryInfoList(usual, QDir::Files, QDir::Name)) {
      worlds_->addItem(file.fileName(), file.absoluteFilePath());
    }
  }
  fast_->setToolTip(tr("As fast as the computer can, the same every time (--fast)"));
  windows_->setToolTip(tr("The robot's panel and its world (--gui)"));
  const QSettings kept;
  const QString last = kept.value(kWorldKey).toString();
  if (!settings.world.isEmpty()) {
    choose_world(settings.world);
  } else if (QFileInfo(last).isFile()) {
    choose_world(last);
  }
  fast_->setChecked(kept.value(kFastKey, false).toBool());
  windows_->setChecked(kept.value(kWindowsKey, true).toBool());
}

RunBar::~RunBar() {
  QSettings kept;
  kept.setValue(kWorldKey, worlds_->currentData());
  kept.setValue(kFastKey, fast_->isChecked());
  kept.setValue(kWindowsKey, windows_->isChecked());
}

void RunBar::add_parts(QAction& run, QAction& stop) {
  run_ = &run;
  stop_ = &stop;
  paint_actions();
  setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  addAction(run_);
  addAction(stop_);
  addSeparator();
  addWidget(worlds_);
  addWidget(fast_);
  addWidget(windows_);
}

void RunBar::paint_actions() {
  // A triangle and a square, in the colour of the words beside them.
  constexpr int kSize = 16;
  const auto drawn = [&](const QPolygonF& shape) {
    QIcon icon;
    for (const auto& [mode, group] : {std::pair{QIcon::Normal, QPalette::Active},
                                      std::pair{QIcon::Disabled, QPalette::Disabled}}) {
      QPixmap picture(QSize(kSize, kSize) * devicePixelRatio());
      picture.setDevicePixelRatio(devicePixelRatio());
      picture.fill(Qt::transparent);
      QPainter painter(&picture);
      painter.setRenderHint(QPainter::Antialiasing);
      painter.setPen(Qt::NoPen);
      painter.setBrush(palette().color(group, QPalette::ButtonText));
      painter.drawPolygon(shape);
      icon.addPixmap(picture, mode);
    }
    return icon;
  };
  run_->setIcon(drawn(QPolygonF({{3, 2}, {14, 8}, {3, 14}})));
  stop_->setIcon(drawn(QPolygonF(QRectF(3, 3, 10, 10))));
}

void RunBar::changeEvent(QEvent* event) {
  QToolBar::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && run_ != nullptr) paint_actions();
}

RunChoice RunBar::choice() const {
  return {worlds_->currentData().toString(), fast_->isChecked(), windows_->isChecked()};
}

void RunBar::choose_world(const QString& path) {
  const QString full = path.isEmpty() ? path : QFileInfo(path).absoluteFilePath();
  int index = worlds_->findData(full);
  if (index < 0) {
    worlds_->addItem(QFileInfo(full).fileName(), full);
    index = worlds_->count() - 1;
    worlds_->setItemData(index, full, Qt::ToolTipRole);
  }
  worlds_->setCurrentIndex(index);
}

void RunBar::ask_for_world() {
  const QString now = worlds_->currentData().toString();
  auto* const dialog =
      new QFileDialog(this, tr("World"), now.isEmpty() ? folder_ : QFileInfo(now).path(),
                      tr("Worlds (%1)").arg(kWorldFiles.join(' ')));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this,
          [this](const QString& path) { choose_world(path); });
  dialog->open();
}

}  // namespace eyebridge::gui
