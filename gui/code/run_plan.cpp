#include "code/run_plan.hpp"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>

#include "code/text_file.hpp"

namespace eyebridge::gui {
namespace {

QStringList included_by(const QString& path) {
  static const QRegularExpression kInclude(R"re(^\s*#\s*include\s*"([^"]+)")re",
                                           QRegularExpression::MultilineOption);
  TextFile file;
  QStringList names;
  if (!read_text(path, file).isEmpty()) return names;
  for (auto found = kInclude.globalMatch(file.text); found.hasNext();) {
    names << found.next().captured(1);
  }
  return names;
}

bool is_header(const QString& path) {
  const QString extension = QFileInfo(path).suffix();
  return extension.startsWith('h');
}

Step build_step(const ProgramSource& source, const QString& home, const QString& binary,
                const CodeSettings& settings) {
  QStringList words;
  const QFileInfo file(source.file);
  if (source.is_classic) words << "--classic";
  // By its name alone, so that messages are short.
  words << "-g"
        << "-fdiagnostics-color=never"
        << "-fmessage-length=0"
        << "-iquote" << home << file.fileName() << other_sources(source.file, home) << "-o"
        << binary;
  const bool is_c = source.language == Language::C;
  return {Step::Kind::Build, is_c ? settings.c_compiler : settings.cpp_compiler, words,
          file.absolutePath()};
}

}  // namespace

QStringList other_sources(const QString& file, const QString& home) {
  const QDir folder(home);
  QStringList sources;
  QStringList todo = included_by(file);
  QStringList seen;
  while (!todo.isEmpty()) {
    const QString name = todo.takeFirst();
    const QFileInfo header(folder, name);
    if (seen.contains(name) || !header.isFile()) continue;
    seen << name;
    todo << included_by(header.absoluteFilePath());
    for (const char* const extension : {".c", ".cpp", ".cc", ".cxx"}) {
      const QFileInfo source(header.absoluteDir(), header.completeBaseName() + extension);
      const QString path = source.absoluteFilePath();
      if (!source.isFile() || sources.contains(path)) continue;
      // A copy of an example goes by its name.
      if (source.fileName() == QFileInfo(file).fileName()) continue;
      sources << path;
      todo << included_by(path);
    }
  }
  return sources;
}

QString build_folder(const CodeSettings& settings, const QString& path) {
  const QByteArray hash = QCryptographicHash::hash(path.toUtf8(), QCryptographicHash::Sha1);
  constexpr int kLetters = 12;
  return QDir(settings.builds).filePath(QString::fromLatin1(hash.toHex().left(kLetters)));
}

QList<Step> plan_run(const ProgramSource& source, const RunChoice& choice,
                     const CodeSettings& settings) {
  const QFileInfo file(source.file);
  if (source.language == Language::Text || is_header(source.file)) return {};
  const QString home = source.home.isEmpty() ? file.absolutePath() : source.home;
  QStringList words{"run"};
  if (!choice.world.isEmpty()) words << "--world" << choice.world;
  if (choice.is_fast) words << "--fast";
  words << (choice.windows ? "--gui" : "--no-gui");
  if (source.language == Language::Python) {
    return {{Step::Kind::Run, settings.eyebridge, words << source.file, home}};
  }
  const QDir build(source.build.isEmpty() ? build_folder(settings, source.file) : source.build);
  const QString binary = build.filePath(file.completeBaseName());
  return {build_step(source, home, binary, settings),
          {Step::Kind::Run, settings.eyebridge, words << binary, home}};
}

}  // namespace eyebridge::gui
