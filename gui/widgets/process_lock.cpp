#include "widgets/process_lock.hpp"

namespace eyebridge::gui {

std::unique_ptr<QLockFile> take_lock(const QString& path) {
  auto lock = std::make_unique<QLockFile>(path);
  lock->setStaleLockTime(0);  // only the end of its process makes a lock stale, never its age
  if (!lock->tryLock(0)) return nullptr;
  return lock;
}

}  // namespace eyebridge::gui
