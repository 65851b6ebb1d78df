#include "holders.hpp"

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

namespace eyebridge::apps {
namespace {

namespace fs = std::filesystem;

bool has_open(int process, const std::string& path, const fs::path& root) {
  const fs::path folder = below(root, "/proc") / std::to_string(process) / "fd";
  for (const std::string& name : names_in(folder)) {
    std::error_code error;
    if (fs::read_symlink(folder / name, error) == path && !error) return true;
  }
  return false;
}

/// Processes in /proc/locks whose line ends in this file: "1: FLOCK ADVISORY WRITE 812 00:05:88 …".
std::set<int> lockers_of(const std::string& device, const fs::path& root) {
  struct stat file {};
  if (::stat(below(root, device).c_str(), &file) != 0) return {};
  const std::string wanted =
      fmt::format("{:02x}:{:02x}:{}", major(file.st_dev), minor(file.st_dev), file.st_ino);
  std::set<int> out;
  std::ifstream locks(below(root, "/proc/locks"));
  for (std::string line; std::getline(locks, line);) {
    if (line.find("->") != std::string::npos) continue;  // who waits for a lock holds nothing
    std::istringstream words(line);
    std::string number, kind, advisory, access, where;
    int process = 0;
    if (words >> number >> kind >> advisory >> access >> process >> where && where == wanted) {
      out.insert(process);
    }
  }
  return out;
}

}  // namespace

std::string without_links(const std::string& device, const fs::path& root) {
  std::error_code error;
  const fs::path real = fs::weakly_canonical(below(root, device), error);
  if (error) return device;
  const fs::path base = fs::weakly_canonical(root, error);
  return error ? device : "/" + real.lexically_relative(base).string();
}

std::vector<Process> holders_of(const std::string& device, const fs::path& root) {
  const std::string path = without_links(device, root);
  std::set<int> lockers = lockers_of(device, root);
  std::vector<Process> out;
  for (Process& process : processes(root)) {
    const bool locks = lockers.erase(process.id) != 0;
    if (process.id == ::getpid()) continue;
    if (locks || has_open(process.id, path, root)) out.push_back(std::move(process));
  }
  lockers.erase(::getpid());
  for (const int unseen : lockers) out.push_back({std::max(unseen, 0), ""});
  return out;
}

std::string listed(const std::vector<Process>& holders) {
  std::string out;
  for (std::size_t i = 0; i < holders.size(); ++i) {
    if (i > 0) out += i + 1 == holders.size() ? " and " : ", ";
    out += described(holders[i]);
  }
  return out;
}

}  // namespace eyebridge::apps
