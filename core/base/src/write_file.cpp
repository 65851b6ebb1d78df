#include "eyebridge/base/write_file.hpp"

#include <cerrno>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

#include "eyebridge/base/unique_fd.hpp"

namespace eyebridge {
namespace {

namespace fs = std::filesystem;

constexpr mode_t kUsualRights = 0666;  // less the user's mask

/// 0, or what errno says is wrong.
int write_there(const fs::path& path, std::string_view bytes) {
  UniqueFd file(
      ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOCTTY | O_CLOEXEC, kUsualRights));
  if (!file.valid()) return errno;
  while (!bytes.empty()) {
    const ssize_t count = ::write(file.get(), bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  // Some file systems say only now that their disk is full.
  return ::close(file.release()) == 0 ? 0 : errno;
}

}  // namespace

Result<void> write_file(const fs::path& path, std::string_view bytes) {
  std::error_code error;
  fs::path target = fs::weakly_canonical(path, error);
  if (error) target = path;
  const fs::file_status there = fs::status(target, error);
  const bool in_place = fs::exists(there) && !fs::is_regular_file(there);
  fs::path beside = target;
  if (!in_place) beside += '.' + std::to_string(getpid()) + ".part";
  error = {write_there(beside, bytes), std::generic_category()};
  std::error_code ignored;
  if (!in_place && !error) {
    if (fs::exists(there)) fs::permissions(beside, there.permissions(), ignored);
    fs::rename(beside, target, error);
  }
  if (!error) return {};
  if (!in_place) fs::remove(beside, ignored);
  return fail(Errc::Unsupported, "cannot be written: " + error.message());
}

}  // namespace eyebridge
