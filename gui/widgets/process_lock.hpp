#pragma once

#include <QLockFile>
#include <QString>
#include <memory>

namespace eyebridge::gui {

/// The lock in the file at `path`, held while this process and what is returned live; null where
/// another process holds it.
std::unique_ptr<QLockFile> take_lock(const QString& path);

}  // namespace eyebridge::gui
