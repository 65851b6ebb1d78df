#include "code/examples.hpp"

#include <QDir>
#include <QDirIterator>
#include <QRegularExpression>
#include <algorithm>

#include "code/text_file.hpp"

namespace eyebridge::gui {
namespace {

bool is_robot_program(const QString& path) {
  static const QRegularExpression kMain(R"(\bmain\s*\()");
  static const QRegularExpression kImport(R"(^\s*(from|import) eye\b)",
                                          QRegularExpression::MultilineOption);
  TextFile file;
  if (!read_text(path, file).isEmpty()) return false;
  if (path.endsWith(".py")) return kImport.match(file.text).hasMatch();
  const bool includes = file.text.contains("eyebot.h") || file.text.contains("eyebot++.h");
  return includes && kMain.match(file.text).hasMatch();
}

}  // namespace

std::vector<Example> find_examples(const QString& folder) {
  std::vector<Example> found;
  if (folder.isEmpty()) return found;
  QDirIterator files(folder, {"*.c", "*.cpp", "*.py"}, QDir::Files, QDirIterator::Subdirectories);
  while (files.hasNext()) {
    const QString path = files.next();
    if (is_robot_program(path)) found.push_back({QDir(folder).relativeFilePath(path), path});
  }
  // Those in no folder of their own first: they are the simplest.
  std::ranges::sort(found, [](const Example& a, const Example& b) {
    const bool in_folder = a.name.contains('/');
    return in_folder != b.name.contains('/') ? !in_folder : a.name < b.name;
  });
  return found;
}

}  // namespace eyebridge::gui
