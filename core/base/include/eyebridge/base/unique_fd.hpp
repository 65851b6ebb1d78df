#pragma once

#include <utility>

namespace eyebridge {

/// The one owner of a file descriptor: closes it when it goes. Moved, never copied.
class UniqueFd {
 public:
  /// Owns nothing.
  UniqueFd() = default;
  /// Takes over `fd`; a negative one, as failed system calls give, means none.
  explicit UniqueFd(int fd) : fd_(fd < 0 ? kNone : fd) {}
  UniqueFd(UniqueFd&& other) noexcept : fd_(other.release()) {}
  UniqueFd& operator=(UniqueFd&& other) noexcept {
    reset(other.release());
    return *this;
  }
  UniqueFd(const UniqueFd&) = delete;
  UniqueFd& operator=(const UniqueFd&) = delete;
  ~UniqueFd() { reset(); }

  /// The descriptor, lent; -1 when there is none.
  [[nodiscard]] int get() const { return fd_; }
  [[nodiscard]] bool valid() const { return fd_ != kNone; }
  /// Gives the descriptor up without closing it.
  [[nodiscard]] int release() { return std::exchange(fd_, kNone); }
  /// Closes what is owned, unless that is `fd` itself, and takes over `fd`. Keeps errno.
  void reset(int fd = -1) noexcept;

 private:
  static constexpr int kNone = -1;
  int fd_ = kNone;
};

}  // namespace eyebridge
