#pragma once

#include <QString>
#include <QStringList>
#include <functional>

class QMenu;

namespace eyebridge::gui {

/// What was opened or saved last of one kind, the newest first; kept in the settings.
QStringList recent_files(const QString& kind);

/// `path` is the newest now; at most ten of a kind are kept.
void remember_file(const QString& kind, const QString& path);

/// `menu` offers, whenever it is opened, the recent files of all `kinds` that still exist: `open`
/// is told of the one that was chosen.
void offer_recent_files(QMenu& menu, const QStringList& kinds,
                        const std::function<void(const QString&)>& open);

/// Kinds.
inline const QString kRecentWorlds = "editor";
inline const QString kRecentPrograms = "code";

}  // namespace eyebridge::gui
