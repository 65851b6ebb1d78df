#include "parts/save_picture.hpp"

#include <QBuffer>
#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <utility>

#include "parts/whole_file.hpp"

namespace eyebridge::gui {

bool save_picture(const QImage& picture, const QString& path) {
  const QByteArray suffix = QFileInfo(path).suffix().toLatin1();
  QBuffer bytes;
  const char* const format = suffix.isEmpty() ? "png" : suffix.constData();
  return bytes.open(QIODevice::WriteOnly) && picture.save(&bytes, format) &&
         write_whole(path, bytes.data()).isEmpty();
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
