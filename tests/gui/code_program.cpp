// The code panel as a process, so that it can be killed: code_program DRAFTS [FILE ...]
#include <QApplication>

#include "code/code_window.hpp"

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  auto settings = eyebridge::gui::CodeSettings::defaults();
  QStringList files = QApplication::arguments().mid(1);
  settings.drafts = files.takeFirst();
  // A test may have a command of its own: with what Python needs in sanitized builds.
  settings.eyebridge = qEnvironmentVariable("EYEBRIDGE_TEST_COMMAND", settings.eyebridge);
  eyebridge::gui::CodeWindow window(files, settings);
  window.move(0, 0);
  window.show();
  return QApplication::exec();
}
