#include "eyebridge/base/write_file.hpp"

#include <cerrno>
#include <random>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "eyebridge/base/unique_fd.hpp"

namespace eyebridge {
namespace {

namespace fs = std::filesystem;

constexpr mode_t kUsualRights = 0666;  // less the user's mask
constexpr int kAttempts = 16;

/// 0, or what errno says is wrong.
int write_to(UniqueFd file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(file.get(), bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  // Some file systems say only now that their disk is full.
  return ::close(file.release()) == 0 ? 0 : errno;
}

/// A new file beside `target`, with a random name, so that nobody can put a link there before.
UniqueFd open_beside(const fs::path& target, fs::path& beside) {
  std::random_device dice;
  for (int i = 0; i < kAttempts; ++i) {
    beside = target;
    beside += '.' + std::to_string(dice()) + ".part";
    UniqueFd file(
        ::open(beside.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, kUsualRights));
    if (file.valid() || errno != EEXIST) return file;
  }
  return {};
}

/// For pipes and devices. Does not wait for somebody to read a pipe.
Result<void> write_in_place(const fs::path& path, std::string_view bytes) {
  UniqueFd file(::open(path.c_str(), O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  if (file.valid()) ::fcntl(file.get(), F_SETFL, 0);
  const int wrong = file.valid() ? write_to(std::move(file), bytes) : errno;
  if (wrong == 0) return {};
  return fail(Errc::Unsupported, "cannot be written: " + std::generic_category().message(wrong));
}

}  // namespace

Result<void> write_file(const fs::path& path, std::string_view bytes) {
  std::error_code error;
  fs::path target = fs::weakly_canonical(path, error);
  if (error) target = path;
  const fs::file_status there = fs::status(target, error);
  if (fs::exists(there) && !fs::is_regular_file(there)) return write_in_place(target, bytes);
  fs::path beside;
  UniqueFd file = open_beside(target, beside);
  const bool is_made = file.valid();
  error = {is_made ? write_to(std::move(file), bytes) : errno, std::generic_category()};
  std::error_code ignored;
  if (!error) {
    if (fs::exists(there)) fs::permissions(beside, there.permissions(), ignored);
    fs::rename(beside, target, error);
  }
  if (!error) return {};
  if (is_made) fs::remove(beside, ignored);
  return fail(Errc::Unsupported, "cannot be written: " + error.message());
}

}  // namespace eyebridge
