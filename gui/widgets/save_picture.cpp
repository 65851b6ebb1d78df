#include "widgets/save_picture.hpp"

#include <QBuffer>
#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <utility>

#include "widgets/ask_for_file.hpp"
#include "widgets/whole_file.hpp"

namespace eyebridge::gui {

bool save_picture(const QImage& picture, const QString& path) {
  const QByteArray suffix = QFileInfo(path).suffix().toLatin1();
  QBuffer bytes;
  const char* const format = suffix.isEmpty() ? "png" : suffix.constData();
  return bytes.open(QIODevice::WriteOnly) && picture.save(&bytes, format) &&
         write_whole(path, bytes.data()).isEmpty();
}

void ask_where_to_save_picture(QWidget& window, const QString& title, const QString& name,
                               std::function<void(const QString&)> save) {
  const QString filter =
      QCoreApplication::translate("eyebridge::gui::save_picture", "Pictures (*.png *.jpg)");
  ask_where_to_save(window, title, name, filter, std::move(save)).setDefaultSuffix("png");
}

}  // namespace eyebridge::gui
