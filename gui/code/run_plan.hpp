#pragma once

#include <QList>
#include <QString>
#include <QStringList>

#include "code/code_settings.hpp"
#include "code/language.hpp"

namespace eyebridge::gui {

/// How a person wants a program to run.
struct RunChoice {
  QString world;         ///< Absolute path; "" is an empty room.
  bool is_fast = false;  ///< Virtual time.
  bool windows = true;   ///< Panel and environment.
};

/// A program as it is on disk.
struct ProgramSource {
  QString file;  ///< Absolute path. May be a copy: then `home` is not its folder.
  QString home;  ///< Where what it includes and reads is; "" is the file's folder.
  Language language = Language::C;
  bool is_classic = false;
  QString build;  ///< The folder that it is built in; "" is build_folder() of the file.
};

/// A process to start.
struct Step {
  enum class Kind { Build, Run };
  Kind kind;
  QString program;
  QStringList arguments;
  QString folder;  ///< Where it works.
};

/// What builds a program and runs it, one after the other: nothing to build for Python. For what is
/// no program (a header, a text) empty.
QList<Step> plan_run(const ProgramSource& source, const RunChoice& choice,
                     const CodeSettings& settings);

/// The sources to be compiled with `file`: for each header beside it that it includes, and those
/// that these include, the source of the same name.
QStringList other_sources(const QString& file, const QString& home);

/// The folder that a program of this path or name is built in; differs from that of any other path.
QString build_folder(const CodeSettings& settings, const QString& path);

}  // namespace eyebridge::gui
