// An editor with unsaved edits that waits until somebody kills it: editor_victim [FILE]
#include <QApplication>

#include "editor/editor_window.hpp"
#include "editor/edits.hpp"

int main(int argc, char** argv) {
  const QApplication application(argc, argv);
  QApplication::setApplicationName("test_gui");  // whose state it shares
  eyebridge::gui::EditorWindow window(argc > 1 ? argv[1] : "");
  window.set_autosave_delay(0);
  window.document().edit("robot", [](eyebridge::gui::Plan& plan) {
    eyebridge::gui::add_robot(plan, "S4", {1.0, 1.5});
  });
  return QApplication::exec();
}
