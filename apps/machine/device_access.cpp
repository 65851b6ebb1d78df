#include "device_access.hpp"

#include <algorithm>
#include <fstream>

#include <fmt/format.h>
#include <grp.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include "system_files.hpp"

namespace eyebridge::apps {
namespace {

namespace fs = std::filesystem;

bool has_name(std::string_view list, const std::string& wanted) {
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(','), list.size());
    if (list.substr(0, end) == wanted) return true;
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return false;
}

/// Whether /etc/group ("dialout:x:20:ann,bob") has this user in `group`.
bool is_member(const std::string& group, const fs::path& root) {
  const passwd* user = ::getpwuid(::geteuid());
  if (user == nullptr) return false;
  std::ifstream groups(below(root, "/etc/group"));
  for (std::string line; std::getline(groups, line);) {
    const std::size_t last = line.rfind(':');
    if (line.starts_with(group + ":") && last != std::string::npos) {
      return has_name(std::string_view(line).substr(last + 1), user->pw_name);
    }
  }
  return false;
}

}  // namespace

DeviceAccess access_of(const std::string& device, const fs::path& root) {
  DeviceAccess access;
  const fs::path node = below(root, device);
  struct stat status {};
  if (::stat(node.c_str(), &status) != 0) return access;
  const group* owner = ::getgrgid(status.st_gid);
  access.group = owner == nullptr ? std::to_string(status.st_gid) : owner->gr_name;
  access.group_may = (status.st_mode & S_IRGRP) != 0 && (status.st_mode & S_IWGRP) != 0;
  access.permitted = ::access(node.c_str(), R_OK | W_OK) == 0;
  access.in_group = is_member(access.group, root);
  return access;
}

std::string how_to_be_permitted(const DeviceAccess& access, const std::string& only_root) {
  if (!access.group_may || access.group == "root") return only_root;
  if (access.in_group) {
    return fmt::format("you are in the group {}, but this session is older: log out and in again",
                       access.group);
  }
  return fmt::format("join the group {0}: sudo usermod -aG {0} $USER; then log out and in again",
                     access.group);
}

}  // namespace eyebridge::apps
