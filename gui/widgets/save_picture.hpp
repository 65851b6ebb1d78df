#pragma once

#include <QImage>
#include <QString>
#include <functional>

class QWidget;

namespace eyebridge::gui {

/// Writes a picture, as PNG or whatever the name says; all of it, or the file stays as it was.
/// False when it cannot be written.
bool save_picture(const QImage& picture, const QString& path);

/// Asks a person for its path (ask_for_file.hpp) and tells it to `save`.
void ask_where_to_save_picture(QWidget& window, const QString& title, const QString& name,
                               std::function<void(const QString&)> save);

}  // namespace eyebridge::gui
