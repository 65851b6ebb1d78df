#include "code/code_settings.hpp"

#include <QDir>
#include <QStandardPaths>

#include "eyebridge/base/own_place.hpp"

namespace eyebridge::gui {
CodeSettings CodeSettings::defaults() {
  const QDir share(QString::fromStdString(share_folder().string()));
  const QDir root(share.absoluteFilePath("../.."));
  const auto place = [](QStandardPaths::StandardLocation kind, const char* name) {
    return QDir(QStandardPaths::writableLocation(kind)).filePath(QString("eyebridge/") + name);
  };
  CodeSettings settings;
  settings.eyebridge = QDir::cleanPath(root.absoluteFilePath("bin/eyebridge"));
  settings.c_compiler = QDir::cleanPath(root.absoluteFilePath("bin/eyebridge-cc"));
  settings.cpp_compiler = QDir::cleanPath(root.absoluteFilePath("bin/eyebridge-c++"));
  settings.examples = share.absoluteFilePath("examples");
  settings.worlds = share.absoluteFilePath("worlds");
  settings.drafts = place(QStandardPaths::GenericDataLocation, "drafts");
  settings.builds = place(QStandardPaths::GenericCacheLocation, "builds");
  return settings;
}

}  // namespace eyebridge::gui
