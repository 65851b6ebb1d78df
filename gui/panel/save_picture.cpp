#include "panel/save_picture.hpp"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QSaveFile>
#include <utility>

namespace eyebridge::gui {

bool save_picture(const QImage& picture, const QString& path) {
  const QByteArray suffix = QFileInfo(path).suffix().toLatin1();
  QSaveFile file(path);
  const char* const format = suffix.isEmpty() ? "png" : suffix.constData();
  return file.open(QIODevice::WriteOnly) && picture.save(&file, format) && file.commit();
}

void ask_where_to_save(QWidget& window, const QString& title, const QString& name,
                       std::function<void(const QString&)> save) {
  auto* dialog = new QFileDialog(
      &window, title, QString(),
      QCoreApplication::translate("eyebridge::gui::save_picture", "Pictures (*.png *.jpg)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix("png");
  dialog->selectFile(name);
  QObject::connect(dialog, &QFileDialog::fileSelected, &window,
                   [save = std::move(save)](const QString& path) { save(path); });
  dialog->open();
}

}  // namespace eyebridge::gui
