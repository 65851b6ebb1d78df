#include "eyebridge/base/unique_fd.hpp"

#include <cerrno>
#include <utility>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace eyebridge {
namespace {

bool is_open(int fd) { return ::fcntl(fd, F_GETFD) != -1; }
int open_null() { return ::open("/dev/null", O_RDONLY | O_CLOEXEC); }

TEST(UniqueFd, OwnsNothingUnlessGivenSomething) {
  EXPECT_FALSE(UniqueFd().valid());
  EXPECT_FALSE(UniqueFd(-5).valid());
  EXPECT_EQ(UniqueFd(-5).get(), -1);
}

TEST(UniqueFd, ClosesWhatItOwnsAtTheEnd) {
  int raw = -1;
  {
    const UniqueFd fd(open_null());
    raw = fd.get();
    ASSERT_TRUE(fd.valid());
    ASSERT_TRUE(is_open(raw));
  }
  EXPECT_FALSE(is_open(raw));
}

TEST(UniqueFd, MovingHandsTheDescriptorOver) {
  UniqueFd from(open_null());
  const int raw = from.get();
  UniqueFd to(std::move(from));
  EXPECT_EQ(to.get(), raw);
  EXPECT_TRUE(is_open(raw));

  UniqueFd third(open_null());
  const int replaced = third.get();
  third = std::move(to);
  EXPECT_EQ(third.get(), raw);
  EXPECT_FALSE(is_open(replaced));
}

TEST(UniqueFd, MovingIntoItselfKeepsTheDescriptor) {
  UniqueFd fd(open_null());
  UniqueFd& same = fd;
  fd = std::move(same);
  EXPECT_TRUE(fd.valid());
  EXPECT_TRUE(is_open(fd.get()));
}

TEST(UniqueFd, ReleasingLeavesItOpen) {
  int raw = -1;
  {
    UniqueFd fd(open_null());
    raw = fd.release();
    EXPECT_FALSE(fd.valid());
  }
  EXPECT_TRUE(is_open(raw));
  ::close(raw);
}

TEST(UniqueFd, ClosingKeepsErrno) {
  UniqueFd fd(open_null());
  ::close(fd.get());  // so that closing again fails with EBADF
  errno = EAGAIN;
  fd.reset();
  EXPECT_EQ(errno, EAGAIN);
}

}  // namespace
}  // namespace eyebridge
