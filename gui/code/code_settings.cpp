#include "code/code_settings.hpp"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

#include <dlfcn.h>

#include "eyebridge/files/load.hpp"

namespace eyebridge::gui {
namespace {

/// The folder above that of the file that this code is in: lib/ and bin/ are in it.
QDir prefix() {
  static const char here = 0;
  Dl_info file{};
  if (dladdr(&here, &file) == 0) return QDir();
  QDir folder = QFileInfo(QFileInfo(file.dli_fname).canonicalFilePath()).absoluteDir();
  folder.cdUp();
  return folder;
}

/// Where it is installed, else where the sources are.
QString data_folder(const QDir& prefix, const QString& name, const QString& in_sources) {
  const QString installed = prefix.absoluteFilePath("share/eyebridge/" + name);
  return QFileInfo(installed).isDir() ? installed : in_sources;
}

}  // namespace

CodeSettings CodeSettings::defaults() {
  const QDir root = prefix();
  const QString worlds = QString::fromStdString(files::SearchPlaces::builtin_worlds().string());
  const QDir sources = QFileInfo(worlds).absoluteDir();
  const auto place = [](QStandardPaths::StandardLocation kind, const char* name) {
    return QDir(QStandardPaths::writableLocation(kind)).filePath(QString("eyebridge/") + name);
  };
  CodeSettings settings;
  settings.eyebridge = root.absoluteFilePath("bin/eyebridge");
  settings.c_compiler = root.absoluteFilePath("bin/eyebridge-cc");
  settings.cpp_compiler = root.absoluteFilePath("bin/eyebridge-c++");
  settings.examples = data_folder(root, "examples", sources.absoluteFilePath("examples"));
  settings.worlds = data_folder(root, "worlds", worlds);
  settings.drafts = place(QStandardPaths::GenericDataLocation, "drafts");
  settings.builds = place(QStandardPaths::GenericCacheLocation, "builds");
  return settings;
}

}  // namespace eyebridge::gui
