#pragma once

#include <QString>
#include <functional>

class QFileDialog;
class QWidget;

namespace eyebridge::gui {

// Dialogs that nobody waits for: windows go on, and what was chosen comes later, in the windows'
// thread. They belong to `window`, and are gone when they are closed.

/// For a file that is there, looked for in `folder` first; `filter` as QFileDialog has it.
QFileDialog& ask_for_file(QWidget& window, const QString& title, const QString& folder,
                          const QString& filter, std::function<void(const QString&)> chosen);

/// For where to save; `proposal` is a name, or a path.
QFileDialog& ask_where_to_save(QWidget& window, const QString& title, const QString& proposal,
                               const QString& filter, std::function<void(const QString&)> chosen);

}  // namespace eyebridge::gui
