#include "widgets/recent_files.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QMenu>
#include <QSettings>

namespace eyebridge::gui {
namespace {

constexpr int kMostRecentFiles = 10;

QString key_of(const QString& kind) { return kind + "/recent"; }

}  // namespace

QStringList recent_files(const QString& kind) {
  return QSettings().value(key_of(kind)).toStringList();
}

void remember_file(const QString& kind, const QString& path) {
  const QString whole = QFileInfo(path).absoluteFilePath();
  QStringList recent = recent_files(kind);
  if (!recent.isEmpty() && recent.front() == whole) return;
  recent.removeAll(whole);
  recent.prepend(whole);
  QSettings().setValue(key_of(kind), recent.mid(0, kMostRecentFiles));
}

void offer_recent_files(QMenu& menu, const QStringList& kinds,
                        const std::function<void(const QString&)>& open) {
  QObject::connect(&menu, &QMenu::aboutToShow, &menu, [&menu, kinds, open] {
    menu.clear();
    for (const QString& kind : kinds) {
      if (!menu.isEmpty()) menu.addSeparator();
      for (const QString& path : recent_files(kind)) {
        if (!QFileInfo::exists(path)) continue;
        QAction* const action = menu.addAction(QDir::toNativeSeparators(path).replace('&', "&&"));
        QObject::connect(action, &QAction::triggered, &menu, [open, path] { open(path); });
      }
    }
    if (!menu.isEmpty()) return;
    menu.addAction(QCoreApplication::translate("eyebridge::gui::recent_files", "None yet"))
        ->setEnabled(false);
  });
}

}  // namespace eyebridge::gui
