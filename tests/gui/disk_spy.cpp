#include "disk_spy.hpp"

#include <array>
#include <cerrno>
#include <mutex>
#include <string_view>

#include <sys/syscall.h>
#include <unistd.h>

namespace eyebridge::gui::testing {
namespace {

struct Seen {
  std::mutex mutex;
  std::string folder;  ///< "": nothing is looked at.
  std::thread::id owner;
  int own_syncs = 0;
  int other_syncs = 0;
  std::string refused;
};

Seen& seen() {
  static Seen all;
  return all;
}

/// The settings are written by Qt in between: those count for nobody.
void count_sync(int file) {
  std::array<char, 4096> name{};
  const std::string link = "/proc/self/fd/" + std::to_string(file);
  if (readlink(link.c_str(), name.data(), name.size() - 1) < 0) return;
  Seen& all = seen();
  const std::lock_guard lock(all.mutex);
  if (all.folder.empty() || !std::string_view(name.data()).starts_with(all.folder)) return;
  ++(std::this_thread::get_id() == all.owner ? all.own_syncs : all.other_syncs);
}

bool is_refused(const char* name) {
  Seen& all = seen();
  const std::lock_guard lock(all.mutex);
  const std::string_view all_of_it(name);
  return !all.folder.empty() && !all.refused.empty() && all_of_it.starts_with(all.folder) &&
         all_of_it.ends_with(all.refused);
}

}  // namespace

DiskSpy::DiskSpy(const std::string& folder) {
  const std::lock_guard lock(seen().mutex);
  seen().folder = folder;
  seen().owner = std::this_thread::get_id();
  seen().own_syncs = 0;
  seen().other_syncs = 0;
  seen().refused.clear();
}

DiskSpy::~DiskSpy() {
  const std::lock_guard lock(seen().mutex);
  seen().folder.clear();
}

int DiskSpy::own_syncs() const {
  const std::lock_guard lock(seen().mutex);
  return seen().own_syncs;
}

int DiskSpy::other_syncs() const {
  const std::lock_guard lock(seen().mutex);
  return seen().other_syncs;
}

void DiskSpy::refuse_name(const std::string& ending) {
  const std::lock_guard lock(seen().mutex);
  seen().refused = ending;
}

}  // namespace eyebridge::gui::testing

// Qt calls these instead of the C library's, because the program's own names come first.
extern "C" {

__attribute__((visibility("default"))) int fsync(int file) {
  eyebridge::gui::testing::count_sync(file);
  return static_cast<int>(syscall(SYS_fsync, file));
}

__attribute__((visibility("default"))) int fdatasync(int file) {
  eyebridge::gui::testing::count_sync(file);
  return static_cast<int>(syscall(SYS_fdatasync, file));
}

__attribute__((visibility("default"))) int rename(const char* from, const char* to) noexcept {
  if (eyebridge::gui::testing::is_refused(to)) {
    errno = ENOSPC;
    return -1;
  }
  return static_cast<int>(syscall(SYS_rename, from, to));
}
}
