#pragma once

#include <QByteArray>
#include <QString>

namespace eyebridge::gui {

/// Writes the bytes, all of them or none. Returns "" or why not, in the system's words.
QString write_whole(const QString& path, const QByteArray& bytes);

}  // namespace eyebridge::gui
