#include "v4l2/open_errors.hpp"

#include <cerrno>
#include <cstring>

#include <grp.h>
#include <sys/stat.h>

namespace eyebridge::camera {
namespace {

std::string reason_of(int number) {
  return std::string(std::strerror(number)) + " (errno " + std::to_string(number) + ")";
}

/// What to do against EACCES.
std::string permission_hint(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return "";
  const group* owner = ::getgrgid(status.st_gid);
  if (owner == nullptr || (status.st_mode & (S_IRGRP | S_IWGRP)) != (S_IRGRP | S_IWGRP)) return "";
  const std::string name = owner->gr_name;
  return ": it belongs to the group " + name + "; sudo usermod -aG " + name +
         " $USER, then log out and in again";
}

}  // namespace

ConfigError camera_error(const std::string& path, const std::string& text) {
  return {{"--camera"}, path + ": " + text};
}

ConfigError open_error(const std::string& path, int number) {
  switch (number) {
    case EACCES:
    case EPERM:
      return camera_error(path, "not permitted" + permission_hint(path));
    case EBUSY:
      return call_error(path, "opening it", number);
    case ENOENT:
    case ENODEV:
    case ENXIO:
      return camera_error(path,
                          "there is no such camera; `eyebridge camera list` shows those there "
                          "are");
    default:
      return camera_error(path, "cannot be opened: " + reason_of(number));
  }
}

ConfigError call_error(const std::string& path, const std::string& what, int number) {
  if (number == EBUSY) {
    return camera_error(path,
                        "is in use by another program; `eyebridge camera list` shows by "
                        "which");
  }
  return camera_error(path, what + " failed: " + reason_of(number));
}

}  // namespace eyebridge::camera
